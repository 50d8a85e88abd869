// Light of emitters that is followed along paths, where one radiosity for a patch would be wrong.
//
// A panel hangs 3 cm before a wall and shines at it. The wall sends light back to the panel, and the panel to the wall; only what is reflected near the panel's
// outline gets out, and there the wall is much darker than behind the panel's middle. One radiosity for a patch that is wider than the gap is a mean over both:
// the room would be a tenth too bright. A lamp takes back as much, which in the equations passes through it. And a ring that has been simplified to a few dozen triangles shines more to one side than it should. So what such an emitter
// sends is followed until it meets a patch that is neither close to it nor its own (S. N. Pattanaik and S. P. Mudur, "Computation of Global Illumination by Monte
// Carlo Simulation of the Particle Model of Light", Eurographics Workshop on Rendering 1992). There it is irradiance, as direct light is, and the equations have
// the rest.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/display/surface_cells.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// Whose light is followed: 1 for each of Room::patches() and of the scene's lights, or 0. A light is if a patch lies in a gap beside it.
struct Followed {
    std::vector<std::uint8_t> patches, lights;
    [[nodiscard]] bool hasPatch(std::size_t patch) const { return patch < patches.size() && patches[patch] != 0; }
    [[nodiscard]] bool any() const;
    friend bool operator==(const Followed&, const Followed&) = default;
};

class PathLightBuilder {
public:
    /// All must outlive this object. `drawn`: the scene as it is drawn, to which the cells belong.
    PathLightBuilder(const Room& room, const SurfaceCells& cells, const scene::Snapshot& drawn, const Followed& followed);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on deadlines or on the number
    /// of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// The irradiance of each of Room::patches(), W/m^2, by light that was reflected at least once, and only by patches that are followed; and by that which comes
    /// straight from emitters with simplified meshes. (What comes straight from others, form factors know without noise, and what comes straight from lights is direct light.)
    [[nodiscard]] std::vector<dvec3> take() const;

private:
    /// A side of a triangle.
    struct Emitter {
        trace::SurfacePoint middle;
        dvec3 watts{0.0};
        bool isSimplified = false;
        double upTo = 0; ///< the luminance of what it and those before it send, W
    };
    void findEmitters();
    void add(const trace::SurfacePoint& middle, const dvec3& radiosity, bool isSimplified);
    void follow(std::size_t piece);

    const Room& room_;
    const SurfaceCells& cells_;
    const Followed& followed_;
    scene::Snapshot drawn_;
    trace::SceneTracer tracer_;
    bool hasEmitters_ = false;
    std::vector<Emitter> emitters_;
    std::vector<std::vector<dvec3>> watts_; ///< what arrives at each patch, by pieces of the work
    std::size_t nextPiece_ = 0;
};

} // namespace shadowlab::radiosity
