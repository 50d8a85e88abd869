// SPDX-License-Identifier: MIT
#include "app/foreign/export/format.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>

#include "app/context/assets.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::foreign {

std::span<const Format* const> formats() {
    static constexpr std::array kFormats{&kGltf, &kThree, &kMitsuba, &kPov, &kBlender};
    return kFormats;
}

const Format& formatNamed(const std::string& name) {
    std::vector<std::string> names;
    for (const Format* format : formats()) {
        if (format->name == name) return *format;
        names.emplace_back(format->name);
    }
    throw Error(ExitStatus::usage, "--to: '" + name + "' is no format; " + suggestion(name, names));
}

std::string templateText(const std::string& name) {
    return scene::readFile(context::assetsRoot() / "foreign" / name, scene::Limits{}.sceneFileBytes);
}

std::string filledIn(std::string text, std::string_view key, std::string_view value) {
    const std::string mark = "@" + std::string(key) + "@";
    std::size_t at = text.find(mark);
    assert(at != std::string::npos);
    for (; at != std::string::npos; at = text.find(mark, at + value.size()))
        text.replace(at, mark.size(), value);
    return text;
}

std::string shellWord(const std::string& word) {
    const auto isPlain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("._-/=:+,").find(c) != std::string_view::npos; };
    if (!word.empty() && std::ranges::all_of(word, isPlain)) return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

void writeImages(const ExportJob& job) {
    if (!job.scene.images.empty()) image::makeFolders(job.folder / "textures");
    for (const PlainImage& plain : job.scene.images)
        image::writeWhole(job.folder / plain.file, image::encodePng(plain.image, {.opaque = false, .text = {}}));
}

} // namespace shadowlab::foreign
