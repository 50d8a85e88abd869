// SPDX-License-Identifier: MIT
#include "app/student/grading/grader.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>

#include <nlohmann/json.hpp>

#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/picture/limits.h"
#include "app/picture/session.h"
#include "app/student/grading/picture_difference.h"
#include "app/student/grading/score_picture.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;

/// Where the pictures of the children go.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code failed;
        std::string name = (fs::temp_directory_path(failed) / "shadowlab-grade-XXXXXX").string();
        if (failed || !::mkdtemp(name.data()))
            throw Error(ExitStatus::cannotWrite,
                        name + ": " + std::strerror(errno) + "; name another folder for temporary files with TMPDIR");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] fs::path file(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

fs::path sceneOf(const Case& which) { return context::assetsRoot() / "grading" / (std::string(which.id) + ".json"); }

/// A picture that another process drew; or why there is none.
struct Drawn {
    std::optional<image::Image> picture;
    std::string failure;
};

/// Without a plug-in the technique is one of the program's own. Drawn is a stage; Judged::picture: the finished picture.
Drawn draw(const Candidate& candidate, const Case& which, Judged stage, const ChildLimits& limits,
           const TemporaryFolder& folder) {
    const fs::path file = folder.file(std::string(which.id) + "-" + std::string(toText(stage)) + ".png");
    std::vector<std::string> words{"capture",   sceneOf(which).string(),
                                   "-t",        candidate.technique,
                                   "-o",        file.string(),
                                   "--size",    std::to_string(kCaseWidth) + "x" + std::to_string(kCaseHeight),
                                   "--labels",  "false",
                                   "--backend", candidate.backend};
    if (!candidate.plugin.empty()) words.insert(words.end(), {"--plugin", candidate.plugin.string()});
    if (stage != Judged::picture) words.insert(words.end(), {"--stage", std::string(toText(stage))});
    const ChildEnd end = runChild(words, limits);
    if (end.how != ChildEnd::How::finished) return {std::nullopt, end.message};
    try {
        image::Image picture = image::loadPng(file);
        if (picture.width == kCaseWidth && picture.height == kCaseHeight) return {std::move(picture), ""};
    } catch (const Error&) {
        // A plug-in that ends the program itself may leave half of a file, or none.
    }
    return {std::nullopt, "it ended the program before the picture was written"};
}

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
    Grader(const Candidate& candidate, const ChildLimits& limits) : candidate_(candidate), limits_(limits) {}

    CaseResult judge(const Family& family, const Case& which, image::Image& failing) {
        return which.judged == Judged::visibility ? judgeVisibility(which, failing)
                                                  : judgePicture(family, which, failing);
    }

private:
    CaseResult judgeVisibility(const Case& which, image::Image& failing) {
        const scene::Snapshot scene = scene::loadScene(
            sceneOf(which).string(), {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = picture::limits()});
        picture::Session session(scene);
        View view;
        view.camera = scene->camera;
        view.size = {kCaseWidth, kCaseHeight};
        const judge::Truth& truth = session.truth(view, picture::LightTruth(0));

        const Drawn drawn = draw(candidate_, which, Judged::visibility, limits_, folder_);
        // Without a picture nothing is shown anywhere.
        const std::vector<std::uint8_t> greyAlpha =
            drawn.picture ? greyAlphaOf(*drawn.picture) : std::vector<std::uint8_t>(2 * truth.visibility.size(), 0);
        const judge::Judgement judgement = judge::judge(truth, greyAlpha);
        CaseResult result{&which, std::nullopt, drawn.failure, judgement.counts};
        if (drawn.picture) result.wrong = judgement.counts.wrong() + judgement.counts.stray;
        if (!result.isRight() && failing.rgba.empty()) {
            Drawn seen = drawn.picture ? draw(candidate_, which, Judged::picture, limits_, folder_) : drawn;
            failing = scorePicture(std::move(seen.picture), seen.failure, truth, judgement);
        }
        return result;
    }

    CaseResult judgePicture(const Family& family, const Case& which, image::Image& failing) {
        const Drawn right =
            draw({"", std::string(family.reference), candidate_.backend}, which, which.judged, limits_, folder_);
        if (!right.picture)
            throw Error(ExitStatus::overLimit, "grade: no picture of " + std::string(family.reference) +
                                                   " for the case " + std::string(which.id) + " (" + right.failure +
                                                   "); give it more with --time-limit or --memory-limit");
        Drawn drawn = draw(candidate_, which, which.judged, limits_, folder_);
        CaseResult result{&which, std::nullopt, drawn.failure, {}};
        if (drawn.picture) result.wrong = difference(*drawn.picture, *right.picture, family.levels).count;
        if (!result.isRight() && failing.rgba.empty())
            failing = scorePicture(std::move(drawn.picture), drawn.failure, *right.picture, family.levels);
        return result;
    }

    Candidate candidate_;
    ChildLimits limits_;
    TemporaryFolder folder_;
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

Declared askPlugin(const fs::path& plugin, const ChildLimits& limits) {
    const ChildEnd end = runChild({"list", "plugins", "--json", "--plugin", plugin.string()}, limits);
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
    }
    return declared;
}

Sheet grade(const Candidate& candidate, const Family& family, const ChildLimits& limits,
            const std::function<void(int)>& done) {
    Sheet sheet{&family, candidate, {}, {}};
    Grader grader(candidate, limits);
    for (const Case& which : family.cases) {
        context::throwIfInterrupted();
        sheet.results.push_back(grader.judge(family, which, sheet.firstFailing));
        done(static_cast<int>(sheet.results.size()));
    }
    return sheet;
}

} // namespace shadowlab::student
