// SPDX-License-Identifier: MIT
#include "app/student/grading/grader.h"

#include <memory>
#include <numeric>

#include <nlohmann/json.hpp>

#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/picture/session.h"
#include "app/student/grading/graded_scene.h"
#include "app/student/grading/left_files.h"
#include "app/student/grading/picture_difference.h"
#include "app/student/grading/score_picture.h"
#include "app/student/grading/temporary_folder.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;

fs::path sceneOf(const Case& which) { return context::assetsRoot() / "grading" / (std::string(which.id) + ".json"); }

/// A picture that another process drew; or why there is none.
struct Drawn {
    std::optional<image::Image> picture;
    std::string failure;
};

std::vector<std::uint8_t> greyAlphaOf(const image::Image& picture) {
    std::vector<std::uint8_t> greyAlpha;
    for (std::size_t i = 0; i < picture.rgba.size(); i += image::kChannels) {
        greyAlpha.push_back(picture.rgba[i]);
        greyAlpha.push_back(picture.rgba[i + 3]);
    }
    return greyAlpha;
}

class Grader {
public:
    Grader(const Candidate& candidate, const Conditions& conditions) : candidate_(candidate), conditions_(conditions) {}

    CaseResult judge(const Family& family, const Case& which) {
        return which.judged == Judged::visibility ? judgeVisibility(which) : judgePicture(family, which);
    }

private:
    /// Without a plug-in the technique is one of the program's own. Drawn is a stage; Judged::picture: the finished picture. Each has a
    /// folder of its own to write in, so that no picture of another is within reach.
    Drawn draw(const Candidate& candidate, const Case& which, Judged stage) {
        const fs::path scene = sceneOf(which), folder = folder_.folder(std::to_string(++drawn_)), file = folder / "picture.png";
        std::vector<std::string> words{"capture",   scene.string(),
                                       "-t",        candidate.technique,
                                       "-o",        file.string(),
                                       "--size",    std::to_string(kCaseWidth) + "x" + std::to_string(kCaseHeight),
                                       "--labels",  "false",
                                       "--backend", candidate.backend};
        SandboxRoom room{folder, {}};
        if (!candidate.plugin.empty()) {
            room.readable.push_back(candidate.plugin);
            words.insert(words.end(), {"--plugin", fs::absolute(candidate.plugin).string()});
        }
        if (stage != Judged::picture) words.insert(words.end(), {"--stage", std::string(toText(stage))});
        const ChildEnd end = runChild(words, conditions_.limits, conditions_.sandbox, room);
        if (end.how != ChildEnd::How::finished) return {std::nullopt, end.message};
        if (const std::optional<std::vector<std::uint8_t>> bytes = bytesLeftIn(file))
            if (std::optional<image::Image> picture = pictureIn(*bytes, {kCaseWidth, kCaseHeight})) return {std::move(picture), ""};
        return {std::nullopt, "it ended the program before the picture was written"};
    }

    CaseResult judgeVisibility(const Case& which) {
        const scene::Snapshot scene = loadGradedScene(sceneOf(which));
        picture::Session session(scene);
        View view;
        view.camera = scene->camera;
        view.size = {kCaseWidth, kCaseHeight};
        const judge::Truth& truth = session.truth(view, picture::LightTruth(0));

        const Drawn drawn = draw(candidate_, which, Judged::visibility);
        // Without a picture nothing is shown anywhere.
        const std::vector<std::uint8_t> greyAlpha =
            drawn.picture ? greyAlphaOf(*drawn.picture) : std::vector<std::uint8_t>(2 * truth.visibility.size(), 0);
        const judge::Judgement judgement = judge::judge(truth, greyAlpha);
        CaseResult result{&which, std::nullopt, drawn.failure, judgement.counts, {}};
        if (drawn.picture) result.wrong = judgement.counts.wrong() + judgement.counts.stray;
        if (!result.isRight()) {
            Drawn seen = drawn.picture ? draw(candidate_, which, Judged::picture) : drawn;
            result.picture = scorePicture(std::move(seen.picture), seen.failure, truth, judgement);
        }
        return result;
    }

    CaseResult judgePicture(const Family& family, const Case& which) {
        const Drawn right = draw({"", std::string(family.reference), candidate_.backend}, which, which.judged);
        if (!right.picture)
            throw Error(ExitStatus::overLimit, "grade: no picture of " + std::string(family.reference) +
                                                   " for the case " + std::string(which.id) + " (" + right.failure +
                                                   "); give it more with --time-limit or --memory-limit");
        Drawn drawn = draw(candidate_, which, which.judged);
        CaseResult result{&which, std::nullopt, drawn.failure, {}, {}};
        if (drawn.picture) result.wrong = difference(*drawn.picture, *right.picture, family.levels).count;
        if (!result.isRight())
            result.picture = scorePicture(std::move(drawn.picture), drawn.failure, *right.picture, family.levels);
        return result;
    }

    Candidate candidate_;
    const Conditions& conditions_;
    TemporaryFolder folder_;
    int drawn_ = 0;
};

} // namespace

int Sheet::points() const {
    return std::accumulate(results.begin(), results.end(), 0,
                           [](int sum, const CaseResult& result) { return sum + result.points(); });
}

int Sheet::mostPoints() const {
    return std::accumulate(results.begin(), results.end(), 0,
                           [](int sum, const CaseResult& result) { return sum + result.which->points; });
}

std::string whatIsWrong(const CaseResult& result, const Family& family) {
    if (!result.wrong) return "no picture: " + result.failure + ".";
    if (result.which->judged != Judged::visibility)
        return std::to_string(*result.wrong) + " pixels are more than " + std::to_string(family.levels) + " of 255 levels off.";
    return std::to_string(result.counts.falseLit) + " pixels lit that should be dark, " + std::to_string(result.counts.falseShadow) +
           " dark that should be lit.";
}

std::string hintOf(const CaseResult& result) { return result.wrong && !result.isRight() ? std::string(result.which->hint) : ""; }

Declared askPlugin(const fs::path& plugin, const Conditions& conditions) {
    std::error_code none; // what is no file cannot be given to a sandbox: that it is none is said by the program itself
    const bool isThere = fs::exists(plugin, none);
    const std::string absolute = fs::absolute(plugin).string();
    const std::vector<std::string> words{"list", "plugins", "--json", "--plugin", absolute};
    ChildEnd end = isThere ? runChild(words, conditions.limits, conditions.sandbox, {{}, {plugin}})
                           : runChild(words, conditions.limits, Sandbox(SandboxWanted::none), {});
    if (end.message.starts_with(absolute)) end.message.replace(0, absolute.size(), plugin.string()); // as it was given
    if (end.how == ChildEnd::How::failed) throw Error(ExitStatus::badInput, end.message);
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitStatus::badInput, plugin.string() + ": " + why +
                                              " while it was loaded; fix static objects, techniques() and make()");
    };
    if (end.how != ChildEnd::How::finished) refuse(end.message);
    const nlohmann::json json = nlohmann::json::parse(end.out, nullptr, false);
    if (!json.is_object() || !json.contains("plugins")) refuse("it wrote something of its own to standard output");
    Declared declared;
    for (const nlohmann::json& row : json.at("plugins")) {
        declared.techniques.push_back(row.value("technique", ""));
        declared.family = row.value("family", "");
        declared.skeleton = row.value("skeleton", "");
    }
    return declared;
}

Sheet grade(const Candidate& candidate, const Family& family, const Conditions& conditions,
            const std::function<void(int)>& done) {
    Sheet sheet{&family, candidate, {}};
    Grader grader(candidate, conditions);
    for (const Case& which : family.cases) {
        context::throwIfInterrupted();
        sheet.results.push_back(grader.judge(family, which));
        done(static_cast<int>(sheet.results.size()));
    }
    return sheet;
}

} // namespace shadowlab::student
