// A plug-in that draws one scene after another in a process of its own, which is started again when it has ended.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/student/grading/grader.h"
#include "app/student/grading/temporary_folder.h"
#include "techniques/frame.h"

namespace shadowlab::student {

/// The files that a drawing has left, read; or why there is none.
struct Painted {
    std::vector<std::vector<std::uint8_t>> files; ///< one for each stage that was asked for
    std::string failure;
};

class ScenePainter {
public:
    /// `readable`: the folder of the scenes.
    ScenePainter(const Candidate& candidate, const Conditions& conditions, std::filesystem::path readable);

    /// Pictures of the search's size (scene_drawer.h), `scale` times as large on a side.
    Painted paint(const std::filesystem::path& scene, const std::vector<StageKey>& stages, int scale = 1);
    /// The next picture is drawn by a process that has drawn none.
    void startAnew() { child_.reset(); }
    /// Stages that the technique says it has.
    [[nodiscard]] const std::vector<std::string>& stages() const { return stages_; }

private:
    /// The next line that it says. None: it has ended, or was ended, and `failure` says why.
    std::optional<std::string> nextLine(std::string& failure);
    bool start(std::string& failure);

    Candidate candidate_;
    const Conditions& conditions_;
    std::filesystem::path readable_;
    TemporaryFolder folder_;
    std::unique_ptr<ChildProcess> child_;
    std::vector<std::string> stages_;
    int drawn_ = 0;
};

} // namespace shadowlab::student
