// What only the window writes, written without one, for the walk of faults: writer_trial WHAT FOLDER. And a writer as
// they are often written, which the walk has to find at fault.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "app/context/assets.h"
#include "app/course/slide_file.h"
#include "app/lab/document.h"
#include "app/window/window_settings.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"

namespace {

using namespace shadowlab;

void saveSlideOf(const std::string& scene, const std::string& folder) {
    const scene::LoadOptions loading{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
    const lab::Document document = lab::newDocument(scene::loadScene(scene, loading), scene);
    course::saveSlide(document, *document.scene, folder, loading);
}

/// Straight into the file, and nothing that fails is noticed.
void writeCarelessly(const std::string& file) {
    const std::string_view text = "{\"a\": 1, \"b\": 2}\n";
    const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (::write(out, text.data(), text.size()) < 0) return;
    ::close(out);
}

} // namespace

int main(int count, char** words) {
    const std::string_view what = count == 3 ? words[1] : "";
    const std::string folder = count == 3 ? words[2] : "";
    try {
        if (what == "window-settings") {
            window::writeWindowMemory(folder + "/deeper/window.json", {});
        } else if (what == "slide") {
            saveSlideOf("still-life", folder);
        } else if (what == "careless") {
            writeCarelessly(folder + "/careless.json");
        } else {
            std::fputs("writer_trial: window-settings, slide or careless, and a folder\n", stderr);
            return 2;
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "shadowlab: %s\n", error.what());
        return static_cast<int>(error.status());
    }
    return 0;
}
