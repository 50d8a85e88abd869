// Numbers are read with from_chars: no locale may turn a point into a comma.
// SPDX-License-Identifier: MIT
#include "app/cli/option_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::cli {

namespace {

/// Reads the whole text as a number. A number too large for its type counts as one: `text` is then beyond any limit.
template <typename Number>
bool readWhole(std::string_view text, Number& value) {
    const char *begin = text.data(), *end = begin + text.size();
    const auto [last, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range && *begin != '-') value = std::numeric_limits<Number>::max();
    return error != std::errc::invalid_argument && last == end;
}

/// The ending of a name, in small letters: ".jpg".
std::string lowerEnding(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return ending;
}

} // namespace

void refuseUsage(const std::string& message) { throw Error(ExitStatus::usage, message); }

/// The ending of its name tells what is in a file; requiring it keeps a typing error from overwriting a scene or a mesh.
/// A device or a pipe may have any name.
void requireEnding(const std::string& option, const std::filesystem::path& path, const std::string& ending) {
    std::error_code ignored;
    const bool device = path.native().starts_with("/dev/") || path.native().starts_with("/proc/self/fd/");
    if (device || std::filesystem::is_fifo(path, ignored) || std::filesystem::is_directory(path, ignored)) return;
    if (lowerEnding(path) == ending) return;
    std::filesystem::path right = path;
    // A picture in another format has the wrong ending; anything else behind a point is a part of the name.
    if (endsAsPicture(path))
        right.replace_extension(ending);
    else
        right += ending;
    refuseUsage(option + ": '" + path.string() + "' does not end in " + ending + "; write " + right.string());
}

bool endsAsPicture(const std::filesystem::path& path) {
    static constexpr std::array kPictures{".png", ".jpg", ".jpeg", ".gif", ".webp", ".bmp", ".tif", ".tiff",
                                          ".ppm", ".tga", ".svg",  ".pdf", ".avif", ".mp4", ".mov", ".webm"};
    return std::ranges::find(kPictures, lowerEnding(path)) != kPictures.end();
}

ivec2 pixelFrom(const std::string& option, const std::string& text, ivec2 size) {
    ivec2 pixel(-1);
    const char *const begin = text.data(), *const end = begin + text.size();
    const auto [comma, error] = std::from_chars(begin, end, pixel.x);
    const bool pair = error == std::errc{} && comma != end && *comma == ',';
    const auto [last, errorY] = std::from_chars(pair ? comma + 1 : end, end, pixel.y);
    if (!pair || errorY != std::errc{} || last != end)
        refuseUsage(option + ": '" + text + "' is not a pixel; write its column and row, as 320,180");
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y)
        refuseUsage(option + ": '" + text + "' is outside the picture of " + std::to_string(size.x) + " x " +
                    std::to_string(size.y) + " pixels; columns are 0 to " + std::to_string(size.x - 1) +
                    ", rows 0 to " + std::to_string(size.y - 1));
    return pixel;
}

ivec2 sizeFrom(const std::string& option, const std::string& text, std::string_view limit) {
    const std::size_t cross = std::min(text.find('x'), text.size());
    const std::string width = text.substr(0, cross), height = cross < text.size() ? text.substr(cross + 1) : "";
    ivec2 size{0};
    if (!readWhole(width, size.x) || !readWhole(height, size.y) || size.x < 1 || size.y < 1)
        refuseUsage(option + ": '" + text + "' is not a size; write WIDTHxHEIGHT in pixels, as 1280x720");
    const std::uint64_t longestSide = picture::limitNamed(limit);
    if (static_cast<std::uint64_t>(std::max(size.x, size.y)) > longestSide)
        throw Error(ExitStatus::overLimit,
                    option + ": '" + text + "' is larger than " + std::to_string(longestSide) +
                        " pixels, the limit for either side; choose a smaller size, or set --limit " +
                        std::string(limit) + "=VALUE");
    return size;
}

bool booleanFrom(const std::string& option, const std::string& text) {
    if (text != "true" && text != "false")
        refuseUsage(option + ": '" + text + "' is neither true nor false; write one of them");
    return text == "true";
}

double degreesFrom(const std::string& option, const std::string& text) {
    double value = 0;
    if (!readWhole(text, value) || !(std::abs(value) <= 1e6))
        refuseUsage(option + ": '" + text + "' is not a number within ±1000000; write degrees, as 360");
    return value;
}

double secondsFrom(const std::string& option, const std::string& text) {
    constexpr double kLeastSeconds = 0.01, kMostSeconds = 60; // in milliseconds a number of 16 bits
    double seconds = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (error != std::errc{} || end != text.data() + text.size() ||
        !(seconds >= kLeastSeconds && seconds <= kMostSeconds))
        refuseUsage(option + ": '" + text +
                    "' is no time that a picture can stay; write seconds from 0.01 to 60, as 2.5");
    return seconds;
}

std::size_t megabytesFrom(const std::string& option, const std::string& text) {
    constexpr double kLeast = 0.1, kMost = 500; // larger pages are opened by no browser of a phone
    double megabytes = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), megabytes);
    if (error != std::errc{} || end != text.data() + text.size() || !(megabytes >= kLeast && megabytes <= kMost))
        refuseUsage(option + ": '" + text + "' is no size of a page; write megabytes from 0.1 to 500, as 20");
    return static_cast<std::size_t>(megabytes * 1e6);
}

int countFrom(const std::string& option, const std::string& text, int most) {
    int value = 0;
    if (!readWhole(text, value) || value < 1 || value > most)
        refuseUsage(option + ": '" + text + "' is not a whole number from 1 to " + std::to_string(most) +
                    "; write one");
    return value;
}

int limitedCountFrom(const std::string& option, const std::string& text, std::string_view limit) {
    int value = 0;
    if (!readWhole(text, value) || value < 1)
        (void)countFrom(option, text, static_cast<int>(picture::limitNamed(limit))); // refuses it
    if (static_cast<std::uint64_t>(value) > picture::limitNamed(limit))
        throw Error(ExitStatus::overLimit, option + ": " + text + " is more than the limit of " +
                                               std::to_string(picture::limitNamed(limit)) +
                                               "; write less, or set --limit " + std::string(limit) + "=VALUE");
    return value;
}

int choiceFrom(const std::string& option, const std::string& text, const std::vector<std::string>& choices) {
    const auto found = std::ranges::find(choices, text);
    if (found != choices.end()) return static_cast<int>(found - choices.begin());
    refuseUsage(option + ": '" + text + "' is not one of its values; " + suggestion(text, choices));
}

std::vector<std::string> splitAtCommas(const std::vector<std::string>& texts) {
    std::vector<std::string> parts;
    for (const std::string& text : texts)
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            parts.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    return parts;
}

} // namespace shadowlab::cli
