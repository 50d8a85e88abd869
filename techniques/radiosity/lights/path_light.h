// Light of emitters that is followed along paths, where one radiosity for a patch would be wrong.
//
// A panel hangs 3 cm before a wall and shines at it. The wall sends light back to the panel, and the panel to the wall; only what is reflected near the panel's
// outline gets out, and there the wall is much darker than behind the panel's middle. One radiosity for a patch that is wider than the gap is a mean over both:
// the room would be a tenth too bright. So it is behind a lamp. And a ring that has been simplified to a few dozen triangles shines more to one side than it should. So what such an emitter
// sends is followed until it meets a patch that is neither close to it nor its own (S. N. Pattanaik and S. P. Mudur, "Computation of Global Illumination by Monte
// Carlo Simulation of the Particle Model of Light", Eurographics Workshop on Rendering 1992). There it is irradiance, as direct light is, and the equations have
// the rest. Patches in the gap are cut into many small cells, which remember what arrived: a gather ray that ends there finds the light of that place.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <optional>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/display/surface_cells.h"
#include "techniques/radiosity/patches/patch_cells.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// Whose light is followed: 1 for each of Room::patches() and of the scene's lights, or 0. A light is if a patch lies in a gap beside it.
struct Followed {
    std::vector<std::uint8_t> patches, lights;
    [[nodiscard]] bool hasPatch(std::size_t patch) const { return patch < patches.size() && patches[patch] != 0; }
    [[nodiscard]] bool any() const;
    friend bool operator==(const Followed&, const Followed&) = default;
};

/// What light that is followed brings, W/m^2.
struct PathLight {
    /// To each of Room::patches(), by light that was reflected at least once, and only by patches that are followed; and by that which comes
    /// straight from emitters with simplified meshes. (What comes straight from others, form factors know without noise, and what comes straight from lights is direct light.)
    std::vector<dvec3> irradiance;
    /// The cells of each of the same; only patches have some that are followed and lie on the surface that is drawn.
    std::vector<std::optional<PatchCells>> cells;
    std::vector<std::uint32_t> firstCell; ///< of each patch, in the next
    /// To each cell, by all that the emitters and what they light beside them send there, but for what comes straight from lights.
    std::vector<vec3> ofCells;

    [[nodiscard]] bool isEmpty() const { return irradiance.empty(); }
    [[nodiscard]] bool hasCells(std::uint32_t patch) const { return patch < cells.size() && cells[patch]; }
    /// At that point of a patch with cells.
    [[nodiscard]] dvec3 at(std::uint32_t patch, const dvec3& positionCentred) const;
};

class PathLightBuilder {
public:
    /// All must outlive this object. `drawn`: the scene as it is drawn, to which the cells belong.
    PathLightBuilder(const Room& room, const SurfaceCells& cells, const scene::Snapshot& drawn, const Followed& followed);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on deadlines or on the number
    /// of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    [[nodiscard]] PathLight take();

private:
    /// A side of a triangle.
    struct Emitter {
        trace::SurfacePoint middle;
        dvec3 watts{0.0};
        bool isSimplified = false, isLight = false;
        double upTo = 0; ///< the luminance of what it and those before it send, W
    };
    void findEmitters();
    void add(const trace::SurfacePoint& middle, const dvec3& radiosity, bool isSimplified, bool isLight);
    void prepareCells();
    void follow(std::size_t piece);
    void merge(std::size_t piece);
    [[nodiscard]] std::vector<dvec3> irradianceOf(const std::vector<dvec3>& watts) const;

    const Room& room_;
    const SurfaceCells& cells_;
    const Followed& followed_;
    scene::Snapshot drawn_;
    trace::SceneTracer tracer_;
    bool isPrepared_ = false;
    std::vector<Emitter> emitters_;
    /// What a piece of the work has found, W: at patches, and at cells.
    struct Arriving {
        std::vector<dvec3> atPatches;
        std::vector<vec3> atCells;
    };
    std::vector<Arriving> pieces_;
    PathLight found_; ///< in watts until it is taken
    std::size_t nextPiece_ = 0;
};

} // namespace shadowlab::radiosity
