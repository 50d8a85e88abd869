// SPDX-License-Identifier: MIT
#include "app/window/window_files.h"

#include <algorithm>
#include <cctype>

#include "app/context/assets.h"
#include "app/course/capture_arguments.h"
#include "app/course/slide_file.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/scene_file.h"

namespace shadowlab::window {

std::filesystem::path WindowFiles::freeName(const std::vector<std::string>& endings) const {
    const std::string stem = ui_.bench.shownScene()->name;
    for (int number = 1;; ++number) {
        const std::filesystem::path path = course::currentFolder() / (stem + "-" + std::to_string(number));
        const bool taken = std::ranges::any_of(endings, [&](const std::string& ending) {
            std::error_code ignored;
            return std::filesystem::exists(path.string() + ending, ignored);
        });
        if (!taken) return path;
    }
}

std::string WindowFiles::sceneText() const {
    return scene::sceneText(*ui_.bench.shownScene(), ui_.bench.document().camera, course::currentFolder());
}

void WindowFiles::saveScene() {
    try {
        const image::FolderLock alone(course::currentFolder()); // two windows choose two names
        const std::filesystem::path file = freeName({".json"}).string() + ".json";
        image::writeWhole(file, sceneText());
        screen_.say("saved " + scene::shownPath(file));
    } catch (const std::exception& fault) {
        screen_.complain(fault.what());
    }
}

void WindowFiles::saveScreenshot() {
    try {
        const ivec2 size = screen_.pictureSize();
        if (std::min(size.x, size.y) < 1)
            throw Error(ExitStatus::usage, "there is no room for a picture in this window; make it larger");
        const image::FolderLock alone(course::currentFolder());
        const std::string stem = freeName({".json", ".png", ".txt"}).string();
        image::writeWhole(stem + ".json", sceneText());
        std::vector<std::string> words =
            course::captureArguments(ui_.bench.document(), stem + ".json", stem + ".png", size);
        for (const std::filesystem::path& folder :
             scene::foldersToAllow(*ui_.bench.shownScene(), course::currentFolder(), context::assetsRoot()))
            words.insert(words.end(), {"--allow", folder.string()});
        image::writeWhole(stem + ".txt", "shadowlab " + course::asCommandLine(words) + "\n");
        screen_.say("saving " + scene::shownPath(stem + ".png"));
        program_.start(std::move(words));
    } catch (const std::exception& fault) {
        screen_.complain(fault.what());
    }
}

void WindowFiles::discardScreenshot(const OwnProgram::Ended& ended) {
    std::error_code ignored;
    for (const char* ending : {".json", ".txt"})
        std::filesystem::remove(std::filesystem::path(ended.words[3]).replace_extension(ending), ignored);
    constexpr std::string_view kProgram = "shadowlab: ";
    const std::size_t begin = ended.message.starts_with(kProgram) ? kProgram.size() : 0;
    screen_.complain("the picture was not saved: " + ended.message.substr(begin));
}

bool WindowFiles::takeWhatArrived() {
    const auto ended = program_.take();
    if (!ended) return false;
    screen_.withdraw("saving ");
    if (ended->status == 0)
        screen_.say("saved " + scene::shown(ended->words[3]) + " and beside it the scene and the command line");
    else
        discardScreenshot(*ended);
    return true;
}

void WindowFiles::openDropped(int count, const char** paths) {
    for (int i = 0; i < count; ++i) {
        const std::string dropped = scene::shown(paths[i]);
        if (dropped.find("://") != std::string::npos) {
            screen_.complain(dropped + ": is an address and no file; save it, and drop the file");
            continue;
        }
        std::error_code failed;
        const std::filesystem::path path = std::filesystem::absolute(paths[i], failed);
        if (failed) {
            screen_.complain(dropped + ": cannot be found: " + failed.message() + "; drop it from another folder");
            continue;
        }
        if (scene::fileKind(path) != scene::FileKind::none)
            ui_.requests.scene = path.string();
        else
            screen_.complain(scene::shownPath(path) + ": neither a .json scene nor a mesh (.obj, .gltf, .glb); drop one of these");
    }
}

} // namespace shadowlab::window
