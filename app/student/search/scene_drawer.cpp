// SPDX-License-Identifier: MIT
#include "app/student/search/scene_drawer.h"

#include <algorithm>
#include <utility>

#include "app/picture/panel.h"
#include "app/picture/stage_ref.h"

namespace shadowlab::student {

View foundView(const scene::Scene& scene, int scale) {
    View view;
    view.camera = scene.camera;
    view.size = scale * ivec2(kSearchWidth, kSearchHeight);
    return view;
}

SceneDrawer::SceneDrawer(std::string_view technique, scene::Snapshot snapshot, const std::vector<std::string>& settings)
    : session_(std::move(snapshot)), slot_(picture::Session::makeSlot(technique)) {
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        const auto param = std::ranges::find(slot_.params, setting.substr(0, equals), &params::Param::id);
        if (param != slot_.params.end()) params::setFromText(*param, setting.substr(equals + 1), technique);
    }
}

std::vector<std::uint8_t> SceneDrawer::visibility(const View& view, int light) {
    FrameRequest request;
    request.stages = {picture::visibilityOf(light)};
    const picture::RenderedFrame rendered = session_.render(slot_, view, request);
    return picture::readVisibility(picture::findStage(rendered, picture::visibilityOf(light))).greyAlpha;
}

image::Image SceneDrawer::picture(const View& view, const StageKey& stage) {
    picture::Cell cell{0, 0, view.size.x, view.size.y, view.size};
    picture::PanelRequest request;
    request.stage.key = stage;
    request.camera = view.camera;
    return picture::renderPanel(session_, slot_, encoder_, cell, request).panel.picture;
}

} // namespace shadowlab::student
