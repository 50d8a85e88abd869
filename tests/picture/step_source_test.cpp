// A step as text: which lines are marked, which files are shown, and the values of a pixel beside what they are values of.
// SPDX-License-Identifier: MIT
#include "app/picture/steps/step_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/frame.h"
#include "techniques/registry.h"

namespace shadowlab::picture {
namespace {

StepSource stepOf(std::string_view technique, std::string_view pass, const Probe* probe = nullptr,
                  const std::vector<std::pair<std::string, std::string>>& settings = {}) {
    const TechniqueInfo& info = findTechnique(technique);
    const std::unique_ptr<Technique> made = info.make();
    params::ParamList params = made->params();
    for (const auto& [id, value] : settings)
        params::setFromText(params::find(params, id, technique), value, technique);
    return stepSource(info, &passInfo(info.passes, pass), params, SourceText::read(), probe);
}

std::vector<std::string> marked(const std::vector<StepLine>& lines) {
    std::vector<std::string> texts;
    for (const StepLine& line : lines)
        if (line.isCurrent) texts.push_back(line.text);
    return texts;
}

std::vector<std::string> anchors(const StepSource& step) {
    std::vector<std::string> all;
    for (const SourcePiece& piece : step.pieces)
        all.insert(all.end(), piece.anchors.begin(), piece.anchors.end());
    return all;
}

TEST(StepSourceTest, TheLinesOfTheStepAreMarkedInTheLectureAndInTheFiles) {
    const StepSource step = stepOf("shadow-map", "depth");
    EXPECT_EQ(step.pseudocode.size(), 10u);
    EXPECT_EQ(marked(step.pseudocode),
              (std::vector<std::string>{"  render z-buffer from light's point of view to depth map D",
                                        "  store D as texture map d(u,v)"}));
    EXPECT_EQ(anchors(step), (std::vector<std::string>{"draw-map", "draw-casters"}));
    const SourceText source = SourceText::read();
    for (const SourcePiece& piece : step.pieces)
        for (const StepLine& line : piece.lines)
            EXPECT_EQ(line.text, source.lines(piece.file)[static_cast<std::size_t>(line.number) - 1]);
    const std::vector<std::string> lines = marked(step.pieces[0].lines);
    ASSERT_GE(lines.size(), 10u);
    EXPECT_TRUE(lines.front().starts_with("void DepthPass::draw(")) << lines.front();
    EXPECT_EQ(lines.back(), "}");
}

TEST(StepSourceTest, WithoutAStepTheAlgorithmStandsThereUnmarked) {
    const TechniqueInfo& info = findTechnique("shadow-volume-zfail");
    const StepSource step = stepSource(info, nullptr, {}, SourceText::read());
    EXPECT_EQ(step.pseudocode.size(), 8u);
    EXPECT_TRUE(marked(step.pseudocode).empty());
    EXPECT_TRUE(step.pieces.empty() && step.formula.empty());
}

TEST(StepSourceTest, OfLinesBetweenWhichAParameterChoosesThoseThatRunAreShown) {
    const std::vector<std::string> pcf = anchors(stepOf("shadow-map", "light"));
    const std::vector<std::string> hard = anchors(stepOf("shadow-map", "light", nullptr, {{"filter", "hard"}}));
    EXPECT_EQ(std::ranges::count(pcf, "compare-pcf"), 1);
    EXPECT_EQ(std::ranges::count(pcf, "compare-hard"), 0);
    EXPECT_EQ(std::ranges::count(hard, "compare-pcf"), 0);
    EXPECT_EQ(std::ranges::count(hard, "compare-hard"), 1);
}

TEST(StepSourceTest, PiecesThatMeetInOneFileAreOne) {
    const StepSource step = stepOf("shadow-map", "light");
    const auto piece = std::ranges::find(step.pieces, "shaders/shadow_map/filters/filter_pcf.glsl", &SourcePiece::file);
    ASSERT_NE(piece, step.pieces.end());
    EXPECT_EQ(piece->anchors.size(), 2u);
    std::set<int> numbers;
    for (const StepLine& line : piece->lines)
        EXPECT_TRUE(numbers.insert(line.number).second) << "line " << line.number << " twice";
}

TEST(StepSourceTest, AnAnchorThatIsGoneIsALineAndNoFailure) {
    const TechniqueInfo& info = findTechnique("planar");
    SourceText source;
    source.add("shaders/planar/flatten.vert", "void main() {}\n"); // somebody is editing it
    const StepSource step = stepSource(info, &passInfo(info.passes, "shadows"), {}, source);
    ASSERT_EQ(step.faults.size(), 2u);
    EXPECT_NE(step.faults[0].find("[anchor: flatten]"), std::string::npos) << step.faults[0];
    EXPECT_EQ(step.formula.size(), 3u) << "the rest is there";
}

TEST(StepSourceTest, ValuesStandWhereTheirNamesDoAndOnlyWholeNamesCount) {
    Probe probe;
    probe.facts = {{"d(u,v) as it is compared", "0.25", ""},
                   {"z(u,v) as it is compared, the bias taken off", "0.75", ""}};
    const StepSource step = stepOf("shadow-map", "light", &probe);
    std::string values;
    for (const StepLine& line : step.formula)
        values += line.values + "\n";
    EXPECT_EQ(values, "\nd(u,v) = 0.25, z(u,v) = 0.75\n");
    int inPseudocode = 0;
    for (const StepLine& line : step.pseudocode)
        inPseudocode += line.values.empty() ? 0 : 1;
    EXPECT_EQ(inPseudocode, 2) << "each where it stands first";
    for (const StepLine& line : stepOf("shadow-map", "light").formula)
        EXPECT_EQ(line.values, "") << "no pixel is picked";
    // "u" is a value of ray tracing, and no part of any longer name.
    probe.facts = {{"u", "1, 0, 0", ""}};
    for (const SourcePiece& piece : stepOf("ray-traced", "trees", &probe).pieces)
        for (const StepLine& line : piece.lines)
            EXPECT_TRUE(line.values.empty() || line.text.find("u") != std::string::npos) << line.text;
}

// The stencil of a pixel goes up and down from step to step: each shows what it holds right after it.
TEST(StepSourceTest, AStepShowsWhatIsThereRightAfterIt) {
    Probe probe;
    probe.facts = {{"stencil, cleared", "0", ""},
                   {"stencil after the back faces", "3", ""},
                   {"stencil after the front faces", "4", ""},
                   {"stencil", "2", ""}};
    const auto shown = [&](const char* technique, const char* pass) {
        std::string values;
        for (const StepLine& line : stepOf(technique, pass, &probe).formula)
            values += line.values;
        return values;
    };
    for (const char* technique : {"shadow-volume-zfail", "shadow-volume"}) {
        EXPECT_EQ(shown(technique, "clear-stencil"), "stencil = 0") << technique;
        EXPECT_EQ(shown(technique, "volumes-back"), "stencil = 3") << technique;
        EXPECT_EQ(shown(technique, "volumes-front"), "stencil = 2") << technique;
        EXPECT_EQ(shown(technique, "light"), "stencil = 2") << technique;
    }
    EXPECT_EQ(shown("shadow-volume-zpass", "clear-stencil"), "stencil = 0");
    EXPECT_EQ(shown("shadow-volume-zpass", "volumes-front"), "stencil = 4");
    EXPECT_EQ(shown("shadow-volume-zpass", "volumes-back"), "stencil = 2");
}

/// Every fact by which a technique's values are known is one that its probe says of some pixel.
TEST(StepSourceTest, EveryNamedValueIsAFactOfSomePixel) {
    std::size_t checked = 0;
    for (const RegisteredTechnique& registered : registeredTechniques()) {
        const TechniqueInfo& info = *registered.info;
        if (info.values.empty()) continue;
        std::set<std::string> facts;
        const auto take = [&](const std::vector<Probe::Fact>& some) {
            for (const Probe::Fact& fact : some)
                facts.insert(fact.label);
        };
        for (const char* name : {"cornell-room", "mirror-and-glass"}) {
            if (info.id == "radiosity" && name == std::string("mirror-and-glass")) continue; // one room is enough
            const scene::Snapshot scene =
                scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
            const std::unique_ptr<Technique> technique = info.make();
            while (!technique->prepare(scene, Deadline::max()).converged)
                ;
            View view;
            view.camera = scene->camera;
            view.size = {320, 180};
            for (const ivec2 pixel :
                 {ivec2(160, 90), ivec2(80, 120), ivec2(200, 130), ivec2(240, 100), ivec2(120, 100)}) {
                const Probe probe = technique->probe(scene, view, pixel, 0);
                take(probe.facts);
                for (const Probe::Node& node : probe.tree)
                    take(node.facts);
            }
        }
        std::vector<NamedValue> values = info.values;
        for (const PassInfo& pass : info.passes)
            values.insert(values.end(), pass.values.begin(), pass.values.end());
        for (const NamedValue& value : values) {
            EXPECT_TRUE(facts.contains(std::string(value.fact))) << info.id << ": " << value.fact;
            ++checked;
        }
    }
    EXPECT_GE(checked, 20u);
}

TEST(StepSource, OfALongProcedureTheLinesOfTheStepAreKept) {
    const std::vector<StepLine> all = stepOf("lecture-ray-tracing", "intensity").pseudocode;
    ASSERT_GE(all.size(), 5u);
    const std::vector<StepLine> kept = linesOfStep(all);
    EXPECT_LT(kept.size(), all.size());
    EXPECT_EQ(marked(kept), marked(all));
    EXPECT_GE(marked(kept).size(), 1u);
    EXPECT_EQ(kept.front().text, "...");
    for (std::size_t i = 1; i < kept.size(); ++i)
        EXPECT_TRUE(kept[i].isCurrent || kept[i - 1].isCurrent) << "no two lines of dots in a row";
    const std::vector<StepLine> none = {{.number = 1, .text = "a", .values = {}}, {.number = 2, .text = "b", .values = {}}};
    EXPECT_EQ(linesOfStep(none).size(), 2u);
}

} // namespace
} // namespace shadowlab::picture
