// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/room.h"

#include <algorithm>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/room/patch_memory.h"
#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// Patches are cut at contacts, so all of a patch lies inside a body or outside, but for rounding. Where they are not cut, a patch
// that is half outside is kept.
constexpr double kCovered = 0.95;

// In a simplified mesh, surfaces nearer than this share of a cell were moved together by simplification: two walls, two leaves.
// Patches that see hardly anything else lie in a fold that the original mesh does not have.
constexpr double kFold = 0.5, kNothingElse = 0.95;

// The share of the budget that sides of simplified meshes may use; flat faces must be cut as well.
constexpr double kShareOfSides = 0.6;

// Where contacts cut so much that patches exceed the budget, meshes are simplified further, so often at most.
constexpr int kMostSimplifications = 4;

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

/// Is the point, which lies in the plane of the convex polygon, within it?
bool holds(const Polygon& polygon, const dvec3& point, const dvec3& normal) {
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.count()];
        if (glm::dot(glm::cross(b - a, point - a), normal) < 0) return false;
    }
    return true;
}

} // namespace

Room::Room(const scene::Scene& scene, RoomSettings settings)
    : scene_(scene), settings_(std::move(settings)),
      mostSides_(static_cast<std::size_t>(kShareOfSides * static_cast<double>(settings_.patches))) {}

bool Room::advance(std::chrono::steady_clock::time_point deadline) {
    do {
        switch (phase_) {
        case Phase::simplify:
            simplify();
            phase_ = Phase::cut;
            break;
        case Phase::cut:
            cut();
            phase_ = simplifiesFurther() ? Phase::simplify : Phase::sample;
            break;
        case Phase::sample:
            nextPatch_ = trace::parallelUntil(deadline, nextPatch_, patches_.size(),
                                              [&](std::size_t i) { sampleSurroundings(i); });
            if (nextPatch_ < patches_.size()) return false;
            leaveOutCovered();
            phase_ = Phase::done;
            break;
        case Phase::done: return true;
        }
    } while (phase_ == Phase::done || std::chrono::steady_clock::now() < deadline);
    return false;
}

void Room::simplify() {
    requireMemoryToSimplify(scene_);
    std::vector<std::uint8_t> sides; // what is open exchanges light on both
    for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
        const scene::Object& object = scene_.objects[o];
        const bool isLightWithin = o < settings_.lightWithin.size() && settings_.lightWithin[o];
        sides.push_back(object.mesh->outward && object.castsShadow && !isLightWithin ? 1 : 2);
    }
    simple_ = simplifiedScene(scene_, mostSides_, sides);
    ++simplifications_;
    colors_.emplace(scene_);
    world_ = trace::worldTriangles(*simple_->scene);
    plain_ = facesOf(*simple_->scene, world_);
    bvh_ = trace::buildBvh(world_.triangles);
    std::vector<std::uint8_t> casts;
    for (const std::uint32_t object : world_.objects)
        casts.push_back(simple_->scene->objects[object].castsShadow ? 1 : 0);
    occlusion_.emplace(plain_, *bvh_, std::move(casts));
    tracer_.advance(simple_->scene, std::chrono::steady_clock::time_point::max());
}

void Room::cut() {
    sides_ = sidesOf(*simple_->scene, world_, plain_, settings_.lightWithin);
    bodies_.emplace(*bvh_, world_, sides_.isClosed);
    Faces loose;
    exchangingFaces_ = {.all = {}, .ofTriangle = sides_.faces.ofTriangle};
    for (std::size_t i = 0; i < sides_.faces.all.size(); ++i)
        (i < sides_.exchanging ? exchangingFaces_ : loose).all.push_back(sides_.faces.all[i]);
    requireMemory(scene_, exchangingFaces_.all.size()); // each is at least one patch, and more where they touch
    const double size = cutWithinBudget();
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

double Room::cutWithinBudget() {
    const Ground ground = settings_.coarsensGround ? Ground(exchangingFaces_) : Ground();
    // Contacts add patches, and how many is known only after cutting: the budget is reduced by the excess, a few times.
    constexpr int kTries = 6;
    std::size_t budget = settings_.patches;
    for (int i = 0;; ++i) {
        const double size = sizeForBudget(exchangingFaces_, budget, ground);
        patches_ = cutIntoPatches(exchangingFaces_, size, ground);
        if (settings_.cutsAtContacts) patches_ = cutAtContacts(exchangingFaces_, std::move(patches_));
        const std::size_t count = patches_.size();
        if (count <= settings_.patches || budget == 0 || i == kTries) return size;
        budget = std::min(budget - 1, budget * settings_.patches / count);
    }
}

const std::vector<dvec3>& Room::reflectances() const {
    if (!reflectances_.empty()) return reflectances_;
    reflectances_.resize(allPatches_.size());
    trace::parallelFor(allPatches_.size(), [&](std::size_t i) { reflectances_[i] = reflectanceOf(allPatches_[i]); });
    return reflectances_;
}

dvec3 Room::reflectanceOf(const Patch& patch) const {
    const dvec3 ofMaterial(materialOf(patch).diffuse);
    const std::uint32_t object = faceOf(patch).object;
    if (!colors_->has(object)) return ofMaterial;
    const bool isCoarse = !simple_->cornersOfObject[object].empty();
    return colors_->mean(patch, world_.originWorld, object, isCoarse ? simple_->cellMetres : 1e-3 * sizeOf(patch.polygon), ofMaterial);
}

void Room::sampleSurroundings(std::size_t patch) {
    const std::uint32_t object = faceOf(patches_[patch]).object;
    const bool isCoarse = !simple_->cornersOfObject[object].empty();
    const HemisphereShares seen =
        sampleHemisphere(tracer_, *bodies_, patches_[patch], object, isCoarse ? kFold * simple_->cellMetres : 0);
    surroundings_[patch] = seen.nothing;
    inBodies_[patch] = seen.inBodies;
    folded_[patch] = seen.folds;
}

std::vector<std::uint32_t> Room::refine(std::span<const Refinement> refinements) {
    reflectances_.clear();
    Refined cut = refined(patches_, refinements, levels_);
    const std::vector<double> before = std::move(surroundings_);
    patches_ = std::move(cut.patches);
    levels_ = std::move(cut.level);
    surroundings_.assign(patches_.size(), 0.0);
    inBodies_.assign(patches_.size(), 0.0);
    folded_.assign(patches_.size(), 0.0);
    trace::parallelFor(patches_.size(), [&](std::size_t i) {
        if (cut.from[i] == Refined::kNew)
            sampleSurroundings(i);
        else
            surroundings_[i] = before[cut.from[i]];
    });
    allPatches_.erase(allPatches_.begin(), allPatches_.end() - static_cast<std::ptrdiff_t>(loosePatches_));
    allPatches_.insert(allPatches_.begin(), patches_.begin(), patches_.end());
    return std::move(cut.from);
}

void Room::leaveOutCovered() {
    std::size_t kept = 0;
    const std::vector<std::vector<std::uint32_t>> over = sidesOver(sides_, *simple_->scene, world_);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const auto covers = [&](std::uint32_t side) {
            return holds(sides_.faces.all[side].polygon, patches_[i].centre, patches_[i].normal);
        };
        if (inBodies_[i] > kCovered || (!over.empty() && std::ranges::any_of(over[patches_[i].face], covers))) {
            ++coveredPatches_;
            continue;
        }
        if (settings_.leavesOutFolds && surroundings_[i] == 0 && folded_[i] > kNothingElse) {
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
}

} // namespace shadowlab::radiosity
