// The text of a step beside its picture: it is there, it is that of the step, and it follows shaders that are saved.
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>

#include "app/context/assets.h"
#include "app/picture/limits.h"
#include "app/picture/steps/stepping.h"
#include "app/window/screen.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/registry.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

class SourcePanelTest : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        const scene::Snapshot scene =
            scene::loadScene("three-lights", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        ui.emplace(lab::newDocument(scene, scene->name));
        ui->live = false;
        ui->bench.allowDraft(false);
        window::chooseLayout(*ui, picture::Layout::single);
        screen.emplace(*ui, context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
        screen->setPatience(std::chrono::hours(1));
        screen->fit({960, 540}, 1);
    }
    void TearDown() override {
        screen.reset();
        ui.reset();
        GlTest::TearDown();
    }
    void show(const std::string& technique, const std::string& stage) {
        window::chooseTechnique(*ui, technique);
        window::chooseStage(*ui, picture::StageRef::parse(stage));
        drawn();
    }
    std::vector<std::uint8_t> drawn() {
        for (int frame = 0; frame < 4; ++frame)
            screen->frame(1.0 / 30);
        return picture::PictureEncoder::read(screen->picture()).rgba;
    }
    std::optional<window::WindowState> ui;
    std::optional<window::Screen> screen;
};

TEST_F(SourcePanelTest, EveryStepOfEveryTechniqueShowsItsLines) {
    window::toggleSource(*ui);
    std::size_t steps = 0;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        if (technique.info->id == "radiosity") continue; // its form factors take long, and it draws no other panel
        show(std::string(technique.info->id), "");
        for (const StageKey& pass :
             std::vector(ui->bench.pane(0).passesOf(technique.info->id, *ui->bench.shownScene()))) {
            show(std::string(technique.info->id), picture::refOf(pass, true, *ui->bench.shownScene()).text());
            const picture::StepSource& step = screen->stepSource();
            EXPECT_FALSE(step.pieces.empty()) << technique.info->id << " " << pass.id;
            EXPECT_TRUE(step.faults.empty()) << step.faults.front();
            EXPECT_TRUE(screen->messages().empty());
            ++steps;
        }
    }
    EXPECT_GE(steps, 40u);
}

// Until a picture of the new technique is there, the passes that are known are the old one's.
TEST_F(SourcePanelTest, NoStepOfOneTechniqueIsTakenForOneOfAnother) {
    const auto hasPass = [](std::string_view technique, std::string_view id) {
        return std::ranges::find(findTechnique(technique).passes, id, &PassInfo::id) !=
               findTechnique(technique).passes.end();
    };
    ASSERT_TRUE(hasPass("shadow-map", "lights-off"));
    ASSERT_FALSE(hasPass("radiosity", "lights-off"));
    window::toggleSource(*ui);
    show("shadow-map", "pass:lights-off");
    EXPECT_FALSE(screen->stepSource().pieces.empty());
    window::chooseTechnique(*ui, "radiosity");
    EXPECT_TRUE(ui->bench.pane(0).passesOf("radiosity", *ui->bench.shownScene()).empty());
    window::step(*ui, 1);
    EXPECT_TRUE(ui->bench.document().panes[0].stage.isPicture());
    show("radiosity", "pass:lights-off"); // which nothing in the window asks for any more
    EXPECT_TRUE(screen->stepSource().pieces.empty());
    show("planar", "");
    window::step(*ui, 1);
    EXPECT_EQ(ui->bench.document().panes[0].stage.text(), "pass:lights-off");
    drawn();
    EXPECT_FALSE(screen->stepSource().pieces.empty());
}

// Passes name lights by number. From outside, and in a window without room for a picture, none run for a new scene.
TEST_F(SourcePanelTest, NoStepOfASceneWithMoreLightsIsTaken) {
    const auto scene = [](const std::string& name) {
        return scene::loadScene(name,
                                {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = picture::limits()});
    };
    ui->bench.showScene(scene("three-lights"), "three-lights");
    show("shadow-map", "");
    const std::vector<StageKey> passes = ui->bench.pane(0).passesOf("shadow-map", *ui->bench.shownScene());
    ASSERT_TRUE(std::ranges::any_of(passes, [](const StageKey& pass) { return pass.light == 2; }));
    window::toggleSource(*ui);
    show("shadow-map", "outside");
    ui->bench.showScene(scene("still-life"), "still-life");
    ASSERT_LT(ui->bench.shownScene()->lights.size(), 3u);
    EXPECT_TRUE(ui->bench.pane(0).passesOf("shadow-map", *ui->bench.shownScene()).empty());
    window::step(*ui, 1);
    drawn();
    EXPECT_TRUE(screen->messages().empty());
}

TEST_F(SourcePanelTest, ThePictureMakesRoomForItAndTheSettingsToo) {
    show("planar", "pass:shadows");
    const int before = screen->pictureSize().x;
    EXPECT_TRUE(ui->shown.panel);
    window::toggleSource(*ui);
    const std::vector<std::uint8_t> withSource = drawn();
    EXPECT_FALSE(ui->shown.panel);
    EXPECT_GE(screen->pictureSize().x, 960 / 2) << "the picture keeps half of the window";
    ui->requests.scrollSource = 1;
    EXPECT_NE(drawn(), withSource) << "the text goes on";
    window::toggleSource(*ui);
    drawn();
    EXPECT_TRUE(ui->shown.panel);
    EXPECT_EQ(screen->pictureSize().x, before);
    // In presenter mode settings are away, and stay away when the source goes.
    window::togglePresenter(*ui);
    window::toggleSource(*ui);
    window::toggleSource(*ui);
    EXPECT_FALSE(ui->shown.panel);
    window::togglePresenter(*ui);
    EXPECT_TRUE(ui->shown.panel);
}

TEST_F(SourcePanelTest, AShaderThatIsSavedIsShownAsItIsNow) {
    window::toggleSource(*ui);
    show("planar", "pass:shadows");
    const auto line = [&](const std::string& text) {
        for (const picture::SourcePiece& piece : screen->stepSource().pieces)
            for (const picture::StepLine& one : piece.lines)
                if (one.isCurrent && one.text.find(text) != std::string::npos) return true;
        return false;
    };
    ASSERT_TRUE(line("void main()"));
    const scene::TempFolder folder;
    const auto save = [&](const std::string& text) {
        folder.write("planar/flatten.vert", text);
        ::setenv("SHADOWLAB_SHADERS", folder.path().c_str(), 1);
        gl::reloadShaders(); // as the window does when it notices a saved file
        ui->bench.drawAnew();
        drawn();
    };
    std::ifstream file(std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "shaders/planar/flatten.vert");
    const std::string real{std::istreambuf_iterator<char>(file), {}};
    std::string changed = real;
    changed.insert(changed.find("    passTexcoord();"), "    // a line that somebody has just written\n");
    save(changed);
    EXPECT_TRUE(line("a line that somebody has just written"));
    EXPECT_TRUE(screen->stepSource().faults.empty());
    changed.erase(changed.find("// [anchor: flatten]"), 20);
    save(changed);
    ASSERT_EQ(screen->stepSource().faults.size(), 1u) << "said in the panel; nothing else stops";
    EXPECT_TRUE(ui->bench.pane(0).failure().empty());
    ::unsetenv("SHADOWLAB_SHADERS");
    gl::reloadShaders();
    drawn();
    EXPECT_FALSE(line("a line that somebody has just written"));
}

TEST_F(SourcePanelTest, ValuesOfThePickedPixelStandBesideTheirNames) {
    window::toggleSource(*ui);
    show("shadow-map", "pass:light");
    const auto values = [&] {
        std::string all;
        for (const picture::StepLine& line : screen->stepSource().formula)
            all += line.values;
        return all;
    };
    EXPECT_EQ(values(), "");
    ui->bench.pick({0.5, 0.75}); // the floor
    drawn();
    EXPECT_NE(values().find("z(u,v) = "), std::string::npos) << values();
    ui->bench.unpick();
    drawn();
    EXPECT_EQ(values(), "");
}

} // namespace
} // namespace shadowlab
