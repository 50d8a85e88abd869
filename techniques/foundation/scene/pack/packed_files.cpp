// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/pack/packed_files.h"

#include <algorithm>

#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::scene {

namespace {

std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

} // namespace

std::filesystem::path PackedFiles::add(const std::filesystem::path& canonical, const std::filesystem::path& folder,
                                       const std::string& name,
                                       const std::function<std::string(const std::filesystem::path& place)>& text) {
    const auto [entry, isNew] = places_.try_emplace({folder, canonical});
    if (!isNew) return entry->second;
    std::filesystem::path place = folder / name;
    for (int number = 2; !taken_.insert(inSmallLetters(place.generic_string())).second; ++number)
        place = folder / std::to_string(number) / name;
    entry->second = place;
    write(place, text(place));
    return place;
}

void PackedFiles::write(const std::filesystem::path& place, const std::string& text) {
    image::makeFolders((root_ / place).parent_path());
    image::writeWhole(root_ / place, text);
}

} // namespace shadowlab::scene
