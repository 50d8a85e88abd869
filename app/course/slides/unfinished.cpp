// SPDX-License-Identifier: MIT
#include "app/course/slides/unfinished.h"

#include <array>

#include <nlohmann/json.hpp>

#include "app/picture/digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::course {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kMark = "slides drawn so far; the same command goes on from here"; // tells our files from others
constexpr std::uint64_t kLargestList = 1 << 18;    // bytes; a slide takes 400 at most, and a deck has up to 300
constexpr std::uint64_t kLargestPicture = 1 << 30; // more than the largest slide takes, 16384 x 16384 pixels of noise

/// The slides that stand; nothing where the file is not ours, or not there. A link would lead elsewhere, and is not ours either.
std::optional<Json> slidesIn(const fs::path& file) {
    std::error_code ignored;
    if (fs::symlink_status(file, ignored).type() != fs::file_type::regular) return std::nullopt;
    try {
        Json all = Json::parse(scene::readFile(file, kLargestList));
        if (all.at("shadowlab") != kMark || !all.at("slides").is_object()) return std::nullopt;
        return std::move(all.at("slides"));
    } catch (const Error&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void writeSlides(const fs::path& file, const Json& slides) {
    image::writeWhole(file, Json{{"shadowlab", kMark}, {"slides", slides}}.dump(1) + "\n");
}

} // namespace

bool Unfinished::isForeign() const {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file_, ignored)) && !slidesIn(file_);
}

std::optional<StandingSlide> Unfinished::find(const std::string& slide, const std::string& madeFrom,
                                              const SlideFiles& files) const {
    const std::optional<Json> slides = slidesIn(file_);
    if (!slides) return std::nullopt;
    try {
        const Json& kept = slides->at(slide);
        if (kept.at("madeFrom") != madeFrom || kept.at("files").size() != files.size()) return std::nullopt;
        const auto place = kept.at("picturesAt").get<std::array<double, 4>>();
        StandingSlide found{{}, {{place[0], place[1]}, {place[2], place[3]}}};
        for (std::size_t i = 0; i < files.size(); ++i) {
            const std::string bytes = scene::readFile(folder_ / files[i], kLargestPicture);
            if (kept.at("files").at(i) != picture::digestOf(bytes)) return std::nullopt;
            if (i == 0) found.png.assign(bytes.begin(), bytes.end());
        }
        return found;
    } catch (const Error&) { // not there, or not to be read: nothing is lost but the time to draw it again
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void Unfinished::keep(const std::string& slide, const std::string& madeFrom,
                      const std::vector<std::string>& digests, const drawing::Box& picturesAt) const {
    if (isForeign()) return;
    // Read again: other runs may draw other slides of the deck meanwhile.
    Json slides = slidesIn(file_).value_or(Json::object());
    slides[slide] = {{"madeFrom", madeFrom}, {"files", digests},
                     {"picturesAt", {picturesAt.corner.x, picturesAt.corner.y, picturesAt.size.x, picturesAt.size.y}}};
    writeSlides(file_, slides);
}

void Unfinished::discard(const std::vector<std::string>& slides) const {
    std::optional<Json> left = slidesIn(file_);
    if (!left) return;
    for (const std::string& slide : slides)
        left->erase(slide);
    if (left->empty())
        discardAll();
    else
        writeSlides(file_, *left);
}

void Unfinished::discardAll() const {
    std::error_code ignored; // what stays is found to be old, or used again: neither does harm
    if (slidesIn(file_)) fs::remove(file_, ignored);
}

} // namespace shadowlab::course
