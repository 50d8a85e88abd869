// What the patches of a room see: the share that is no surface, and whether there is anything to see at all. Those that see nothing are left out.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/radiosity/room/room.h"
#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// Patches are cut at contacts, so all of a patch lies inside a body or outside, but for rounding. Where they are not cut, a patch
// that is half outside is kept.
constexpr double kCovered = 0.95;

// In a simplified mesh, surfaces nearer than this share of a cell were moved together by simplification: two walls, two leaves.
// Patches that see hardly anything else lie in a fold that the original mesh does not have.
constexpr double kFold = 0.5, kNothingElse = 0.9;

/// For each side those that are seen in its place where they overlap (scene/query/coincident/coincident_faces.h); empty: nothing coincides.
std::vector<std::vector<std::uint32_t>> sidesOver(const Sides& sides, const scene::Scene& scene, const trace::WorldTriangles& world) {
    const scene::CoincidentFaces coincident(scene);
    std::vector<std::vector<std::uint32_t>> over(coincident.isEmpty() ? 0 : sides.faces.all.size());
    for (const auto& [triangle, other, faceAlike, gap] : coincident.pairs())
        for (const bool isFront : {true, false}) { // as the meshes have it
            const auto sideOf = [&](std::uint32_t t, bool isFrontOfMesh) {
                const bool isFrontInWorld = isFrontOfMesh != scene::isMirrored(scene.objects[world.objects[t]]);
                return (isFrontInWorld ? sides.faces.ofTriangle : sides.backOfTriangle)[t];
            };
            const bool isOthersFront = isFront == faceAlike;
            const std::uint32_t own = sideOf(triangle, isFront), others = sideOf(other, isOthersFront);
            if (own == kNoFace || others == kNoFace || own == others) continue;
            if (coincident.rank(triangle, isFront) < coincident.rank(other, isOthersFront)) over[own].push_back(others);
        }
    return over;
}

} // namespace

void Room::sampleSurroundings(std::size_t patch) {
    const std::uint32_t object = faceOf(patches_[patch]).object;
    const bool isCoarse = isSimplified(object);
    const HemisphereShares seen =
        sampleHemisphere(tracer_, *bodies_, patches_[patch], object, isCoarse ? kFold * simple_->cellMetres : 0);
    surroundings_[patch] = seen.nothing;
    inBodies_[patch] = seen.inBodies;
    folded_[patch] = seen.folds;
}

/// As in a room with a window, whose walls may have outsides as well. Under the open sky what brings so little light to a patch is lost beside the rest.
bool Room::seesLittleOfOutside() const {
    constexpr double kLittle = 0.1, kMost = 0.5;
    const MeanView all = meanView(1);
    return all.share > 0 && meanView(kLittle).area > kMost * all.area;
}

Room::MeanView Room::meanView(double most) const {
    MeanView view;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        if (surroundings_[i] > most) continue;
        view.share += patches_[i].area * surroundings_[i];
        view.area += patches_[i].area;
    }
    if (view.area > 0) view.share /= view.area;
    return view;
}

void Room::sampleWindows(std::size_t patch) {
    if (looksForWindows_ && surroundings_[patch] == 0 && inBodies_[patch] <= kCovered)
        surroundings_[patch] = smallView(tracer_, patches_[patch]);
}

void Room::leaveOutCovered() {
    std::size_t kept = 0;
    const std::vector<std::vector<std::uint32_t>> over = sidesOver(sides_, *simple_->scene, world_);
    const auto fold = [&](const Patch& patch) {
        if (isOutsideOfSimplified(patch)) foldedAreas_[{faceOf(patch).object, partOf(patch)}] += patch.area;
    };
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const auto covers = [&](std::uint32_t side) {
            return holds(sides_.faces.all[side].polygon, patches_[i].centre, patches_[i].normal);
        };
        const auto coversItself = [&](std::uint32_t side) { return covers(side) && sides_.faces.all[side].object == faceOf(patches_[i]).object; };
        if (inBodies_[i] > kCovered || (!over.empty() && std::ranges::any_of(over[patches_[i].face], covers))) {
            if (inBodies_[i] <= kCovered && std::ranges::any_of(over[patches_[i].face], coversItself)) fold(patches_[i]);
            ++coveredPatches_;
            continue;
        }
        if (settings_.leavesOutFolds && surroundings_[i] == 0 && folded_[i] > kNothingElse) {
            fold(patches_[i]);
            ++foldedPatches_;
            continue;
        }
        patches_[kept] = patches_[i];
        surroundings_[kept] = surroundings_[i];
        ++kept;
    }
    patches_.resize(kept);
    surroundings_.resize(kept);
    loosePatches_ = allPatches_.size();
    allPatches_.insert(allPatches_.begin(), patches_.begin(), patches_.end());
    levels_.assign(patches_.size(), 0);
    findFollowed();
}

} // namespace shadowlab::radiosity
