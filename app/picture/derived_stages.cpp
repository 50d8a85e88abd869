// SPDX-License-Identifier: MIT
#include "app/picture/derived_stages.h"

#include <algorithm>

#include "app/judge/verdict.h"
#include "app/picture/outside/outside_view.h"
#include "app/picture/stage_ref.h"
#include "app/picture/stages/mesh_edges.h"
#include "app/picture/stages/scanline_plot.h"
#include "app/picture/stages/shadow_outline.h"
#include "app/picture/verdict_panels.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::picture {

namespace {

const StageInfo kMeshEdges{"mesh-edges", "Edges where meshes are open, or no surface at all", StageKind::swatches,
                           false};
const StageInfo kShadowOutline{"shadow-outline", "Where the shadows really end", StageKind::swatches, true};
const StageInfo kOutside{"outside", "Seen from outside: eye, light, and what is between", StageKind::swatches, true,
                         true};

/// Of techniques that publish their visibility.
const StageInfo kDerived[] = {
    {"truth", "The exact answer for every pixel", StageKind::swatches, true},
    {"error", "Where the technique is wrong", StageKind::swatches, true},
    {"scanline", "Visibility along one row, against the truth", StageKind::swatches, true},
};

Panel outsidePanel(Session& session, Slot& slot, const PictureEncoder& encoder, const DerivedRequest& request) {
    const scene::Scene& scene = *session.snapshot();
    View outside = request.view;
    if (request.outsideSize.x > 0) {
        outside.size = request.outsideSize;
        outside.region = {};
    }
    const double aspect = static_cast<double>(outside.size.x) / outside.size.y;
    outside.camera = request.outside ? scene::widenedFor(*request.outside, aspect)
                                     : scene::outsideCameraFor(scene, request.view.camera, aspect);
    const Stage stage = *OutsideView().render(session, slot, request.view, outside, request.stage.light,
                                                {.choice = request.outsideChoice, .typeHeight = request.typeHeight});
    return {encoder.encode(stage, kOutside.kind, scene.exposure), "", kOutside.kind, stage.display};
}

} // namespace

std::vector<StageInfo> stagesOf(const TechniqueInfo& info) {
    std::vector<StageInfo> stages = info.stages;
    if (publishes(info, kVisibilityStage))
        stages.insert(stages.end(), std::begin(kDerived), std::end(kDerived));
    stages.push_back(kShadowOutline);
    stages.push_back(kMeshEdges);
    stages.push_back(kOutside);
    return stages;
}

bool isDerived(std::string_view stage) {
    return stage == kShadowOutline.id || stage == kMeshEdges.id || stage == kOutside.id ||
           std::ranges::find(kDerived, stage, &StageInfo::id) != std::end(kDerived);
}

std::string captionOf(const TechniqueInfo& info, std::string_view stage) {
    const std::vector<StageInfo> known = stagesOf(info);
    const auto found = std::ranges::find(known, stage, &StageInfo::id);
    return found == known.end() ? "" : std::string(found->caption);
}

bool followsPicked(const TechniqueInfo& info, std::string_view stage) {
    return std::ranges::any_of(stagesOf(info),
                               [&](const StageInfo& one) { return one.followsPicked && one.id == stage; });
}

std::vector<StageKey> neededFor(const StageKey& stage) {
    const StageRef ref{stage.id};
    if (!ref.isDerived()) return {stage};
    if (ref.isError() || ref.isScanline()) return {visibilityOf(stage.light)};
    return {};
}

Panel derivedPanel(Session& session, Slot& slot, const RenderedFrame& rendered, const PictureEncoder& encoder,
                   const DerivedRequest& request) {
    if (request.stage.id == kMeshEdges.id)
        return meshEdgesPanel(encoder.encode(slot.target.color, session.snapshot()->exposure), *session.snapshot(),
                              session.buffers(), request.view);
    if (request.stage.id == kOutside.id) return outsidePanel(session, slot, encoder, request);
    const int light = request.stage.light;
    if (request.stage.id == kShadowOutline.id)
        return shadowOutlinePanel(encoder.encode(slot.target.color, session.snapshot()->exposure),
                                  session.outline(request.view, light), session.snapshot()->light(light).name,
                                  request.view.region);
    const judge::Truth& truth = session.truth(request.view, session.truthFor(slot, light));
    const StageRef stage{request.stage.id};
    if (stage.isTruth()) return truthPanel(truth, request.view.region);
    image::Image picture = encoder.encode(slot.target.color, session.snapshot()->exposure);
    const VisibilityImage visibility = readVisibility(findStage(rendered, visibilityOf(light)));
    const judge::Judgement judgement = judge::judge(truth, visibility.greyAlpha);
    if (stage.isError()) return errorPanel(std::move(picture), truth, judgement, request.view.region, request.markWidth);
    const Scanline scanline{truth, judgement, visibility,
                            session.snapshot()->light(light).name,
                            std::string(slot.info->title)};
    return scanlinePanel(std::move(picture), scanline, request.row, request.view.region, request.font);
}

} // namespace shadowlab::picture
