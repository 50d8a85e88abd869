// The objects of a glTF file and their keys, as far as this program reads them: the specification's schema as tables.
// Source: Khronos Group, "glTF 2.0 Specification", 2021, and the specifications of the extensions named in gltf_schema.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <span>
#include <string_view>

namespace shadowlab::scene {

struct GltfKey {
    enum class Kind {
        flag,       ///< true or false
        number,     ///< any number
        share,      ///< number or array of them, clamped to `least` and `most` with a note
        integer,    ///< a whole number
        text,       ///< a string
        reference,  ///< index into the array `of`
        references, ///< array of such indices
        numbers,    ///< array of `count` numbers
        object,     ///< of `schema`
        objects,    ///< array of them
        attributes, ///< an object whose values are indices into the array `of`
        extensions, ///< an object whose keys are extensions; those in `schema` are read
        ignored,    ///< anything
    };
    std::string_view name;
    Kind kind = Kind::ignored;
    bool isRequired = false;
    std::string_view of{}; ///< of references: an array's name; of texts and integers: the allowed ones, "A|B"
    std::span<const GltfKey> schema{};
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    int multipleOf = 1;
    std::string_view note{}; ///< where it is not shown: what to say of it
    bool isPassedOn = true;  ///< to tinygltf
};

/// The keys of the whole file.
std::span<const GltfKey> gltfSchema();

/// Can a file that requires this extension be shown?
bool isServedExtension(std::string_view name);

} // namespace shadowlab::scene
