// SPDX-License-Identifier: MIT
#include "app/student/blanks.h"

#include <algorithm>
#include <sstream>

#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/json/json_object.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::student {

namespace {

constexpr std::size_t kLineWidth = 120; // of the comments in a blank: as wide as the source around them
constexpr std::uint32_t kNesting = 8;   // of the data file: an object, its blanks, and their lists of lines

std::string withoutIndent(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? "" : line.substr(begin);
}

/// The strings of an array; of a long text each is a part of it.
std::vector<std::string> textLines(const scene::JsonObject& object, std::string_view key) {
    std::vector<std::string> lines;
    for (const scene::JsonValue& item : object.array(key)) {
        if (item.kind != scene::JsonValue::Kind::string)
            object.fail(key, "has an item that is no text; put it into quotation marks");
        lines.push_back(item.string);
    }
    return lines;
}

Blank readBlank(const scene::JsonDocument& document, const scene::JsonValue& value, std::size_t number) {
    const scene::JsonObject object(document, value, "blank " + std::to_string(number),
                                   {"anchor", "first", "last", "idea", "explanation", "whenRight", "standIn"});
    Blank blank;
    blank.anchor = object.text("anchor");
    blank.first = object.text("first");
    blank.last = object.text("last", blank.first);
    blank.idea = object.text("idea");
    for (const std::string& part : textLines(object, "explanation"))
        blank.explanation += (blank.explanation.empty() ? "" : " ") + part;
    if (blank.explanation.empty()) object.fail("explanation", "is missing; write it as an array of texts");
    blank.whenRight = object.text("whenRight");
    blank.standIn = textLines(object, "standIn");
    blank.place = document.place(value.offset);
    return blank;
}

/// The text as lines of a comment, each with that indentation.
std::vector<std::string> asComment(const std::string& text, const std::string& indent) {
    std::vector<std::string> lines;
    std::string line = indent + "//";
    std::istringstream words(text);
    for (std::string word; words >> word; line += " " + word) {
        if (line.size() + 1 + word.size() <= kLineWidth) continue;
        lines.push_back(line);
        line = indent + "//";
    }
    lines.push_back(line);
    return lines;
}

std::vector<std::string> linesOfBlank(const Blank& blank, std::size_t number, const std::string& indent) {
    const std::string name = "BLANK " + std::to_string(number);
    std::vector<std::string> lines = asComment("=== " + name + ": " + blank.idea + ". " + blank.explanation +
                                                   " When it is right, " + blank.whenRight + ".",
                                               indent);
    for (const std::string& line : blank.standIn)
        lines.push_back(indent + line);
    lines.push_back(indent + "// === END OF " + name);
    return lines;
}

} // namespace

Skeleton readSkeleton(const std::filesystem::path& file) {
    if (const std::string why = scene::whyUnreadable(file); !why.empty())
        throw Error(ExitStatus::badInput, file.string() + ": " + why + "; install shadowlab again");
    const scene::JsonDocument document(scene::readFile(file, picture::limits().sceneFileBytes), file, kNesting,
                                       "a skeleton, starting with {");
    const scene::JsonObject object(document, document.root(), "the skeleton",
                                   {"source", "family", "title", "scene", "blanks"});
    Skeleton skeleton{object.text("source"), object.text("family"), object.text("title"), object.text("scene"), {}};
    for (const scene::JsonValue& value : object.array("blanks"))
        skeleton.blanks.push_back(readBlank(document, value, skeleton.blanks.size() + 1));
    if (skeleton.blanks.empty()) object.fail("blanks", "has none; describe at least one");
    return skeleton;
}

SourceText asSourceText(const SourceFiles& files) {
    SourceText source;
    for (const auto& [name, text] : files)
        source.add(name, text);
    return source;
}

BlankedLines findLines(const SourceFiles& files, const Blank& blank) {
    const SourceText source = asSourceText(files);
    const Snippet& region = [&]() -> const Snippet& {
        try {
            return source.at(blank.anchor);
        } catch (const Error& fault) {
            throw Error(ExitStatus::badInput, blank.place + ": " + fault.what());
        }
    }();
    const std::vector<std::string>& lines = source.lines(region.file);
    const auto onlyOne = [&](const std::string& wanted) {
        std::vector<std::size_t> found;
        for (auto i = static_cast<std::size_t>(region.lines.first - 1); i < static_cast<std::size_t>(region.lines.last);
             ++i)
            if (withoutIndent(lines[i]) == withoutIndent(wanted)) found.push_back(i);
        if (found.size() != 1)
            throw Error(ExitStatus::badInput, blank.place + ": the line '" + wanted + "' stands " +
                                                  std::to_string(found.size()) + " times in " + region.file +
                                                  " after the anchor '" + blank.anchor +
                                                  "'; name a line that stands there once");
        return found.front();
    };
    const BlankedLines range{region.file, onlyOne(blank.first), onlyOne(blank.last)};
    if (range.last < range.first)
        throw Error(ExitStatus::badInput,
                    blank.place + ": its last line stands before its first one in " + region.file + "; exchange them");
    return range;
}

void makeBlanks(SourceFiles& files, const std::vector<Blank>& blanks) {
    struct Placed {
        std::size_t last, number;
    };
    std::map<std::string, std::map<std::size_t, Placed>> placed; // by file and first line
    for (std::size_t i = 0; i < blanks.size(); ++i) {
        const BlankedLines range = findLines(files, blanks[i]);
        for (const auto& [first, other] : placed[range.file])
            if (range.first <= other.last && first <= range.last)
                throw Error(ExitStatus::badInput, blanks[i].place + ": it shares lines of " + range.file +
                                                      " with blank " + std::to_string(other.number) +
                                                      "; let one of them end before the other begins");
        placed[range.file].emplace(range.first, Placed{range.last, i + 1});
    }
    const SourceText source = asSourceText(files);
    for (const auto& [file, ranges] : placed) {
        const std::vector<std::string>& lines = source.lines(file);
        std::string text;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto blank = ranges.find(i);
            if (blank == ranges.end()) {
                text += lines[i] + "\n";
                continue;
            }
            const auto& [last, number] = blank->second;
            const std::string indent(lines[i].find_first_not_of(' '), ' ');
            for (const std::string& line : linesOfBlank(blanks[number - 1], number, indent))
                text += line + "\n";
            i = last;
        }
        files.at(file) = text;
    }
}

} // namespace shadowlab::student
