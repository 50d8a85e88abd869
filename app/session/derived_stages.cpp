// SPDX-License-Identifier: MIT
#include "app/session/derived_stages.h"

#include <algorithm>
#include <array>

#include "app/measure/verdict.h"
#include "app/session/mesh_edges.h"
#include "app/session/scanline_plot.h"
#include "techniques/foundation/look.h"

namespace shadowlab::session {

namespace {

using measure::Verdict;
using trace::Visibility;

const StageInfo kMeshEdges{"mesh-edges", "Edges where meshes are open, or no surface at all", StageKind::swatches,
                           false};

/// Of techniques that publish their visibility.
const StageInfo kDerived[] = {
    {"truth", "The exact answer for every pixel", StageKind::swatches, true},
    {"error", "Where the technique is wrong", StageKind::swatches, true},
    {"scanline", "Visibility along one row, against the truth", StageKind::swatches, true},
};

constexpr float kRim = 0.3f; ///< of the light, on the outlines of objects

// The desaturated picture under errors is lifted to this share of white and up: what is wrong mostly lies in shadow, and
// blue on near-black would be lost on a projector.
constexpr float kErrorGround = 0.3f;

/// A meaning and its colour; how many pixels have it is counted while drawing.
struct Meaning {
    vec3 colorLinear;
    const char* label;
    int pixels = 0;
};

std::vector<KeyEntry> keyOf(std::span<const Meaning> meanings) {
    std::vector<KeyEntry> key;
    for (const Meaning& meaning : meanings)
        if (meaning.label)
            key.push_back(
                {meaning.colorLinear, std::string(meaning.label) + ": " + std::to_string(meaning.pixels) + " px"});
    return key;
}

image::Color8 encoded(const vec3& linear) {
    return {image::srgbFromLinear(linear.r), image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b), 255};
}

/// The pixels of the view's region; all of them when it has none.
template <typename Visit>
void forEachShown(const View& view, const Visit& visit) {
    const bool whole = view.region.size.x <= 0 || view.region.size.y <= 0;
    const ivec2 corner = whole ? ivec2(0) : view.region.corner;
    const ivec2 end = whole ? view.size : glm::min(view.size, corner + view.region.size);
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x)
            visit(x, y);
}

Panel truthPanel(const measure::Truth& truth, const View& view) {
    std::array<Meaning, 5> meanings = {{{look::kLit, "lit"},
                                        {look::kShadowed, "in shadow"},
                                        {look::kTurnedAway, "turned away from the light"},
                                        {look::kTie, "tie"},
                                        {look::kNoSurface, nullptr}}};
    Panel panel{image::Image(view.size.x, view.size.y), "", StageKind::swatches, {}};
    forEachShown(view, [&](int x, int y) {
        const std::size_t i = truth.index(x, y);
        const Visibility seen = truth.visibility[i];
        Meaning& meaning = meanings[truth.ties[i] && seen != Visibility::noSurface ? 3
                                    : seen == Visibility::lit                      ? 0
                                    : seen == Visibility::shadowed                 ? 1
                                    : seen == Visibility::turnedAway               ? 2
                                                                                   : 4];
        ++meaning.pixels;
        // Where one object ends and another begins, a darker line: else lit things would merge with a lit ground.
        const bool rim = (x + 1 < view.size.x && truth.objects[truth.index(x + 1, y)] != truth.objects[i]) ||
                         (y + 1 < view.size.y && truth.objects[truth.index(x, y + 1)] != truth.objects[i]);
        panel.picture.set(x, y, encoded(meaning.colorLinear * (rim ? kRim : 1.0f)));
    });
    panel.display.key = keyOf(meanings);
    return panel;
}

/// The picture without its colours, and on it every pixel that is wrong.
Panel errorPanel(image::Image picture, const measure::Truth& truth, const measure::Judgement& judgement,
                 const View& view) {
    std::array<Meaning, 4> meanings = {{{look::kFalseLit, "false lit (should be in shadow)"},
                                        {look::kFalseShadow, "false shadow (should be lit)"},
                                        {look::kTie, "tie"},
                                        {look::kStray, nullptr}}};
    forEachShown(view, [&](int x, int y) {
        const std::size_t i = truth.index(x, y);
        const Verdict verdict = judgement.verdicts[i];
        const auto paint = [&](Meaning& meaning) {
            meaning.pixels += verdict != Verdict::tie || truth.visibility[i] != Visibility::noSurface;
            picture.set(x, y, encoded(meaning.colorLinear));
        };
        switch (verdict) {
        case Verdict::falseLit: paint(meanings[0]); break;
        case Verdict::falseShadow: paint(meanings[1]); break;
        case Verdict::tie: paint(meanings[2]); break;
        case Verdict::stray:
            meanings[3].label = "surface where there is none";
            paint(meanings[3]);
            break;
        case Verdict::background:
        case Verdict::correct: {
            const image::Color8 c = picture.at(x, y);
            const float luminance = 0.2126f * image::linearFromSrgb(c.r) + 0.7152f * image::linearFromSrgb(c.g) +
                                    0.0722f * image::linearFromSrgb(c.b);
            picture.set(x, y, encoded(vec3(glm::mix(kErrorGround, 1.0f, luminance))));
        }
        }
    });
    Panel panel{std::move(picture), "", StageKind::swatches, {}};
    panel.display.key = keyOf(meanings);
    return panel;
}

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
    if (request.stage.id == "truth") return truthPanel(truth, request.view);
    image::Image picture = encoder.encode(slot.target.color, session.snapshot()->exposure);
    const VisibilityImage visibility = readVisibility(findStage(rendered, {"visibility", light}));
    const measure::Judgement judgement = measure::judge(truth, visibility.greyAlpha);
    if (request.stage.id == "error") return errorPanel(std::move(picture), truth, judgement, request.view);
    const Scanline scanline{truth, judgement, visibility,
                            session.snapshot()->lights[static_cast<std::size_t>(light)].name,
                            std::string(slot.info->title)};
    return scanlinePanel(std::move(picture), scanline, request.row, request.view.region, request.font);
}

} // namespace shadowlab::session
