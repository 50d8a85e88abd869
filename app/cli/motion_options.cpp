// SPDX-License-Identifier: MIT
#include "app/cli/motion_options.h"

#include "app/cli/option_values.h"

namespace shadowlab::cli {

void describeMotion(DescribedOptions& add) {
    add.option("--frames", "N", "number of frames (default 1; with --path to its last key)");
    add.option("--orbit-light", "DEGREES", "turns the lights that far about the camera's target over all frames");
    add.option("--orbit-camera", "DEGREES", "turns the camera that far about its target over all frames");
    add.option(
        "--path", "FILE.json",
        "moves camera and lights: a list of {frame, camera, lights}, linear between; the first picture is frame 1");
}

MotionOptions motionOptions(const GivenOptions& given) {
    MotionOptions options;
    if (given.has("--frames")) options.frames = limitedCountFrom("--frames", given.text("--frames"), "frames");
    if (given.has("--orbit-light"))
        options.orbitLightDegrees = degreesFrom("--orbit-light", given.text("--orbit-light"));
    if (given.has("--orbit-camera"))
        options.orbitCameraDegrees = degreesFrom("--orbit-camera", given.text("--orbit-camera"));
    options.path = given.text("--path");
    if (!options.orbitLightDegrees && !options.orbitCameraDegrees) return options;
    if (options.orbitLightDegrees && options.orbitCameraDegrees)
        refuseUsage("--orbit-light and --orbit-camera both say how things move; give one of them, or both in a --path");
    const std::string orbit = options.orbitLightDegrees ? "--orbit-light" : "--orbit-camera";
    if (!options.path.empty()) refuseUsage(orbit + " and --path both say how things move; give one of them");
    if (options.frames.value_or(1) == 1)
        refuseUsage(orbit + " turns from frame to frame, and there is only one; add --frames N");
    return options;
}

film::Motion motionOf(const MotionOptions& options, const scene::Scene& scene) {
    film::Motion motion{options.frames.value_or(1), options.orbitLightDegrees, options.orbitCameraDegrees, {}};
    if (options.path.empty()) return motion;
    motion.path = film::loadPath(options.path, scene);
    motion.frames = options.frames.value_or(motion.path->lastFrame());
    return motion;
}

} // namespace shadowlab::cli
