// Emitters that lie in another face: a lamp let into a ceiling, both at one height.
//
// Two surfaces at one place would be seen in patches, as rounding has it. The rule for an eye, the same for rays and for the
// rasteriser: an emitter that shines toward the eye is seen, and whole, the surface of a light before other emitters. An
// emitter that does not shine toward the eye gives way to the face in which it lies. Of two alike the first in the scene is seen, as
// everywhere where surfaces are at one depth.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

class EmitterContacts {
public:
    EmitterContacts() = default;
    /// Finds them. Faces lie in one plane if the rounding of their floats explains the difference; those that share no more than an
    /// edge do not count, nor do faces of the same part of one mesh.
    explicit EmitterContacts(const Scene& scene);
    /// Are they the same in the other scene? Lights alone may then differ.
    [[nodiscard]] static bool areThoseOf(const Scene& scene, const Scene& other) {
        const Revisions &a = scene.revisions, &b = other.revisions;
        return a.geometry == b.geometry && a.transforms == b.transforms && a.materials == b.materials;
    }

    [[nodiscard]] bool isEmpty() const { return pairs_.empty(); }
    /// Triangles are counted through all objects. Is it an emitter in a face, or a face with an emitter in it?
    [[nodiscard]] bool touches(std::uint32_t triangle) const { return !flags_.empty() && flags_[triangle]; }
    /// The triangles that share a place with this one, without itself.
    [[nodiscard]] std::vector<std::uint32_t> of(std::uint32_t triangle) const;
    /// Does the part of the object hold an emitter that lies in a face?
    [[nodiscard]] bool isEmitterInFace(std::size_t object, std::size_t part) const {
        return !emitterParts_.empty() && emitterParts_[firstPartOfObject_[object] + part];
    }
    /// Does any part of it?
    [[nodiscard]] bool hasEmitterInFace(std::size_t object) const;

private:
    struct Pair {
        std::uint32_t triangle, other;
        auto operator<=>(const Pair&) const = default;
    };
    std::vector<Pair> pairs_; ///< sorted, each in both orders
    std::vector<bool> flags_; ///< per triangle; empty: none
    std::vector<bool> emitterParts_;
    std::vector<std::size_t> firstPartOfObject_; ///< one more than objects
};

/// A triangle at a place that an eye looks at. The highest rank is seen, of equal ones the lowest number.
struct SeenTriangle {
    std::uint32_t number;
    int rank;
};

/// Of a side of a triangle of that object and material.
int rankInContact(const Object& object, const Material& material, bool isFront);

/// Which of the triangles at one place is seen.
std::uint32_t seenOf(std::span<const SeenTriangle> together);

} // namespace shadowlab::scene
