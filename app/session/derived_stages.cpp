// SPDX-License-Identifier: MIT
#include "app/session/derived_stages.h"

#include <algorithm>

#include "app/measure/verdict.h"
#include "app/session/mesh_edges.h"
#include "app/session/scanline_plot.h"
#include "app/session/verdict_panels.h"

namespace shadowlab::session {

namespace {

const StageInfo kMeshEdges{"mesh-edges", "Edges where meshes are open, or no surface at all", StageKind::swatches,
                           false};

/// Of techniques that publish their visibility.
const StageInfo kDerived[] = {
    {"truth", "The exact answer for every pixel", StageKind::swatches, true},
    {"error", "Where the technique is wrong", StageKind::swatches, true},
    {"scanline", "Visibility along one row, against the truth", StageKind::swatches, true},
};

} // namespace

std::vector<StageInfo> stagesOf(const TechniqueInfo& info) {
    std::vector<StageInfo> stages = info.stages;
    if (std::ranges::find(stages, "visibility", &StageInfo::id) != stages.end())
        stages.insert(stages.end(), std::begin(kDerived), std::end(kDerived));
    stages.push_back(kMeshEdges);
    return stages;
}

bool isDerived(std::string_view stage) {
    return stage == kMeshEdges.id || std::ranges::find(kDerived, stage, &StageInfo::id) != std::end(kDerived);
}

std::vector<StageKey> neededFor(const StageKey& stage) {
    if (!isDerived(stage.id)) return {stage};
    if (stage.id == "truth" || stage.id == kMeshEdges.id) return {};
    return {{"visibility", stage.light}};
}

Panel derivedPanel(Session& session, const Slot& slot, const RenderedFrame& rendered, const PictureEncoder& encoder,
                   const DerivedRequest& request) {
    if (request.stage.id == kMeshEdges.id)
        return meshEdgesPanel(encoder.encode(slot.target.color, session.snapshot()->exposure), *session.snapshot(),
                              session.buffers(), request.view);
    const int light = request.stage.light;
    const measure::Truth& truth = session.truth(request.view, light);
    if (request.stage.id == "truth") return truthPanel(truth, request.view.region);
    image::Image picture = encoder.encode(slot.target.color, session.snapshot()->exposure);
    const VisibilityImage visibility = readVisibility(findStage(rendered, {"visibility", light}));
    const measure::Judgement judgement = measure::judge(truth, visibility.greyAlpha);
    if (request.stage.id == "error") return errorPanel(std::move(picture), truth, judgement, request.view.region);
    const Scanline scanline{truth, judgement, visibility,
                            session.snapshot()->lights[static_cast<std::size_t>(light)].name,
                            std::string(slot.info->title)};
    return scanlinePanel(std::move(picture), scanline, request.row, request.view.region, request.font);
}

} // namespace shadowlab::session
