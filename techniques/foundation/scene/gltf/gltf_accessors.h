// Numbers in the buffers of a glTF file, as its accessors describe them: any component type, with strides, normalized and sparse.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string_view>

#include "techniques/foundation/scene/gltf/gltf_model.h"

namespace shadowlab::scene {

/// Checks that every view lies in its buffer, every accessor in its view, and the indices of sparse ones in their accessor.
/// Throws Error (badInput) at the first that does not.
void checkGltfAccessors(const GltfSource& source, const tinygltf::Model& model, const GltfBuffers& buffers);

/// Elements of a checked accessor, read one by one: nothing is copied.
class GltfAccessor {
public:
    GltfAccessor(const tinygltf::Model& model, const GltfBuffers& buffers, int accessor);

    [[nodiscard]] std::size_t count() const { return accessor_->count; }
    [[nodiscard]] int components() const { return components_; }
    [[nodiscard]] int componentType() const { return accessor_->componentType; }

    /// A component of an element. Integers that are marked `normalized`, or all where `asShares`, stand for 0 to 1 (-1 to 1).
    [[nodiscard]] double at(std::size_t element, int component, bool asShares = false) const;

private:
    [[nodiscard]] const char* elementAt(std::size_t element) const;

    const tinygltf::Accessor* accessor_;
    int components_;
    std::size_t componentBytes_, stride_;
    std::string_view bytes_;                        ///< from the first element on; empty: all are zero
    std::string_view sparseIndices_, sparseValues_; ///< from their first on
};

/// Bytes of a component of that type.
std::size_t bytesOfComponent(int componentType);

} // namespace shadowlab::scene
