// SPDX-License-Identifier: MIT
#include "app/student/search/scene_painter.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/context/signals.h"
#include "app/student/grading/left_files.h"
#include "app/student/search/drawing_service.h"
#include "app/student/search/scene_drawer.h"

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

// A picture takes some hundredths of a second, a first one some tenths; of a slow machine a hundred times as much.
constexpr std::chrono::seconds kLongestPicture{8};

} // namespace

ScenePainter::ScenePainter(const Candidate& candidate, const Conditions& conditions, fs::path readable)
    : candidate_(candidate), conditions_(conditions), readable_(std::move(readable)) {}

std::optional<std::string> ScenePainter::nextLine(std::string& failure) {
    ChildLimits limits = conditions_.limits;
    limits.time = std::min(limits.time, kLongestPicture);
    const Clock::time_point since = Clock::now();
    for (;;) {
        if (const std::size_t end = child_->said.find('\n'); end != std::string::npos) {
            std::string line = child_->said.substr(0, end);
            child_->said.erase(0, end + 1);
            return line;
        }
        if (const std::optional<int> status = child_->look()) {
            if (child_->said.find('\n') != std::string::npos) continue; // the last that it said
            const ChildEnd end = endOf(*status, *child_, conditions_.sandbox.isOn());
            failure = end.how == ChildEnd::How::finished ? "it ended the program" : end.message;
            child_.reset();
            return std::nullopt;
        }
        context::throwIfInterrupted();
        if (failure = overWhat(*child_, limits, since); !failure.empty()) {
            child_.reset();
            return std::nullopt;
        }
    }
}

bool ScenePainter::start(std::string& failure) {
    std::vector<std::string> words{kServeDrawings, candidate_.technique, candidate_.backend};
    SandboxRoom room{folder_.path(), {readable_}};
    if (!candidate_.plugin.empty()) {
        room.readable.push_back(candidate_.plugin);
        words.insert(words.end(), {"--plugin", fs::absolute(candidate_.plugin).string()});
    }
    child_ = std::make_unique<ChildProcess>(conditions_.sandbox.around(words, room));
    // What is printed while it is loaded comes before.
    while (const std::optional<std::string> line = nextLine(failure)) {
        const json answer = json::parse(*line, nullptr, false);
        if (!answer.is_object() || !answer.contains("ready")) continue;
        stages_ = answer.at("ready").get<std::vector<std::string>>();
        return true;
    }
    return false;
}

Painted ScenePainter::paint(const fs::path& scene, const std::vector<StageKey>& stages, int scale) {
    Painted painted;
    if (!child_ && !start(painted.failure)) return painted;
    const fs::path out = folder_.folder(std::to_string(++drawn_));
    json wanted = json::array();
    for (const StageKey& stage : stages)
        wanted.push_back({stage.id, stage.light});
    const json request{{"scene", scene.string()}, {"scale", scale}, {"draw", wanted}, {"out", out.string()}};
    child_->tell(request.dump() + "\n"); // one that is no longer there is noticed by what it does not say
    if (const std::optional<std::string> line = nextLine(painted.failure)) {
        const json answer = json::parse(*line, nullptr, false);
        if (answer.is_object() && answer.contains("failed") && answer.at("failed").is_string())
            painted.failure = answer.at("failed").get<std::string>();
        else
            for (std::size_t i = 0; i < stages.size() && painted.failure.empty(); ++i)
                if (auto bytes = bytesLeftIn(out / std::to_string(i))) painted.files.push_back(std::move(*bytes));
                else painted.failure = "it left no picture";
    }
    std::error_code ignored;
    fs::remove_all(out, ignored);
    if (!painted.failure.empty()) {
        painted.files.clear();
        child_.reset(); // an error may have left OpenGL in any state
    }
    return painted;
}

} // namespace shadowlab::student
