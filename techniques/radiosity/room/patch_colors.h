// The mean reflectance of a patch whose surface has not the same colour all over: an image is laid on it, or its vertices have colours.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

class PatchColors {
public:
    /// Of the scene itself, not of the simplified one: that has no texture coordinates.
    explicit PatchColors(const scene::Scene& scene);

    /// Mean diffuse reflectance over the patch, in centred space about `originWorld`, of an object. The colour of each of some dozen
    /// places on it is that of the object's surface straight below or above, at most `reach` metres away: so far simplification may
    /// have moved the patch. `otherwise` where there is none.
    [[nodiscard]] dvec3 mean(const Patch& patch, const dvec3& originWorld, std::uint32_t object, double reach,
                             const dvec3& otherwise) const;
    /// Has the object surfaces that are not of the same colour all over?
    [[nodiscard]] bool has(std::uint32_t object) const { return ownColors_[object]; }

private:
    [[nodiscard]] dvec3 at(const dvec3& centred, const dvec3& normal, std::uint32_t object, double reach, const dvec3& otherwise) const;
    scene::Snapshot scene_;
    trace::SceneTracer tracer_;
    std::vector<bool> ownColors_; ///< per object
};

} // namespace shadowlab::radiosity
