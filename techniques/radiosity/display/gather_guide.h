// From where the light at a patch comes: where it comes from few places, a gather sends rays to these on purpose.
//
// Rays that leave a point in all directions seldom meet a small bright patch, such as a lamp's, or the sun's on a floor, and what they bring is then
// noise. But the solution knows how much each patch sends to each other: F_ij B_j. So as many rays go to points of patches that are chosen
// in proportion to that (as paths in H. W. Jensen, "Importance Driven Path Tracing Using the Photon Map", Eurographics Workshop on Rendering 1995, go
// where photons came from), and both kinds are weighed by how likely each is to find a point (E. Veach and L. Guibas, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", SIGGRAPH 1995: the balance heuristic).
// Within a patch, points are chosen in proportion to the direct light of its cells (patch_cells.h), as its mean says nothing of the edge of a spot on it. Patches
// of a simplified mesh lie beside the surface that rays meet: there rays to the mesh itself are chosen (mesh_aim.h).
// Where light comes from all sides, rays in all directions find it well enough, and none is chosen. And under the open sky only what patches emit is
// found on purpose: what they reflect is little there, and while rays do not depend on the lights, pictures by each of them add up to that by all to
// the last bit. In rooms they add up but for noise.
// Simplified: a point uses the shares of the whole patch on which it lies. That does not make the mean wrong: all points can be met by chance.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "techniques/radiosity/display/mesh_aim.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

/// The density of a direction, 1/sr, in which one sees a point, from that of the point on its surface, 1/m^2.
double densityOfDirection(double density, double distance, double cosineThere);

/// Nearer than that is contact, metres.
inline constexpr double kContactDistance = 1e-9;

class GatherGuide {
public:
    /// Chooses nothing.
    GatherGuide() = default;
    /// `radiosity`: of each of Room::allPatches(), W/m^2. `outside`: radiance where a patch sees no surface. The cache must outlive this object.
    GatherGuide(const RoomCache& cache, const Sources& sources, std::span<const dvec3> radiosity, const dvec3& outside);

    // Patches are numbered as in Room::allPatches(). `at`: on which patch the light arrives.

    /// Does the light there come from few places, so that rays to them are worth choosing?
    [[nodiscard]] bool isUneven(std::uint32_t at) const { return at < upTo_.size() && !upTo_[at].empty(); }

    /// A ray.
    struct Way {
        dvec3 direction{0.0};               ///< unit
        double density = 0;                 ///< with which this direction is chosen, 1/sr
        double distance = 0;                ///< to the chosen point, metres
        std::optional<std::uint32_t> object; ///< into spheres around that object: its mesh may be met anywhere on the way
    };
    /// Where isUneven(). `which` and `where`: of the unit interval and the unit square, evenly distributed. Nothing: from there what was chosen is not seen.
    [[nodiscard]] std::optional<Way> choose(std::uint32_t at, const dvec3& fromWorld, double which, const dvec2& where) const;
    /// What a ray in any direction has met.
    struct Found {
        std::uint32_t patch = 0;
        double distance = 0, cosineThere = 0; ///< metres; of the ray and the normal there
        std::uint32_t triangleInMesh = 0;     ///< of the object's own mesh
    };
    /// Where isUneven(): the density with which that direction is chosen such that this is met, 1/sr; 0: never.
    [[nodiscard]] double density(std::uint32_t at, const dvec3& fromWorld, const dvec3& direction, const Found& found) const;

private:
    /// A simplified one that is bright.
    struct Mesh {
        std::uint32_t object;
        const MeshAim* aim;
        std::uint32_t first;  ///< of its groups, as a target
        double reflected = 0; ///< MeshAim::likely
    };
    /// Where on a patch the light of lights arrives, and light that is followed along paths, if not alike everywhere.
    struct Spread {
        PatchCells cells;
        PatchCells::Shares upTo;
        double share; ///< so many points are chosen by it, the others alike everywhere
    };
    [[nodiscard]] static std::optional<Spread> spreadOf(const RoomCache& cache, const Sources& sources, std::uint32_t patch, double sent);
    void addMesh(const RoomCache& cache, std::uint32_t object, std::span<const double> sent);
    void shareOut(std::uint32_t at, const Mesh& mesh, std::span<double> targets) const;
    [[nodiscard]] const Mesh* meshOf(std::uint32_t target) const;
    [[nodiscard]] bool isOpen(std::uint32_t at) const;
    [[nodiscard]] const Spread* spread(std::uint32_t at, std::uint32_t patch) const;
    [[nodiscard]] double share(std::uint32_t at, std::uint32_t target) const;
    [[nodiscard]] double densityOfPoint(std::uint32_t at, std::uint32_t patch, const dvec3& positionWorld) const;

    const Room* room_ = nullptr;
    std::vector<std::optional<Spread>> spreads_; ///< of each of Room::patches()
    std::vector<Mesh> meshes_;
    /// Of each of Room::allPatches(): what is chosen where it would be: the patch, or any target of a mesh; kNone: nothing. Targets are Room::patches(), and after
    /// these the groups of all meshes_.
    std::vector<std::uint32_t> targets_;
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    /// Of each patch: the share of its light that comes from each of the targets and those before it; empty where it is not uneven.
    std::vector<std::vector<float>> upTo_;
};

} // namespace shadowlab::radiosity
