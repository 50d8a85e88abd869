// One scene of a search, tried: what is right in it, whether a right technique is right there, and what the plug-in makes of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/judge/verdict.h"
#include "app/student/search/random_scenes.h"
#include "app/student/search/scene_drawer.h"
#include "app/student/search/scene_painter.h"

namespace shadowlab::student {

struct Trial {
    /// Lit and shadowed places are there, and a right technique is right: only then does a wrong picture say something.
    bool isFair = false;
    std::string failure; ///< why the plug-in drew no picture; else empty
    int wrong = 0;       ///< pixels, outside of ties, where the right technique is right
    int falseLit = 0, falseShadow = 0;
    int lit = 0, shadowed = 0; ///< pixels of the truth; of a picture: none
    int light = 0;             ///< that all this is about; kNoLight: the picture is
    std::vector<bool> isWrong; ///< per pixel, rows from the top
    ivec2 pixel{-1};           ///< a wrong one amid the others
    judge::Verdict atPixel = judge::Verdict::correct; ///< on that pixel; of visibility alone
    std::string object;        ///< that is seen there; of visibility alone

    [[nodiscard]] bool fails(int least) const { return isFair && (!failure.empty() || wrong >= least); }
};

/// So many wrong pixels are no accident of rounding, of the grid of a map or of where patches end.
int leastWrong(const Family& family, Judged judged);

/// "160 x 90 pixels ...": the picture in which wrong pixels are counted, and which of them are.
std::string countedText(const Family& family, Judged judged);

/// The technique of the program that is held to be right in a family: the lecture's own.
std::string_view rightTechnique(const Family& family);
/// The production technique that refines that one.
std::string_view refinedTechnique(const Family& family);

/// Writes scenes, and tries them.
class SceneTrials {
public:
    /// Needs a current GL context.
    SceneTrials(const Candidate& candidate, const Family& family, const Conditions& conditions);

    Trial tryScene(const SearchScene& scene, Judged judged);
    /// The same with a plug-in that has drawn nothing before.
    Trial tryAnew(const SearchScene& scene, Judged judged);

    /// The files of the last scene that was tried.
    [[nodiscard]] const std::filesystem::path& lastScene() const { return lastScene_; }
    [[nodiscard]] ScenePainter& painter() { return painter_; }
    /// A technique of the program, with the last scene.
    SceneDrawer& drawerOf(std::string_view technique);
    [[nodiscard]] const Family& family() const { return family_; }

private:
    Trial tryVisibility();
    Trial tryPicture();

    const Family& family_;
    TemporaryFolder folder_;
    ScenePainter painter_;
    std::map<std::string, std::unique_ptr<SceneDrawer>, std::less<>> drawers_;
    std::filesystem::path lastScene_;
    scene::Snapshot snapshot_;
    int written_ = 0;
};

} // namespace shadowlab::student
