// SPDX-License-Identifier: MIT
#include "app/student/search/drawing_service.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/context/context.h"
#include "app/student/grading/graded_scene.h"
#include "app/student/search/scene_drawer.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {

namespace {

using nlohmann::json;

/// Where answers go: standard output as it was, while from now on that name leads nowhere.
class Answers {
public:
    Answers() : out_(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)) {
        std::cout.flush();
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        ::dup2(nowhere, STDOUT_FILENO);
    }
    void say(const json& answer) const {
        const std::string line = answer.dump(-1, ' ', true, json::error_handler_t::replace) + "\n";
        for (std::size_t at = 0; at < line.size();) {
            const ssize_t put = ::write(out_, line.data() + at, line.size() - at);
            if (put < 0 && errno == EINTR) continue;
            if (put <= 0) return; // nobody listens any more: standard input ends as well
            at += static_cast<std::size_t>(put);
        }
    }

private:
    int out_;
};

void draw(const std::string& technique, const json& request) {
    const scene::Snapshot snapshot = loadGradedScene(request.at("scene").get<std::string>());
    SceneDrawer drawer(technique, snapshot, kSearchSettings); // a new one: nothing is left of the scene before
    const View view = foundView(*snapshot, request.at("scale").get<int>());
    const std::filesystem::path out = request.at("out").get<std::string>();
    int number = 0;
    for (const json& wanted : request.at("draw")) {
        const StageKey stage{wanted.at(0).get<std::string>(), wanted.at(1).get<int>()};
        const std::filesystem::path file = out / std::to_string(number++);
        if (stage.id == kVisibilityStage)
            image::writeWhole(file, drawer.visibility(view, stage.light));
        else
            image::writeWhole(file, image::encodePng(drawer.picture(view, stage)));
    }
}

} // namespace

int serveDrawings(const std::vector<std::string>& words) {
    if (words.size() != 2) throw Error(ExitStatus::usage, std::string(kServeDrawings) + ": two words are expected; let grade begin it");
    const Answers answers;
    const std::unique_ptr<context::Context> context = context::createContext(context::backendFromName(words[1]));
    json stages = json::array();
    for (const StageInfo& stage : findTechnique(words[0]).stages)
        stages.push_back(stage.id);
    answers.say({{"ready", stages}});
    for (std::string line; std::getline(std::cin, line);) {
        try {
            draw(words[0], json::parse(line));
            answers.say({{"drawn", true}});
        } catch (const std::exception& why) {
            answers.say({{"failed", why.what()}});
        }
    }
    return 0;
}

} // namespace shadowlab::student
