// SPDX-License-Identifier: MIT
#include "app/commands/motion_options.h"

namespace shadowlab::commands {

void describeMotion(CLI::App& command) {
    addOption(command, "--frames", "N", "number of frames (default 1)");
    addOption(command, "--orbit-light", "DEGREES",
              "turns the lights that far about the camera's target over all frames");
    addOption(command, "--orbit-camera", "DEGREES", "turns the camera that far about its target over all frames");
}

MotionOptions motionOptions(const GivenOptions& given) {
    MotionOptions options;
    if (given.has("--frames")) options.frames = countFrom("--frames", given.text("--frames"), kMostFrames);
    if (given.has("--orbit-light"))
        options.orbitLightDegrees = degreesFrom("--orbit-light", given.text("--orbit-light"));
    if (given.has("--orbit-camera"))
        options.orbitCameraDegrees = degreesFrom("--orbit-camera", given.text("--orbit-camera"));
    const bool turns = options.orbitLightDegrees || options.orbitCameraDegrees;
    if (turns && options.frames.value_or(1) == 1)
        refuseUsage(std::string(options.orbitLightDegrees ? "--orbit-light" : "--orbit-camera") +
                    " turns from frame to frame, and there is only one; add --frames N");
    return options;
}

session::Motion motionOf(const MotionOptions& options, const scene::Scene&) {
    return {options.frames.value_or(1), options.orbitLightDegrees, options.orbitCameraDegrees};
}

} // namespace shadowlab::commands
