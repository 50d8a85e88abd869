// The settings in the panel: the basic ones always, the others in groups, each value in a place where nothing covers it.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/context/assets.h"
#include "app/window/panels/panels.h"
#include "app/window/screen.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

/// A rectangle in pixels.
struct Box {
    ImVec2 least{FLT_MAX, FLT_MAX}, most{-FLT_MAX, -FLT_MAX};
    void add(const ImVec2& point) {
        least = {std::min(least.x, point.x), std::min(least.y, point.y)};
        most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    [[nodiscard]] bool meets(const Box& other) const {
        return least.x < other.most.x && other.least.x < most.x && least.y < other.most.y && other.least.y < most.y;
    }
};

/// The panel as it was drawn: its text in reading order, and where its letters and the grabs of its sliders are.
struct DrawnPanel {
    std::string text;
    std::vector<Box> letters, grabs;

    [[nodiscard]] bool has(const std::string& part) const { return text.find(part) != std::string::npos; }
    [[nodiscard]] int coveredLetters() const {
        return static_cast<int>(std::ranges::count_if(letters, [&](const Box& letter) {
            return std::ranges::any_of(grabs, [&](const Box& grab) { return grab.meets(letter); });
        }));
    }
};

class ParameterPanelTest : public testing::GlTest {
protected:
    ParameterPanelTest()
        : ui_(lab::newDocument(scene(), "sphere-on-plane")),
          screen_(ui_, context::assetsRoot() / "fonts" / "DejaVuSans.ttf") {
        ui_.live = false;
        screen_.fit({400, 260}, 1);
        screen_.frame(0.03);
    }
    static scene::Snapshot scene() {
        return scene::loadScene("sphere-on-plane", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    }
    void set(const std::string& id, const std::string& value) {
        ui_.bench.change("", [&](lab::Document& d) {
            lab::PaneState& pane = d.panes[static_cast<std::size_t>(d.active)];
            pane.settings[pane.technique][id] = value;
        });
    }
    params::ParamList& list() {
        const lab::Document& document = ui_.bench.document();
        return ui_.bench.pane(document.active)
            .slotFor(document.panes[static_cast<std::size_t>(document.active)])
            .params;
    }
    /// In an ImGui window of its own, so high that nothing of it is cut off.
    DrawnPanel draw(float width = 300) {
        ImGui::GetIO().DisplaySize = {width, 3000};
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({width, 3000});
        ImGui::Begin("the panel alone", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::LogToClipboard(0); // 0: without opening what is folded
        window::Theme theme;
        theme.em = ImGui::GetFontSize();
        parameterPanel(ui_, theme);
        ImGui::LogFinish();
        ImGui::End();
        ImGui::Render();
        DrawnPanel panel{ImGui::GetClipboardText(), {}, {}};
        const ImDrawData& data = *ImGui::GetDrawData();
        const ImU32 grab = ImGui::GetColorU32(ImGuiCol_SliderGrab), letter = ImGui::GetColorU32(ImGuiCol_Text);
        for (int l = 0; l < data.CmdListsCount; ++l)
            collect(*data.CmdLists[l], grab, letter, panel);
        return panel;
    }

    window::WindowState ui_;
    window::Screen screen_;

private:
    /// Vertices of one colour that follow each other are one shape; a letter has four, with places in the font's texture.
    static void collect(const ImDrawList& drawn, ImU32 grab, ImU32 letter, DrawnPanel& panel) {
        const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
        const auto isWhite = [&](const ImDrawVert& v) { return v.uv.x == white.x && v.uv.y == white.y; };
        bool inGrab = false;
        for (int i = 0; i < drawn.VtxBuffer.Size; ++i) {
            const ImDrawVert& vertex = drawn.VtxBuffer[i];
            const bool isGrab = vertex.col == grab && isWhite(vertex);
            if (isGrab && !inGrab) panel.grabs.emplace_back();
            if (isGrab) panel.grabs.back().add(vertex.pos);
            inGrab = isGrab;
            if (vertex.col != letter || isWhite(vertex) || i + 3 >= drawn.VtxBuffer.Size) continue;
            Box& box = panel.letters.emplace_back();
            for (int corner = 0; corner < 4; ++corner)
                box.add(drawn.VtxBuffer[i + corner].pos);
            i += 3;
        }
    }
};

TEST_F(ParameterPanelTest, BasicOnesAreShownAndGroupsAreFolded) {
    const DrawnPanel panel = draw();
    int basic = 0, folded = 0;
    for (const params::Param& param : list()) {
        if (!params::hasEffect(param)) continue;
        if (params::isBasic(param)) {
            EXPECT_TRUE(panel.has(params::labelOf(param))) << param.id;
            ++basic;
        } else {
            EXPECT_FALSE(panel.has(params::labelOf(param) + "\n"))
                << param.id << " is shown although its group is folded";
            EXPECT_TRUE(panel.has(param.group)) << "no heading of " << param.group;
            ++folded;
        }
    }
    EXPECT_EQ(basic, 5) << "of the shadow map, with its default filter and bias";
    EXPECT_GE(folded, 15);
    EXPECT_TRUE(panel.has("2048 texels")) << panel.text;
    EXPECT_TRUE(panel.has("percentage-closer filtering")) << panel.text;
    EXPECT_FALSE(panel.has("evsm-exponent") || panel.has("EVSM")) << "without effect: its filter is not chosen";
}

TEST_F(ParameterPanelTest, AGroupInWhichSomethingIsChangedOpensAndCountsIt) {
    EXPECT_FALSE(draw().has("Cascades\n"));
    set("cascades", "3");
    const DrawnPanel one = draw();
    EXPECT_TRUE(one.has("Fit  (1 changed)")) << one.text;
    EXPECT_TRUE(one.has("Cascades") && one.has("3 maps")) << one.text;
    EXPECT_TRUE(one.has("Split scheme")) << "cascades make it have an effect";
    set("warp", "lispsm");
    const DrawnPanel two = draw();
    EXPECT_TRUE(two.has("Fit  (2 changed)") && two.has("light space perspective")) << two.text;
    ui_.bench.undo();
    ui_.bench.undo();
    EXPECT_FALSE(draw().has("changed"));
}

TEST_F(ParameterPanelTest, NoGrabCoversAValue) {
    std::size_t grabs = 0, letters = 0;
    for (const float width : {200.f, 300.f}) // a panel at 640x400 and at 1280x720
        for (const char* technique : {"shadow-map", "ray-traced", "radiosity", "lecture-shadow-map"}) {
            ui_.bench.change("", [&](lab::Document& d) { d.panes[0].technique = technique; });
            for (int share = 0; share <= 8; ++share) { // the grabs at both ends, and between
                for (const params::Param& param : list()) {
                    if (param.kind != params::Kind::integer && param.kind != params::Kind::real) continue;
                    if (!params::isBasic(param)) continue;
                    const double value = param.minimum + (param.maximum - param.minimum) * share / 8;
                    set(param.id, std::to_string(static_cast<int>(value)));
                }
                const DrawnPanel panel = draw(width);
                EXPECT_EQ(panel.coveredLetters(), 0) << technique << " at " << share << " / 8";
                grabs += panel.grabs.size();
                letters += panel.letters.size();
            }
        }
    EXPECT_GE(grabs, 2u * 9 * (2 + 2 + 2 + 2)) << "at least two sliders are shown of each technique";
    EXPECT_GE(letters, 10000u);
}

} // namespace
} // namespace shadowlab
