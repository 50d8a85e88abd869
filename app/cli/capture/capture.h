// `shadowlab capture`: its options, and its two kinds of picture. Also called by `demo` where there is no display.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/motion_options.h"
#include "app/context/context.h"
#include "app/film/film.h"
#include "app/picture/figure.h"
#include "app/picture/stage_ref.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::cli {

struct CaptureOptions {
    std::string scene;
    std::filesystem::path output;
    std::vector<std::string> techniques{"shadow-volume-zfail"};
    picture::Layout layout = picture::Layout::single;
    bool labels = true;
    bool enlarge = false; ///< wrong pixels that stand alone, so that they are seen from afar; else each is one pixel
    bool ui = false;                              ///< the window with its widgets, not the pictures alone
    bool presenter = false;                       ///< its large type
    bool keys = false;                            ///< its list of keys
    bool source = false;                          ///< its text of the step: formula, pseudocode, source
    std::vector<picture::StageRef> stages;        ///< one for each technique
    double split = 0.5;                           ///< share of the width that the left one of two bands has
    std::optional<int> row;                       ///< of stage `scanline`
    std::optional<std::array<double, 6>> outside; ///< position and target of the second camera; none: a good place
    std::string volumes;                          ///< of the stage `outside`: "all", an object, or empty: one that is chosen
    bool nearClip = false;                        ///< likewise: the near-clip pyramid
    std::optional<ivec2> pixel;                   ///< whose rays are shown; none: a few of all
    std::optional<ivec2> partner;                 ///< a second one beside it
    ivec2 size{1280, 720};
    int supersample = 1;
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    std::string view;                  ///< empty: the scene's own camera
    context::Backend backend = context::Backend::automatic;
    std::filesystem::path stats; ///< empty: none
    MotionOptions motion;
    bool steps = false;    ///< all steps of the technique, one after another, in one file
    bool animate = false;  ///< all frames in one file
    image::FrameTime time; ///< how long each step, or frame, stays
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

/// Is the output one file in which several pictures follow each other?
inline bool isFilm(const CaptureOptions& options) { return options.steps || options.animate; }

/// Draws and writes what the options ask for. Throws Error.
int capture(const CaptureOptions& options);

/// The pictures alone.
int capturePictures(const CaptureOptions& options);
/// --ui: the window with its widgets around the pictures.
int captureWindow(const CaptureOptions& options);

} // namespace shadowlab::cli
