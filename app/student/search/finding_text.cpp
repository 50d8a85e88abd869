// SPDX-License-Identifier: MIT
#include "app/student/search/finding_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <nlohmann/json.hpp>

#include "techniques/registry.h"
#include "techniques/source_text.h"

namespace shadowlab::student {

namespace {

std::string inWords(int number) {
    constexpr std::array kWords = {"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};
    return number >= 0 && static_cast<std::size_t>(number) < kWords.size() ? kWords[static_cast<std::size_t>(number)]
                                                                            : std::to_string(number);
}

std::string capital(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

/// What is seen, after "here".
std::string observed(const Finding& finding) {
    const Trial& trial = finding.trial;
    constexpr double kNearlyAll = 0.9;
    const auto nearlyAll = [](int part, int all) { return all > 0 && part >= kNearlyAll * all; };
    if (!trial.failure.empty()) return "your technique draws no picture: " + trial.failure;
    const std::string pixels = std::to_string(trial.wrong) + " pixels";
    if (trial.light < 0) return pixels + " of your picture differ from the right one";
    if (nearlyAll(trial.falseLit, trial.shadowed)) return "your shadow is missing";
    if (nearlyAll(trial.falseShadow, trial.lit)) return "all is dark that should be lit";
    if (trial.falseLit + trial.falseShadow == 0) return pixels + " show a surface where there is none";
    const std::string lit = std::to_string(trial.falseLit) + " pixels are lit that should be in shadow",
                      dark = std::to_string(trial.falseShadow) + " pixels are in shadow that should be lit";
    return trial.falseLit == 0 ? dark : trial.falseShadow == 0 ? lit : lit + ", and " + dark;
}

std::string stageInWords(const StageEvidence& stage) {
    return stage.isEmpty ? "Your stage " + stage.stage + " is empty there."
                         : "Your stage " + stage.stage + " is the first that is not as it should be.";
}

/// Stages that no pass shows, or not all of it: the blanks that can be seen in them, by number.
struct SeenIn {
    std::string_view family, stage, blanks;
};
constexpr std::array kSeenIn = std::to_array<SeenIn>({
    {"shadow-map", "depth-on-view", "1 2 3 4"}, // the comparison comes later
    {"shadow-map", "distance-on-view", "1 2 4"}, // and the bias is in the map
    {"shadow-volume", "volume-parts", "1 2 3 4"},
    {"shadow-volume", "stencil-back", "1 2 3 4 5 7"}, // faces that face the viewer come later
    {"radiosity", "row-sums", "1 2 3"},
});

/// Those in the source of the passes up to the one that the stage shows: what an earlier one gets wrong by less than a level is not seen in
/// its own stage.
std::vector<int> blanksUpTo(const std::string& stage, const Family& family, const std::vector<Blank>& blanks) {
    const std::vector<PassInfo>& passes = findTechnique(rightTechnique(family)).passes;
    for (const SeenIn& seen : kSeenIn)
        if (seen.family == family.id && seen.stage == stage) return numbersIn(seen.blanks);
    if (std::ranges::find(passes, stage, &PassInfo::shownBy) == passes.end()) return {};
    std::vector<int> found;
    for (const PassInfo& pass : passes) {
        for (const AnchorUse& use : anchorsOf(pass))
            for (std::size_t i = 0; i < blanks.size(); ++i)
                if (blanks[i].anchor == use.anchor) found.push_back(static_cast<int>(i) + 1);
        if (pass.shownBy == stage) break;
    }
    return found;
}

} // namespace

std::string sceneInWords(const SearchScene& scene) {
    const int triangles = triangleCount(scene);
    std::string text = inWords(triangles) + (triangles == 1 ? " triangle" : " triangles");
    const auto suns = std::ranges::count(scene.lights, true, &SearchLight::isSun);
    const auto lamps = static_cast<std::ptrdiff_t>(scene.lights.size()) - suns;
    if (lamps > 0) text += std::string(suns > 0 ? ", " : " and ") + (lamps == 1 ? "a lamp" : inWords(static_cast<int>(lamps)) + " lamps");
    if (suns > 0) text += suns == 1 ? " and the sun" : " and " + inWords(static_cast<int>(suns)) + " suns";
    return text;
}

std::string sentenceOf(const Finding& finding) {
    const Trial& trial = finding.trial;
    std::string text = capital(sceneInWords(finding.scene)) + ": here " + observed(finding);
    if (trial.failure.empty()) {
        text += ", as in pixel " + std::to_string(trial.pixel.x) + "," + std::to_string(trial.pixel.y);
        if (!trial.object.empty()) text += " on " + trial.object;
    }
    text += ".";
    if (finding.stage) text += " " + stageInWords(*finding.stage);
    if (!finding.isFresh)
        text += " But only after other pictures in the same process: your technique keeps something of the scene before.";
    return text;
}

std::vector<int> blanksAbout(const Finding& finding, const Family& family, const std::vector<Blank>& blanks,
                             const std::vector<int>& bySheet) {
    if (blanks.empty()) return {};
    const std::vector<int> about = bySheet.empty() ? finding.kind->blanks : bySheet;
    if (!finding.stage) return about;
    const std::vector<int> inStage = blanksUpTo(finding.stage->stage, family, blanks);
    std::vector<int> both;
    std::ranges::copy_if(about, std::back_inserter(both), [&](int blank) { return std::ranges::find(inStage, blank) != inStage.end(); });
    // The stage is drawn in this very scene: what it rules out is ruled out.
    return !both.empty() ? both : !inStage.empty() ? inStage : about;
}

std::string lessonText(const Finding& finding, const Candidate& candidate, const Family& family, const std::string& stem) {
    using Json = nlohmann::ordered_json;
    const Trial& trial = finding.trial;
    // Sentences of a lesson have at most 260 characters.
    constexpr std::size_t kLongest = 260;
    constexpr std::size_t kLongestTitle = 60; // of a lesson
    std::string happens = sentenceOf(finding);
    if (happens.size() > kLongest) happens = capital(sceneInWords(finding.scene)) + ": here " + observed(finding) + ".";
    dvec2 low(std::numeric_limits<double>::infinity()), high(0.0);
    for (std::size_t i = 0; i < trial.isWrong.size(); ++i)
        if (trial.isWrong[i]) {
            const dvec2 place(static_cast<double>(i % kSearchWidth), static_cast<double>(i / kSearchWidth));
            low = glm::min(low, place);
            high = glm::max(high, place + 1.0);
        }
    const dvec2 size(kSearchWidth, kSearchHeight);
    const auto share = [](double value) { return std::round(value * 1000) / 1000; };
    const dvec2 corner = low / size, extent = (high - low) / size;
    const std::string right(rightTechnique(family));
    const int least = std::max(finding.wrongAtDouble / 2, finding.rightAtDouble + 2);
    Json expect{{"quantity", trial.light < 0 ? "differing" : "wrong"}};
    if (trial.light < 0) expect["reference"] = {{"technique", right}};
    expect["before"] = {{"atLeast", least}};
    expect["after"] = {{"atMost", trial.light < 0 ? 0 : finding.rightAtDouble + (least - finding.rightAtDouble) / 2}};
    Json lesson{{"title", capital(sceneInWords(finding.scene)).substr(0, kLongestTitle)}, {"scene", stem + ".json"}};
    if (trial.light >= 0) lesson["light"] = finding.scene.lights[static_cast<std::size_t>(trial.light)].name;
    lesson["before"] = {{"slots", {{{"technique", candidate.technique}}}}};
    lesson["after"] = {{"slots", {{{"technique", right}}}}};
    lesson["happens"] = happens;
    lesson["mends"] = "The lecture's own algorithm, " + right + ", in the same scene.";
    lesson["look"] = {{{"box", {share(corner.x), share(corner.y), share(extent.x), share(extent.y)}}, {"label", "here"}}};
    lesson["expect"] = Json::array({expect});
    return "// Found by shadowlab grade --search; drawn with --plugin " + candidate.plugin.filename().string() + ".\n" + lesson.dump(2) + "\n";
}

} // namespace shadowlab::student
