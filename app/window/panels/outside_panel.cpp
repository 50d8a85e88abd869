// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"
#include "app/window/panels/widgets.h"

namespace shadowlab::window {

void outsidePanel(WindowState& ui) {
    const picture::OutsideChoice choice = ui.bench.document().outsideChoice;
    const auto box = [&](const char* label, bool picture::OutsideChoice::*member, const char* help) {
        bool on = choice.*member;
        if (ImGui::Checkbox(label, &on)) ui.bench.change("", [&](lab::Document& d) { d.outsideChoice.*member = on; });
        hint(help);
    };
    box("all shadow volumes", &picture::OutsideChoice::allVolumes,
        "of all casters; else of the selected object, or of the one whose shadow takes most of the picture");
    ImGui::SameLine();
    box("near-clip pyramid", &picture::OutsideChoice::nearClipPyramid,
        "from the near plane to the light: what stands in it casts its shadow on the near plane");
}

} // namespace shadowlab::window
