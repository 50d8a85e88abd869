// SPDX-License-Identifier: MIT
#include "app/cli/capture/capture_outputs.h"

#include "app/cli/option_values.h"
#include "app/cli/same_file.h"
#include "app/context/assets.h"
#include "app/film/film_encoder.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::cli {

namespace {

/// The file that SCENE stands for; it may not exist.
std::filesystem::path sceneFile(const std::string& scene) {
    const std::filesystem::path path(scene);
    return path.has_extension() ? path : context::assetsRoot() / "scenes" / (scene + ".json");
}

[[noreturn]] void refuseOutput(const std::string& option, const std::filesystem::path& path, const std::string& other) {
    throw Error(ExitStatus::usage, option + ": '" + path.string() + "' is also " + other + "; choose another name");
}

} // namespace

std::filesystem::path numbered(const std::filesystem::path& pattern, int frame) {
    std::string name = pattern.filename().string();
    const std::size_t first = name.find('#');
    if (first == std::string::npos) return pattern;
    const std::size_t width = name.find_first_not_of('#', first) == std::string::npos
                                  ? name.size() - first
                                  : name.find_first_not_of('#', first) - first;
    std::string number = std::to_string(frame + 1);
    if (number.size() < width) number.insert(0, width - number.size(), '0');
    return pattern.parent_path() / name.replace(first, width, number);
}

void requirePlaceForNumbers(const CaptureOptions& options, int frames) {
    if (frames > 1 && !isFilm(options) && options.output.filename().string().find('#') == std::string::npos)
        refuseUsage("-o: '" + options.output.string() + "' has no place for the numbers of " + std::to_string(frames) +
                    " frames; write for example name_####.png, or add --animate");
}

void checkOutputs(const CaptureOptions& options) {
    const std::filesystem::path picture = numbered(options.output, 0), input = sceneFile(options.scene);
    if (isSameFile(picture, input)) refuseOutput("-o", picture, "the scene that is read");
    const std::filesystem::path& path = options.motion.path;
    if (!path.empty() && isSameFile(picture, path)) refuseOutput("-o", picture, "the path that is read");
    image::probeWritable(picture);
    if (film::isMp4(picture)) film::requireFfmpeg(picture);
    if (options.stats.empty()) return;
    if (isSameFile(options.stats, input)) refuseOutput("--stats", options.stats, "the scene that is read");
    if (!path.empty() && isSameFile(options.stats, path)) refuseOutput("--stats", options.stats, "the path that is read");
    if (isSameFile(options.stats, picture)) refuseOutput("--stats", options.stats, "the picture that is written");
    image::probeWritable(options.stats);
}

void checkFurtherOutputs(const CaptureOptions& options, int frames) {
    if (isFilm(options)) return; // all frames are in the one file
    for (int frame = 1; frame < frames; ++frame)
        image::requireNoInput(numbered(options.output, frame));
    for (int frame = 1; frame < frames && !options.stats.empty(); ++frame)
        if (const auto picture = numbered(options.output, frame); isSameFile(options.stats, picture))
            refuseOutput("--stats", options.stats, "the picture " + picture.string() + " that is written");
}

} // namespace shadowlab::cli
