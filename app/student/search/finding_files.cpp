// SPDX-License-Identifier: MIT
#include "app/student/search/finding_files.h"

#include <optional>
#include <utility>

#include "app/context/assets.h"
#include "app/figures/figures.h"
#include "app/picture/stage_ref.h"
#include "app/student/grading/graded_scene.h"
#include "app/student/grading/left_files.h"
#include "app/student/grading/score_picture.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {

namespace {

std::string asText(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

/// A figure is drawn of a technique of the program, and shows what that decides: it says so, and what the plug-in does.
std::string captionOf(const Finding& finding, const Family& family) {
    const Trial& trial = finding.trial;
    const std::string pixel = "pixel " + std::to_string(trial.pixel.x) + "," + std::to_string(trial.pixel.y);
    const std::string text = "Drawn from the program's own " + std::string(refinedTechnique(family)) + ", not from the plug-in. ";
    const std::string lecture = text + "The lecture's algorithm decides of " + pixel + ": ";
    if (trial.atPixel == judge::Verdict::falseLit) return lecture + "in shadow. The plug-in says the opposite: lit.";
    if (trial.atPixel == judge::Verdict::falseShadow) return lecture + "lit. The plug-in says the opposite: in shadow.";
    return text + "In " + pixel + " the picture of the plug-in is another one than that of the lecture's algorithm.";
}

void addCaption(drawing::Drawing& drawing, const std::string& text, const image::Font& font) {
    constexpr double kEm = 30, kLine = 1.4 * kEm, kBorder = 40; // as high as the figure's own words
    const std::vector<std::string> lines = font.wrap(text, kEm, static_cast<int>(drawing.size().x - 2 * kBorder));
    double y = drawing.size().y + kEm;
    drawing.addRoomBelow(static_cast<double>(lines.size()) * kLine + kEm);
    for (const std::string& line : lines) {
        drawing.text({kBorder, y}, line, {.size = kEm, .isBold = false});
        y += kLine;
    }
}

/// The lecture's section figure of the wrong pixel; of patches, with the first place in the picture that it exchanges light with.
std::optional<std::string> figure(const Finding& finding, const Family& family, const scene::Snapshot& snapshot) {
    const std::filesystem::path fonts = context::assetsRoot() / "fonts";
    const image::Font font(fonts / "DejaVuSans.ttf"), bold(fonts / "DejaVuSans-Bold.ttf");
    const std::string_view technique = refinedTechnique(family);
    const picture::Slot slot = picture::Session::makeSlot(technique);
    View view = foundView(*snapshot);
    view.picked = finding.trial.pixel;
    // Nothing where the pixel has nothing to draw.
    const auto figureOf = [&](int light) -> std::optional<std::string> {
        try {
            const Probe probe = slot.technique->probe(snapshot, view, *view.picked, light);
            figures::Diagram diagram = figures::findFigure("pixel").draw({probe, technique, *snapshot, view, light, font, bold});
            addCaption(diagram.drawing, captionOf(finding, family), font);
            return diagram.document();
        } catch (const Error&) {
            return std::nullopt;
        }
    };
    if (family.id != "radiosity") return figureOf(snapshot->lights.empty() ? kNoLight : std::max(finding.trial.light, 0));
    constexpr int kEvery = 12; // pixels
    for (int y = kEvery / 2; y < kSearchHeight; y += kEvery)
        for (int x = kEvery / 2; x < kSearchWidth; x += kEvery) {
            view.partner = ivec2(x, y);
            if (auto drawn = figureOf(kNoLight)) return drawn;
        }
    return std::nullopt;
}

image::Image pictureOf(const Finding& finding, SceneTrials& trials) {
    constexpr int kScale = 2;
    SceneDrawer& right = trials.drawerOf(rightTechnique(trials.family()));
    const View view = foundView(*right.session().snapshot(), kScale);
    const bool isPicture = finding.trial.light < 0;
    std::vector<StageKey> stages{StageKey{}};
    if (!isPicture) stages.push_back(picture::visibilityOf(finding.trial.light));
    const Painted painted = trials.painter().paint(trials.lastScene(), stages, kScale);
    std::optional<image::Image> student;
    std::string failure = painted.failure;
    if (failure.empty()) {
        student = pictureIn(painted.files.front(), view.size);
        if (!student) failure = "it left no picture of the size that was asked for";
    }
    if (isPicture) return scorePicture(std::move(student), failure, right.picture(view, {}), trials.family().levels);
    const judge::Truth& truth = right.session().truth(view, picture::LightTruth(finding.trial.light));
    std::vector<std::uint8_t> greyAlpha(2 * truth.visibility.size(), 0);
    if (student && painted.files[1].size() == greyAlpha.size()) greyAlpha = painted.files[1];
    return scorePicture(std::move(student), failure, truth, judge::judge(truth, greyAlpha));
}

} // namespace

std::map<std::string, std::string> filesOf(const Finding& finding, SceneTrials& trials, const Candidate& candidate,
                                           const std::string& stem) {
    const Family& family = trials.family();
    std::map<std::string, std::string> files = filesOf(finding.scene, stem, sentenceOf(finding));
    files.emplace(stem + ".png", asText(image::encodePng(pictureOf(finding, trials))));
    if (!finding.trial.failure.empty()) return files;
    if (finding.isFresh) files.emplace(stem + "-lesson.json", lessonText(finding, candidate, family, stem));
    if (auto drawn = figure(finding, family, loadGradedScene(trials.lastScene()))) files.emplace(stem + ".svg", std::move(*drawn));
    return files;
}

} // namespace shadowlab::student
