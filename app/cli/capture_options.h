// What `capture` is asked to do: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/motion_options.h"
#include "app/context/context.h"
#include "app/film/film.h"
#include "app/picture/figure.h"
#include "app/picture/stage_ref.h"
#include "techniques/foundation/math/types.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct CaptureOptions {
    std::string scene;
    std::filesystem::path output;
    std::vector<std::string> techniques{"shadow-volume-zfail"};
    picture::Layout layout = picture::Layout::single;
    bool labels = true;
    bool ui = false;                              ///< the window with its widgets, not the pictures alone
    bool presenter = false;                       ///< its large type
    bool keys = false;                            ///< its list of keys
    bool source = false;                          ///< its text of the step: formula, pseudocode, source
    std::vector<picture::StageRef> stages;        ///< one for each technique
    double split = 0.5;                           ///< share of the width that the left one of two bands has
    std::optional<int> row;                       ///< of stage `scanline`
    std::optional<std::array<double, 6>> outside; ///< position and target of the second camera; none: a good place
    std::optional<ivec2> pixel;                   ///< whose rays are shown; none: a few of all
    std::optional<ivec2> partner;                 ///< a second one beside it
    ivec2 size{1280, 720};
    int supersample = 1;
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    context::Backend backend = context::Backend::automatic;
    std::filesystem::path stats; ///< empty: none
    MotionOptions motion;
    bool steps = false;    ///< all steps of the technique, one after another, in one file
    bool animate = false;  ///< all frames in one file
    image::FrameTime time; ///< how long each step, or frame, stays
    std::vector<std::filesystem::path> allowed;
};

void describeCapture(CLI::App& command);

/// From what was written to what is meant. Throws Error (usage, overLimit) for what is wrong in itself; what depends on
/// the scene, or on the graphics card, is seen later.
CaptureOptions captureOptions(const CLI::App& command);

/// `name_####.png` with the hashes replaced by the frame's number, counted from 1, padded with zeros to their width.
std::filesystem::path numbered(const std::filesystem::path& pattern, int frame);

/// Is the output one file in which several pictures follow each other?
inline bool isFilm(const CaptureOptions& options) { return options.steps || options.animate; }

/// Throws Error (usage) when several pictures would have one name.
void requirePlaceForNumbers(const CaptureOptions& options, int frames);

/// Samples of the largest panel on a side. Throws Error when the panels are too small to be drawn (usage) or all
/// together too large (overLimit).
int requireDrawable(const CaptureOptions& options);

} // namespace shadowlab::cli
