// SPDX-License-Identifier: MIT
#include "app/lab/document.h"

#include <algorithm>
#include <utility>

#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::lab {

Document newDocument(scene::Snapshot scene, std::string sceneName) {
    Document document;
    document.sceneName = std::move(sceneName);
    document.camera = scene->camera;
    document.outsideCamera = outsideCameraOf(*scene, scene->camera);
    document.scene = std::move(scene);
    constexpr std::array<const char*, kPanes> kFirst = {"shadow-map", "shadow-volume-zfail", "ray-traced",
                                                        "unshadowed"};
    for (std::size_t i = 0; i < kFirst.size(); ++i)
        document.panes[i].technique = kFirst[i];
    return document;
}

scene::Camera outsideCameraOf(const scene::Scene& scene, const scene::Camera& eye) {
    constexpr double kAspect = 16.0 / 9; // of most screens
    return scene::outsideCameraFor(scene, eye, kAspect);
}

dvec2 placeOf(const dvec2& share, const dvec2& size) {
    return {0.5 + (share.x - 0.5) * (size.x / size.y) / kPlacesAspect, share.y};
}

dvec2 shareOf(const dvec2& place, const dvec2& size) {
    return {0.5 + (place.x - 0.5) * kPlacesAspect / (size.x / size.y), place.y};
}

bool isInPicture(const dvec2& place, ivec2 size) {
    const dvec2 share = shareOf(place, size);
    return share.x >= 0 && share.x <= 1 && share.y >= 0 && share.y <= 1;
}

ivec2 pixelAt(const dvec2& place, ivec2 size) {
    return glm::clamp(ivec2(glm::floor(shareOf(place, size) * dvec2(size))), ivec2(0), size - 1);
}

int shownPanes(picture::Layout layout) {
    switch (layout) {
    case picture::Layout::single: return 1;
    case picture::Layout::side:
    case picture::Layout::split:
    case picture::Layout::diff: return 2;
    case picture::Layout::grid: return kPanes;
    }
    return 1;
}

void UndoHistory::remember(const Document& before, const std::string& gesture) {
    if (!gesture.empty() && gesture == gesture_) return;
    gesture_ = gesture;
    future_.clear();
    if (past_.size() == kMost) past_.erase(past_.begin());
    past_.push_back(before);
}

Document UndoHistory::undo(const Document& now) {
    endGesture();
    if (past_.empty()) return now;
    future_.push_back(now);
    Document before = std::move(past_.back());
    past_.pop_back();
    return before;
}

Document UndoHistory::redo(const Document& now) {
    endGesture();
    if (future_.empty()) return now;
    past_.push_back(now);
    Document after = std::move(future_.back());
    future_.pop_back();
    return after;
}

void UndoHistory::clear() {
    past_.clear();
    future_.clear();
    endGesture();
}

} // namespace shadowlab::lab
