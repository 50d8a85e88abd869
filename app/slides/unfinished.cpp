// SPDX-License-Identifier: MIT
#include "app/slides/unfinished.h"

#include <cctype>

#include <nlohmann/json.hpp>

#include "app/session/digest.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/file_access.h"

namespace shadowlab::slides {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::uint64_t kLargestPart = 1 << 12;    // bytes; ours have some 150
constexpr std::uint64_t kLargestPicture = 1 << 30; // more than the largest slide takes, 16384 x 16384 pixels of noise

} // namespace

std::optional<std::vector<std::uint8_t>> Unfinished::find(const std::string& slide, const std::string& madeFrom,
                                                          const SlideFiles& files) const {
    try {
        const Json part = Json::parse(scene::readFile(partOf(slide), kLargestPart));
        if (part.at("madeFrom") != madeFrom || part.at("files").size() != files.size()) return std::nullopt;
        std::vector<std::uint8_t> first;
        for (std::size_t i = 0; i < files.size(); ++i) {
            const std::string bytes = scene::readFile(folder_ / files[i], kLargestPicture);
            if (part.at("files").at(i) != session::digestOf(bytes)) return std::nullopt;
            if (i == 0) first.assign(bytes.begin(), bytes.end());
        }
        return first;
    } catch (const Error&) { // not there, or not to be read: nothing is lost but the time to draw it again
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void Unfinished::keep(const std::string& slide, const std::string& madeFrom,
                      const std::vector<std::string>& digests) const {
    image::makeFolders(parts());
    image::writeWhole(partOf(slide), Json{{"madeFrom", madeFrom}, {"files", digests}}.dump() + "\n");
}

void Unfinished::discard(const std::string& slide) const {
    std::error_code ignored; // what stays is found to be old, or used again: neither does harm
    fs::remove(partOf(slide), ignored);
    fs::remove(parts(), ignored); // once it is empty
}

void Unfinished::discardDeck(const std::string& deck) const {
    std::vector<std::string> slides;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(parts(), ignored)) {
        const std::string name = entry.path().stem().string();
        const bool isOfDeck = name.starts_with(deck + "-") && name.size() > deck.size() + 1 &&
                              std::isdigit(static_cast<unsigned char>(name[deck.size() + 1]));
        if (isOfDeck && entry.path().extension() == ".json") slides.push_back(name);
    }
    for (const std::string& slide : slides)
        discard(slide);
}

} // namespace shadowlab::slides
