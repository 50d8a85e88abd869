// What the cache finds for lamps beyond their direct light: what of the exchange of patches passes them by, and light that is followed along paths.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/radiosity/lights/lamp_cover.h"
#include "techniques/radiosity/room/near_emitters.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

const scene::Object* RoomCache::bodyOf(std::size_t light) const {
    const auto found = std::ranges::find(snapshot_->objects, static_cast<int>(light), &scene::Object::emitterOfLight);
    return found != snapshot_->objects.end() ? &*found : nullptr;
}

bool RoomCache::hangsFreely(std::size_t light) const {
    if (!bodyOf(light) || !scene::hasArea(snapshot_->lights[light])) return false;
    if (snapshot_->lights[light].type == scene::LightType::sphere) return true;
    const std::span<const scene::Light> own(&snapshot_->lights[light], 1);
    return std::ranges::none_of(room_->patches(), [&](const Patch& patch) { return coveredByLamps(patch, own, room_->world().originWorld) > 0; });
}

bool RoomCache::advanceLamps(Deadline deadline) {
    if (!areLampsKnown_) {
        findFreeLamps();
        findFollowed();
        areLampsKnown_ = true;
    }
    return advanceLampsBetween(deadline) && advancePathLight(deadline);
}

bool RoomCache::advanceLampsBetween(Deadline deadline) {
    if (lampsBuilder_) {
        if (!lampsBuilder_->advance(deadline)) return false;
        pastLamps_ = lampsBuilder_->take();
        lampsBuilder_.reset();
    }
    leaveWhatPassesLamps();
    return true;
}

void RoomCache::findFreeLamps() {
    std::vector<scene::Light> lamps;
    std::vector<LampBody> bodies;
    isFree_.clear();
    for (std::size_t l = 0; l < lights_.size(); ++l) {
        isFree_.push_back(params_.showsPixels() && hangsFreely(l) ? 1 : 0);
        if (isFree_.back() == 0) continue;
        bodies.emplace_back(snapshot_->lights[l], *bodyOf(l), room_->world().originWorld);
        lamps.push_back(snapshot_->lights[l]);
        lamps.back().intensity = 1;
        lamps.back().color = vec3(1);
    }
    if (lamps == freeLamps_) return;
    freeLamps_ = std::move(lamps);
    lampsBuilder_ = bodies.empty() ? nullptr : std::make_unique<LampsBetweenBuilder>(*room_, std::move(bodies));
    pastLamps_.clear();
    if (!exchange_ || !beforeLamps_) return;
    putBack(exchange_->matrix, *beforeLamps_);
    beforeLamps_.reset();
    version_ = scene::newRevision();
}

/// Not twice, and not before there is something of which to leave it.
void RoomCache::leaveWhatPassesLamps() {
    if (!exchange_ || beforeLamps_ || pastLamps_.empty()) return;
    beforeLamps_ = leaveShares(exchange_->matrix, pastLamps_);
    version_ = scene::newRevision();
}

/// Patches closer to a lamp than half its size are in a gap as well: up to a third of what they reflect comes back to it. Not before a lamp
/// that lies on a surface: there they have it as the surface's, which reflects nothing where it is covered.
Followed RoomCache::lightToFollow() const {
    constexpr double kOfLamp = 0.5;
    if (!params_.showsPixels()) return {};
    const std::vector<Patch>& patches = room_->patches();
    Followed found{room_->followed(), std::vector<std::uint8_t>(lights_.size(), 0)};
    for (std::size_t l = 0; l < lights_.size(); ++l) {
        if (!bodyOf(l)) continue;
        const trace::CentredBox box = lights_[l].source->box();
        const std::vector<Plane> fronts = lights_[l].source->fronts();
        const double reach = isFree_[l] == 0 ? 0 : kOfLamp * glm::distance(box.lower, box.upper);
        for (std::size_t i = 0; i < patches.size(); ++i)
            if (isInGap(patches[i], box, fronts, reach)) found.patches[i] = found.lights[l] = 1;
    }
    return found;
}

void RoomCache::findFollowed() {
    Followed now = lightToFollow();
    std::vector<scene::Light> lights;
    for (std::size_t l = 0; l < now.lights.size(); ++l)
        if (now.lights[l] != 0) lights.push_back(snapshot_->lights[l]);
    if (now == followed_ && lights == followedLights_) return;
    followed_ = std::move(now);
    followedLights_ = std::move(lights);
    pathLight_ = {};
    pathBuilder_ = followed_.any() ? std::make_unique<PathLightBuilder>(*room_, *cells_, snapshot_, followed_) : nullptr;
}

bool RoomCache::advancePathLight(Deadline deadline) {
    if (!pathBuilder_) return true;
    if (!pathBuilder_->advance(deadline)) return false;
    pathLight_ = pathBuilder_->take();
    pathBuilder_.reset();
    return true;
}

} // namespace shadowlab::radiosity
