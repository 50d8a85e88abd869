// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/room.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/room/near_emitters.h"
#include "techniques/radiosity/room/patch_memory.h"

namespace shadowlab::radiosity {

namespace {

// The share of the budget that sides of simplified meshes may use; flat faces must be cut as well.
constexpr double kShareOfSides = 0.6;

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

Importance Room::importanceTo(const std::optional<Eye>& eye) const { return eye ? Importance(tracer_, sides_, ground_, *eye) : Importance(); }

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
    const bool isCoarse = isSimplified(object);
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

void Room::findFollowed() {
    followed_ = NearEmitters(tracer_, sides_).followed(patches_, [&](std::uint32_t object) { return isSimplified(object); });
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
    findFollowed();
    return std::move(cut.from);
}

} // namespace shadowlab::radiosity
