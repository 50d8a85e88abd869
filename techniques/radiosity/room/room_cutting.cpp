// The sides of a room cut into patches, as many as the budget holds.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "techniques/radiosity/room/near_emitters.h"
#include "techniques/radiosity/room/patch_memory.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

namespace {

// Where contacts cut so much that patches exceed the budget, meshes are simplified further, so often at most.
constexpr int kMostSimplifications = 4;

} // namespace

void Room::cut() {
    sides_ = sidesOf(*simple_->scene, world_, plain_, settings_.lightWithin);
    bodies_.emplace(*bvh_, world_, sides_.isClosed);
    Faces loose;
    exchangingFaces_ = {.all = {}, .ofTriangle = sides_.faces.ofTriangle};
    for (std::size_t i = 0; i < sides_.faces.all.size(); ++i)
        (i < sides_.exchanging ? exchangingFaces_ : loose).all.push_back(sides_.faces.all[i]);
    requireMemory(scene_, exchangingFaces_.all.size()); // each is at least one patch, and more where they touch
    ground_ = settings_.coarsensGround ? Ground(exchangingFaces_) : Ground();
    importance_ = importanceTo(eye_);
    const double size = cutByWhatMatters();
    requireMemory(scene_, patches_.size());
    // Loose sides may be very large compared with the rest of the scene (the underside of a ground plane), so they may be cut
    // more coarsely.
    const double sizeOfLoose = std::max(size, sizeForBudget(loose, settings_.patches));
    allPatches_ = cutIntoPatches(loose, sizeOfLoose); // only the loose ones so far
    for (Patch& patch : allPatches_)
        patch.face += static_cast<std::uint32_t>(sides_.exchanging);
    surroundings_.resize(patches_.size());
    inBodies_.resize(patches_.size());
    folded_.resize(patches_.size());
}

/// True: the patches exceed the budget, and the scene has meshes that can be simplified further.
bool Room::simplifiesFurther() {
    const std::size_t count = patches_.size();
    const bool canBeSimplified = std::ranges::any_of(simple_->cornersOfObject, [](const auto& corners) { return !corners.empty(); });
    if (count <= settings_.patches || !canBeSimplified || simplifications_ == kMostSimplifications) return false;
    mostSides_ = mostSides_ * settings_.patches / count;
    return true;
}

double Room::cutByWhatMatters() {
    // So much of the budget may go into what lies close to emitters, and pieces there may be so many times as large before that is given up.
    constexpr std::size_t kShareNearEmitters = 3;
    constexpr double kLargest = 4;
    double size = 0;
    const auto fits = [&](const FaceParts& parts) {
        size = cutWithinBudget(parts);
        return patches_.size() <= settings_.patches;
    };
    const NearEmitters emitters(tracer_, sides_);
    const auto fitsNearEmitters = [&](const FaceParts& parts) {
        for (double scale = 1; settings_.dividesNearEmitters && scale <= kLargest; scale *= 2)
            if (const auto divided = emitters.divided(parts, scale, settings_.patches / kShareNearEmitters); divided && fits(*divided)) return true;
        return fits(parts);
    };
    // Faces that are divided may be too many for the budget where whole ones are not. Then they are cut alike.
    usesImportance_ = !importance_.parts().empty() && fitsNearEmitters(importance_.parts());
    if (!usesImportance_) fitsNearEmitters({});
    return size;
}

double Room::cutWithinBudget(const FaceParts& parts) {
    // How many patches contacts add, and how many are covered, is known only after cutting: the number of pieces is then corrected, a few times.
    constexpr int kTries = 6, kMostPerPatch = 8;
    constexpr double kFilled = 0.85; // of the budget: sizes go in steps, and a step is up to an eighth of all patches
    const std::size_t most = settings_.patches;
    Cut best;
    std::size_t pieces = most, tooMany = kMostPerPatch * most;
    for (int i = 0; i <= kTries; ++i) {
        Cut cut = cutInto(pieces, parts);
        const std::size_t count = cut.patches.size(), ofBest = best.patches.size();
        const bool fits = count <= most;
        if (i == 0 || (fits ? ofBest > most || count > ofBest : count < ofBest)) best = std::move(cut);
        if (count == 0 || pieces == 0 || (fits && static_cast<double>(count) >= kFilled * static_cast<double>(most))) break;
        if (!fits) tooMany = std::min(tooMany, pieces);
        const std::size_t wanted = pieces * most / count;
        const std::size_t next = !fits ? std::min(pieces - 1, wanted) : wanted < tooMany ? wanted : (pieces + tooMany) / 2;
        if (next == pieces) break;
        pieces = next;
    }
    patches_ = std::move(best.patches);
    coveredPatches_ = best.covered;
    return best.size;
}

/// Into about so many pieces, before contacts divide them.
Room::Cut Room::cutInto(std::size_t pieces, const FaceParts& parts) const {
    Cut cut{.size = sizeForBudget(exchangingFaces_, pieces, ground_, parts)};
    cut.patches = cutIntoPatches(exchangingFaces_, cut.size, ground_, parts);
    if (settings_.cutsAtContacts) cut.patches = cutAtContacts(exchangingFaces_, std::move(cut.patches));
    cut.covered = std::erase_if(cut.patches, [&](const Patch& patch) { return isCovered(patch); });
    return cut;
}

/// Do all of some points on it lie in closed bodies?
bool Room::isCovered(const Patch& patch) const {
    constexpr int kPoints = 8;
    for (int i = 0; i < kPoints; ++i) {
        const auto x = hammersley4(i, kPoints);
        if (!bodies_->contain(placeIn(patch.polygon, x[0], x[1]).point + 2 * kTouching * sizeOf(patch.polygon) * patch.normal, patch.normal)) return false;
    }
    return true;
}

} // namespace shadowlab::radiosity
