// Surfaces close to what shines by itself.
//
// A lamp that glows 15 cm below a ceiling lights a small part of it, and takes back much of what that part reflects. One value for a patch that is larger
// spreads the light over all of the patch, and the room is too bright. So what lies close to such a lamp is cut by its distance, however large the patches
// are elsewhere (the same grading as of a wide ground, patches/ground.h). Where even that is too coarse, light is followed along paths.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <span>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/room/sides.h"

namespace shadowlab::radiosity {

/// Does the patch lie closer to a body than it is large, or than `reach` metres, and before a part of it that shines at it, if nothing stands between them? `fronts`: the
/// planes of what shines; none: it shines to all sides.
bool isInGap(const Patch& patch, const trace::CentredBox& body, std::span<const Plane> fronts, double reach = 0);

class NearEmitters {
public:
    /// The arguments must outlive this object.
    NearEmitters(const trace::SceneTracer& tracer, const Sides& sides);

    /// The parts of the sides that exchange light, divided where they are close to what emits and see it. `parts`: those before, where there are any. `scale`: 1;
    /// larger where pieces must be fewer. Nothing: nothing is close, or more than `most` pieces would be added.
    [[nodiscard]] std::optional<FaceParts> divided(const FaceParts& parts, double scale, std::size_t most) const;

    /// Of an object: has its mesh been simplified?
    using IsSimplified = std::function<bool(std::uint32_t object)>;
    /// For each patch 1 if light of emitters is followed from there along paths (lights/path_light.h), else 0. It is where one radiosity for a patch would be wrong:
    /// where a patch lies closer to an emitter that shines at it than it is large, on such an emitter, and on one with a simplified mesh.
    [[nodiscard]] std::vector<std::uint8_t> followed(std::span<const Patch> patches, const IsSimplified& isSimplified) const;

private:
    /// What glows of an object.
    struct Emitter {
        std::uint32_t object = 0;
        trace::CentredBox box;
        std::vector<Plane> planes; ///< of its faces
    };
    void divide(const Patch& piece, double scale, int doublings, std::vector<FacePart>& parts) const;
    [[nodiscard]] std::uint32_t objectOf(const Patch& patch) const { return sides_.faces.all[patch.face].object; }
    [[nodiscard]] bool sees(const Patch& piece, const Emitter& emitter) const;

    const trace::SceneTracer& tracer_;
    const Sides& sides_;
    std::vector<Emitter> emitters_; ///< in the order of their objects, as faces are; none where much of the scene glows
};

} // namespace shadowlab::radiosity
