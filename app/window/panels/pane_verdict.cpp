// SPDX-License-Identifier: MIT
#include "app/window/panels/pane_verdict.h"

#include <algorithm>
#include <cmath>

#include "app/picture/verdict_reasons.h"
#include "app/window/panels/widgets.h"
#include "app/window/pictures.h"

namespace shadowlab::window {

namespace {

/// "lamp: 404 wrong pixels, edge 0.21 px, 12 ms", and shorter: what is left out has the tooltip. A number of a moment ago, or one that
/// counts ties, is written with a sign for "about".
std::vector<std::string> verdictForms(const WindowState& ui, const lab::LiveErrors& errors, int pane) {
    if (ui.lesson.paints()) return {"judged when the truth is shown", "not judged yet"};
    const auto& lights = ui.bench.shownScene()->lights;
    std::string light;
    if (lights.size() > 1)
        light = lights[std::min(static_cast<std::size_t>(ui.bench.document().light), lights.size() - 1)].name + ": ";
    const bool hasTime = ui.live && ui.showsTimes && !ui.bench.pane(pane).showsAnother();
    const std::string time = hasTime ? ", " + std::to_string(std::lround(ui.bench.pane(pane).rendered().frameMs)) + " ms" : "";
    const picture::StageRef& stage = ui.bench.document().panes[static_cast<std::size_t>(pane)].stage;
    if (stage.isPass)
        return {light + "a step, not judged" + time, light + "a step, not judged", light + "a step"};
    const lab::PaneErrors* const known = errors.errors(pane);
    if (stage.isOutside()) return {light + "from outside, not judged", light + "from outside", "outside"};
    if (!known) return {light + "not judged yet" + time, light + "not judged yet", light + "not judged", "not judged"};
    const int wrong = known->counts.wrong();
    const std::string about = errors.areFinal(pane) ? "" : "≈ ";
    // A stage that shows no verdict, as a map or the picture without shadows, is not what is judged.
    const std::string of = stage.isPicture() || stage.isJudged() ? "" : "finished: ";
    const std::string count = light + of + about + std::to_string(wrong) + " wrong";
    const std::optional<double> edgePx = known->saidEdgeErrorPx();
    const std::string edge = edgePx ? about + picture::fixed(*edgePx, 2) + " px" : "";
    const std::string withEdge = count + (edge.empty() ? "" : ", " + edge);
    return {count + (wrong == 1 ? " pixel" : " pixels") + (edge.empty() ? "" : ", edge " + edge) + time,
            withEdge + time, withEdge, count};
}

/// The first that fits; the last, cut, where none does.
std::string fitting(const std::vector<std::string>& forms, float width) {
    for (const std::string& form : forms)
        if (ImGui::CalcTextSize(form.c_str()).x <= width) return form;
    return cutTo(forms.back(), width);
}

void verdictTooltip(const lab::PaneErrors& known, const std::string& whole, bool isFinal) {
    ImGui::SetTooltip("%s\nof the whole finished picture: %d pixels lit that are in shadow, %d in shadow that are lit%s\n"
                      "edge: how far on average the shadow's edge is from where it belongs, in pixels; not said where most wrong pixels "
                      "are elsewhere",
                      whole.c_str(), known.counts.falseLit, known.counts.falseShadow, isFinal ? "" : "\n≈: of a moment ago; exact when all is at rest");
}

} // namespace

void drawVerdict(const WindowState& ui, const lab::LiveErrors& errors, const PaneHeader& header, bool isBesideMenus) {
    const float right = static_cast<float>(header.area.size.x) - ImGui::GetStyle().WindowPadding.x;
    const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
    if (isBesideMenus) ImGui::SameLine();
    const float left = ImGui::GetCursorPosX(), room = right - left;
    const std::vector<std::string> forms = verdictForms(ui, errors, header.pane);
    std::string progress = fitting(progressOf(ui, errors, header.pane), room);
    const float progressWidth = progress.empty() ? 0 : ImGui::CalcTextSize(progress.c_str()).x;
    const float rest = progress.empty() ? room : room - progressWidth - gap;
    const bool hasVerdict = rest >= ImGui::CalcTextSize(forms.back().c_str()).x || progress.empty();
    const std::string text = hasVerdict ? fitting(forms, rest) : "";
    if (isBesideMenus) ImGui::AlignTextToFramePadding();
    if (hasVerdict) {
        if (isBesideMenus && progress.empty()) ImGui::SetCursorPosX(std::max(left, right - ImGui::CalcTextSize(text.c_str()).x));
        ImGui::TextUnformatted(text.c_str());
        const lab::PaneErrors* const known = errors.errors(header.pane);
        if (ImGui::IsItemHovered() && known && !ui.lesson.paints()) verdictTooltip(*known, forms.front(), errors.areFinal(header.pane));
    }
    if (progress.empty()) return;
    if (hasVerdict) ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(left, right - progressWidth));
    ImGui::TextUnformatted(progress.c_str());
}

float verdictRoom(const WindowState& ui, const lab::LiveErrors& errors, int pane, bool isCompact) {
    if (isCompact) return ImGui::CalcTextSize(verdictForms(ui, errors, pane).back().c_str()).x;
    const auto& lights = ui.bench.shownScene()->lights;
    float light = 0;
    for (const auto& one : lights)
        if (lights.size() > 1) light = std::max(light, ImGui::CalcTextSize((one.name + ": ").c_str()).x);
    return light + ImGui::CalcTextSize("≈ 9999 wrong pixels, edge ≈ 0.00 px, 999 ms").x;
}

} // namespace shadowlab::window
