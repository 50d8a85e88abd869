// The list of statements that OBJ has, and what is said about each that matters here.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/other_statements.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

/// Statements that add something to the picture which is not drawn here.
struct Undrawn {
    std::string_view keyword, meaning;
};
constexpr std::array kUndrawn{Undrawn{"l", "lines"},
                              Undrawn{"p", "points"},
                              Undrawn{"surf", "free-form surfaces"},
                              Undrawn{"curv", "free-form curves"},
                              Undrawn{"curv2", "trimming curves"},
                              Undrawn{"bsp", "B-spline patches"},
                              Undrawn{"bzp", "Bezier patches"},
                              Undrawn{"cdc", "Cardinal curves"},
                              Undrawn{"cdp", "Cardinal patches"},
                              Undrawn{"call", "other files"},
                              Undrawn{"csh", "commands"},
                              Undrawn{"usemap", "textures"},
                              Undrawn{"maplib", "texture files"},
                              Undrawn{"shadow_obj", "other shapes for shadows"},
                              Undrawn{"trace_obj", "other shapes for reflections"},
                              Undrawn{"vc", "vertex colours"},
                              Undrawn{"vw", "vertex weights"}};

/// Statements that describe the above, or group faces: nothing is lost with them. (The OBJ format, Wavefront, version 3.0, and the
/// superseded `res` of 2.11.)
constexpr std::array<std::string_view, 23> kSilent{
    "g",    "o",    "s",    "mg", "vp",  "cstype", "deg",   "bmat",  "step",     "parm",     "end",  "con",
    "trim", "hole", "scrv", "sp", "res", "lod",    "ctech", "stech", "c_interp", "d_interp", "bevel"};

constexpr std::array<std::string_view, 5> kScanned{"v", "vn", "vt", "f", "fo"};

constexpr std::size_t kUnknownKinds = 4; ///< that get a note of their own; a text of another kind may have thousands
constexpr std::string_view kFurtherKinds = "statements of further kinds are no OBJ either, and are ignored";
constexpr std::size_t kShownKeyword = 20;

/// The keyword without invisible characters, controls and quotes before it, full-width letters narrow, all small.
std::string plainKeyword(std::string_view keyword) {
    std::string plain;
    for (std::string_view rest = keyword; !rest.empty();) {
        const std::size_t length = sequenceLength(rest);
        const std::string_view character = rest.substr(0, std::max<std::size_t>(length, 1));
        char32_t c = length == 0 ? U'\0' : codePoint(character);
        const bool isFullWidth = c >= 0xff01 && c <= 0xff5e;
        if (isFullWidth) c = c - 0xff01 + '!';
        const bool isSkipped = plain.empty() && (c <= ' ' || c == 0x7f || c == '"' || c == '\'' ||
                                                 (!isFullWidth && unusualCharacter(character)));
        if (!isSkipped) appendUtf8(plain, c);
        rest.remove_prefix(character.size());
    }
    return inSmallLetters(plain);
}

/// What the statement may have been meant as.
std::string_view meantAs(std::string_view plain) {
    if (plain.starts_with('f')) return "f";
    return plain.starts_with("vn") ? "vn" : plain.starts_with("vt") ? "vt" : "v";
}

} // namespace

void OtherStatements::take(const StatementLines& lines) {
    const std::string_view keyword = lines.keyword();
    if (std::ranges::find(kSilent, keyword) != kSilent.end()) return;
    if (const auto undrawn = std::ranges::find(kUndrawn, keyword, &Undrawn::keyword); undrawn != kUndrawn.end()) {
        const std::string what = std::string(keyword) + " (" + std::string(undrawn->meaning) + ") is not drawn";
        if (firstUndrawn_.empty()) firstUndrawn_ = ", and " + what;
        return count(lines, what);
    }

    const std::string plain = plainKeyword(keyword);
    if (plain.empty() || plain.starts_with('#')) return; // an empty line or a comment, behind an invisible character
    if (!plain.starts_with('v') && !plain.starts_with('f')) return countUnknown(lines);
    const std::string isNone = inQuotes(keyword, kShownKeyword) + " is no statement of OBJ";
    if (const auto unusual = unusualCharacter(keyword))
        rememberFault(lines, isNone + ": it holds " + unusual->name + "; " + unusual->remedy, true);
    else if (std::ranges::find(kScanned, plain) != kScanned.end())
        rememberFault(lines,
                      isNone + "; write " + plain + (inSmallLetters(keyword) == plain ? " in small letters" : " alone"),
                      true);
    else
        rememberFault(lines,
                      isNone + ", and indices would be off if it was meant as " + std::string(meantAs(plain)) +
                          "; write that and a blank, or delete the line",
                      false);
}

void OtherStatements::count(const StatementLines& lines, std::string_view what) {
    const auto known = std::ranges::find(kinds_, what, &Kind::what);
    if (known != kinds_.end())
        ++known->count;
    else
        kinds_.push_back({std::string(what), lines.line(), 1});
}

void OtherStatements::countUnknown(const StatementLines& lines) {
    const auto unusual = unusualCharacter(lines.keyword());
    const std::string what = inQuotes(lines.keyword(), kShownKeyword) +
                             (unusual ? ", with " + unusual->name + "," : std::string()) +
                             " is no statement of OBJ and is ignored";
    const bool isKnown = std::ranges::find(kinds_, what, &Kind::what) != kinds_.end();
    count(lines, isKnown || unknownKinds_ < kUnknownKinds ? std::string_view(what) : kFurtherKinds);
    if (!isKnown) ++unknownKinds_;
}

void OtherStatements::rememberFault(const StatementLines& lines, const std::string& message, bool isClose) {
    if (faultLine_ > 0) return;
    faultLine_ = lines.line();
    fault_ = message;
    isCloseFault_ = isClose;
}

void OtherStatements::failAtFault(const StatementLines& lines) const {
    throw Error(ExitStatus::badInput, lines.place(faultLine_) + ": " + fault_);
}

std::string OtherStatements::firstUndrawn() const { return firstUndrawn_; }

std::vector<std::string> OtherStatements::notes(const StatementLines& lines) const {
    std::vector<std::string> notes;
    for (const Kind& kind : kinds_)
        notes.push_back(lines.place(kind.firstLine) + ": " + kind.what +
                        (kind.count > 1 ? " (and " + counted(kind.count - 1, "more time") + ")" : ""));
    return notes;
}

} // namespace shadowlab::scene
