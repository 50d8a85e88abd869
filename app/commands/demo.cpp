// `shadowlab demo`: shadow map and shadow volume side by side, as a picture in the current folder.
// SPDX-License-Identifier: MIT
#include "app/commands/command_line.h"
#include "app/commands/messages.h"

namespace shadowlab::commands {

int demo(const std::string& sceneNameOrPath) {
    CaptureOptions options;
    options.scene = sceneNameOrPath;
    options.techniques = {"shadow-map", "shadow-volume-zfail"};
    options.layout = session::Layout::side;
    options.size = {1600, 900};
    options.supersample = 2; // smooths the outlines of objects; shadow edges keep each technique's own steps
    const std::string name = std::filesystem::path(sceneNameOrPath).stem().string();
    options.output = std::filesystem::current_path() / (name + "-comparison.png");
    const int status = capture(options);
    if (status == 0) print(options.output.string() + "\n");
    return status;
}

} // namespace shadowlab::commands
