// The spellings tried, and the search in folders for letters of another case.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/misnamed_files.h"

#include <algorithm>
#include <charconv>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

constexpr std::size_t kLongestPath = 4096;     // PATH_MAX of Linux: nothing longer can be opened
constexpr std::size_t kListedEntries = 20'000; // of a folder: more than any model has, and listed in some 10 ms
constexpr std::size_t kTriedParts = 6;         // of an absolute path, from its end: textures lie a few folders deep

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Backslashes as Windows means them; before a blank one is an escape, as shells write it.
std::string withSlashes(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ' ') continue;
        result += text[i] == '\\' ? '/' : text[i];
    }
    return result;
}

/// C:/..., //server/... or /...: such a path says where the file was on another computer.
bool isAbsolute(std::string_view path) {
    return path.starts_with('/') || (path.size() > 2 && isLetter(path[0]) && path[1] == ':');
}

/// The last parts of a path, the longest first, such as tex/leaf.png and leaf.png.
std::vector<std::string> endsOf(std::string_view path) {
    std::vector<std::string> ends;
    for (std::size_t end = path.size(); end > 0 && ends.size() < kTriedParts;) {
        const std::size_t slash = path.rfind('/', end - 1);
        if (slash == std::string_view::npos) break;
        if (slash + 1 < end) ends.emplace_back(path.substr(slash + 1));
        end = slash;
    }
    std::ranges::reverse(ends);
    return ends;
}

std::optional<char> byteOfHex(std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 2 || end != digits.data() + 2 || error != std::errc() || value == 0) return std::nullopt;
    return static_cast<char>(value);
}

/// The path of a web address of a file: without `file:` and the computer's name, and with the characters that %20 and its like stand for.
std::string withoutUrl(std::string_view path) {
    constexpr std::string_view kScheme = "file:";
    if (inSmallLetters(path.substr(0, kScheme.size())) == kScheme) {
        path.remove_prefix(kScheme.size());
        for (const std::string_view start : {"//localhost", "//"})
            if (path.starts_with(start)) {
                path.remove_prefix(start.size());
                break;
            }
    }
    std::string result;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto byte = path[i] == '%' ? byteOfHex(path.substr(i + 1, 2)) : std::nullopt;
        result += byte.value_or(path[i]);
        if (byte) i += 2;
    }
    return result;
}

std::vector<std::string> spellings(const std::string& reference) {
    std::vector<std::string> result;
    const auto add = [&](std::string spelling) {
        if (!spelling.empty() && std::ranges::find(result, spelling) == result.end())
            result.push_back(std::move(spelling));
    };
    for (const std::string_view text : {std::string_view(reference), withoutComment(reference)}) {
        add(std::string(text));
        const std::string plain(unquoted(text));
        add(plain);
        const std::string path = withSlashes(plain);
        for (const std::string& spelling : {path, withSlashes(withoutUrl(path))}) {
            add(spelling);
            if (isAbsolute(spelling))
                for (std::string& end : endsOf(spelling))
                    add(std::move(end));
        }
    }
    return result;
}

char32_t small(char32_t c) {
    if ((c >= 'A' && c <= 'Z') || (c >= 0xc0 && c <= 0xde && c != 0xd7)) return c + 0x20; // ASCII, Latin-1
    if ((c >= 0x391 && c <= 0x3a9) || (c >= 0x410 && c <= 0x42f)) return c + 0x20;        // Greek, Cyrillic
    return c >= 0x400 && c <= 0x40f ? c + 0x50 : c;                                       // further Cyrillic ones
}

} // namespace

std::string_view withoutComment(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == '#' && (text[i - 1] == ' ' || text[i - 1] == '\t')) return withoutOuterBlanks(text.substr(0, i));
    return text;
}

std::string inSmallLetters(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        if (length > 0)
            appendUtf8(result, small(codePoint(text.substr(0, length))));
        else
            result += text.front();
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

bool MisnamedFiles::isThere(const std::string& reference) const {
    std::error_code ignored;
    const auto file = folders_.resolve(reference);
    return file && std::filesystem::exists(*file, ignored);
}

std::optional<std::string> MisnamedFiles::find(const std::string& reference, const std::string& inFolder) {
    alike_.clear();
    if (reference.size() > kLongestPath || reference.find('\0') != std::string::npos) return std::nullopt;
    for (const std::string& spelling : spellings(reference))
        if (auto found = inAnyCase(spelling, inFolder)) {
            alike_.clear();
            return found;
        }
    return std::nullopt;
}

std::string MisnamedFiles::asFound(const std::string& reference) {
    return isThere(reference) ? reference : find(reference).value_or(reference);
}

std::optional<std::string> MisnamedFiles::inAnyCase(const std::string& reference, const std::string& inFolder) {
    if (std::filesystem::path(reference).is_absolute()) return std::nullopt; // tried as written, and by its ends
    std::filesystem::path found(inFolder);
    std::error_code ignored;
    for (const std::filesystem::path& part : std::filesystem::path(reference)) {
        if (part.empty() || part == ".") continue;
        // A folder above may be outside where the next part leads back inside: only what is resolved and listed must be inside.
        const std::filesystem::path next = found / part;
        if (part == "..") {
            found = next;
            continue;
        }
        const auto resolved = folders_.resolve(next.native());
        if (!resolved) return std::nullopt;
        if (std::filesystem::exists(*resolved, ignored)) {
            found = next;
            continue;
        }
        const auto folder = folders_.resolve(found.empty() ? "." : found.native());
        if (!folder) return std::nullopt;
        const Listing& names = listing(*folder);
        const auto alike = names.find(inSmallLetters(part.native()));
        if (alike == names.end()) return std::nullopt;
        if (alike->second.size() > 1) {
            alike_ = alike->second;
            return std::nullopt;
        }
        found /= alike->second.front();
    }
    const auto file = folders_.resolve(found.native()); // the links of the last part are followed, too
    if (!file || !std::filesystem::is_regular_file(*file, ignored)) return std::nullopt;
    return found.native();
}

std::string MisnamedFiles::severalAlike() const {
    if (alike_.empty()) return {};
    const auto [first, last] = std::ranges::minmax(alike_); // folders are listed in no defined order
    return " (" + inQuotes(first) + " and " + inQuotes(last) + " differ from it in case alone)";
}

const MisnamedFiles::Listing& MisnamedFiles::listing(const std::filesystem::path& canonicalFolder) {
    const auto [entry, isNew] = listings_.try_emplace(canonicalFolder);
    if (!isNew) return entry->second;
    std::error_code error;
    std::size_t count = 0;
    for (std::filesystem::directory_iterator file(canonicalFolder, error), end; !error && file != end;
         file.increment(error)) {
        if (++count > kListedEntries) break;
        const std::string name = file->path().filename().native();
        entry->second[inSmallLetters(name)].push_back(name);
    }
    return entry->second;
}

void MisnamedFilesNote::add(const std::string& place, const std::string& written, const std::string& found) {
    if (std::ranges::find(written_, written) != written_.end()) return;
    if (written_.empty())
        first_ = place + ": " + what_ + " " + inQuotes(written) + " is not there; " + inQuotes(found) +
                 " is read in its place";
    written_.push_back(written);
}

void MisnamedFilesNote::appendTo(std::vector<std::string>& notes) const {
    if (written_.empty()) return;
    const std::size_t others = written_.size() - 1;
    notes.push_back(first_ + (others > 0 ? " (and so for " + counted(others, "other name") + ")" : ""));
}

} // namespace shadowlab::scene
