// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/room.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "techniques/radiosity/room/near_emitters.h"
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

} // namespace

Room::Room(const scene::Scene& scene, RoomSettings settings, std::optional<Eye> eye)
    : scene_(scene), settings_(std::move(settings)), eye_(std::move(eye)),
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
            looksForWindows_ = seesLittleOfOutside();
            nextPatch_ = 0;
            phase_ = Phase::sampleWindows;
            break;
        case Phase::sampleWindows:
            nextPatch_ = trace::parallelUntil(deadline, nextPatch_, patches_.size(), [&](std::size_t i) { sampleWindows(i); });
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

Importance Room::importanceTo(const std::optional<Eye>& eye) const { return eye ? Importance(tracer_, sides_, ground_, *eye) : Importance(); }

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

dvec3 Room::emissionOf(const Patch& patch) const {
    // A Lambertian surface of radiance L sends pi L into its hemisphere.
    return faceOf(patch).shines ? glm::pi<double>() * dvec3(materialOf(patch).emission) : dvec3(0);
}

bool Room::isOutsideOfSimplified(const Patch& patch) const {
    const Face& face = faceOf(patch);
    return face.isFront && objectOf(patch).mesh->outward && !simple_->areasOfObject[face.object].empty();
}

std::size_t Room::partOf(const Patch& patch) const { return scene::partOf(*objectOf(patch).mesh, world_.triangleInMesh(faceOf(patch).triangles[0])); }

double Room::areaFactor(const Patch& patch) const {
    if (!isOutsideOfSimplified(patch)) return 1;
    const std::uint32_t object = faceOf(patch).object;
    const std::size_t part = partOf(patch);
    const auto folded = foldedAreas_.find({object, part});
    const SimplifiedScene::Areas& areas = simple_->areasOfObject[object][part];
    return areas.before / std::max(patch.area, areas.after - (folded != foldedAreas_.end() ? folded->second : 0));
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
        if (cut.from[i] == Refined::kNew) {
            sampleSurroundings(i);
            sampleWindows(i);
        } else {
            surroundings_[i] = before[cut.from[i]];
        }
    });
    allPatches_.erase(allPatches_.begin(), allPatches_.end() - static_cast<std::ptrdiff_t>(loosePatches_));
    allPatches_.insert(allPatches_.begin(), patches_.begin(), patches_.end());
    return std::move(cut.from);
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
}

} // namespace shadowlab::radiosity
