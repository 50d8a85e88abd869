// SPDX-License-Identifier: MIT
#include "app/course/slide_stops.h"

#include <algorithm>
#include <utility>

namespace shadowlab::course {

namespace {

SlideStop stopOf(const SlidePicture& picture) {
    SlideStop stop{documentOf(picture.state), picture.label, picture.writtenLabel, picture.figure};
    stop.document.picked = picture.pixel;
    stop.document.partner = picture.partner;
    stop.document.outsideChoice = picture.outsideChoice;
    if (picture.outside) stop.document.outsideCamera = *picture.outside;
    return stop;
}

/// Are both panes of one window?
bool canStandTogether(const SlidePicture& a, const SlidePicture& b) {
    const auto isAlone = [](const SlidePicture& picture) {
        return picture.figure.empty() && picture.state.layout == picture::Layout::single;
    };
    return isAlone(a) && isAlone(b) && a.state.sceneName == b.state.sceneName && a.state.camera == b.state.camera &&
           a.state.scene->lights == b.state.scene->lights && a.state.light == b.state.light && a.pixel == b.pixel &&
           a.partner == b.partner && a.outside == b.outside && a.outsideChoice == b.outsideChoice;
}

} // namespace

std::vector<SlideStop> stopsOf(const Slide& slide) {
    const std::vector<SlidePicture>& pictures = slide.pictures;
    std::vector<SlideStop> stops;
    const bool together =
        (pictures.size() == 2 || pictures.size() == lab::kPanes) &&
        std::ranges::all_of(pictures, [&](const auto& picture) { return canStandTogether(pictures.front(), picture); });
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        SlideStop stop = stopOf(pictures[i]);
        if (!together || i == 0) {
            stops.push_back(std::move(stop));
            continue;
        }
        stops.front().document.panes[i] = stop.document.panes[0];
        if (stop.label.empty()) continue;
        const std::string between = stops.front().label.empty() ? "" : "  |  ";
        stops.front().label += between + stop.label;
        stops.front().writtenLabel += between + stop.writtenLabel;
    }
    if (together) stops.front().document.layout = pictures.size() == 2 ? picture::Layout::side : picture::Layout::grid;
    return stops;
}

} // namespace shadowlab::course
