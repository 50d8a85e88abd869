// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <imgui.h>

#include "app/picture/pixel_verdict.h"
#include "app/window/panels/widgets.h"
#include "app/window/theme.h"

namespace shadowlab::window {

namespace {

void factTable(const char* id, const std::vector<Probe::Fact>& facts) {
    if (facts.empty() || !ImGui::BeginTable(id, 2)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 0.4f);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.6f);
    for (const Probe::Fact& fact : facts) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        wholeNumbersText(fact.label);
        ImGui::TableNextColumn();
        wholeNumbersText(fact.value + (fact.unit.empty() ? "" : " " + fact.unit));
    }
    ImGui::EndTable();
}

std::string headingOf(const Probe::Node& node) {
    std::string heading = node.label;
    if (!node.surface.empty()) heading += " to " + node.surface + ", " + node.object;
    if (node.surface.empty() && !node.end.empty()) heading += ": " + node.end;
    return heading;
}

/// A ray, and below it those that come from it. The first ray is open from the start.
void rayTree(const std::vector<Probe::Node>& tree, std::size_t index) {
    ImGui::PushID(static_cast<int>(index));
    const ImGuiTreeNodeFlags open = index == 0 ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    if (ImGui::TreeNodeEx("ray", open, "%s", headingOf(tree[index]).c_str())) {
        factTable("facts", tree[index].facts);
        for (std::size_t i = index + 1; i < tree.size(); ++i)
            if (tree[i].parent == static_cast<int>(index)) rayTree(tree, i);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

} // namespace

void pixelPanel(WindowState& ui) {
    const lab::PickedPixel& picked = ui.bench.pickedPixel();
    if (!picked.askedFor.view.picked) return;
    if (!ImGui::CollapsingHeader("Pixel", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const picture::PixelVerdict verdict = picture::pixelVerdict(picked.probe);
    ImGui::PushStyleColor(ImGuiCol_Text, verdict.isWrong ? kWarning : kAccent);
    wholeNumbersText(verdict.sentence);
    ImGui::PopStyleColor();
    for (const std::string& sum : verdict.sums)
        wholeNumbersText(sum);
    if (ImGui::TreeNode("All that is known")) {
        factTable("facts", picked.probe.facts);
        ImGui::TreePop();
    }
    if (!picked.probe.tree.empty()) rayTree(picked.probe.tree, 0);
    if (ImGui::Button("Let go (Esc)")) ui.bench.unpick();
}

} // namespace shadowlab::window
