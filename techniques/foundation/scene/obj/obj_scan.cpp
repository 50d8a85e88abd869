// One pass over the lines of an OBJ file, a few statement kinds, and a check at the end for indices that pointed ahead.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/unusual_characters.h"
#include "techniques/foundation/scene/obj/obj_indices.h"
#include "techniques/foundation/scene/obj/other_statements.h"
#include "techniques/foundation/scene/obj/statement_lines.h"

namespace shadowlab::scene {

namespace {

constexpr std::size_t kShownToken = 40; ///< characters of a faulty token that a message repeats

class Scanner {
public:
    Scanner(std::string_view text, const std::filesystem::path& file, const Limits& limits)
        : lines_(text, file, limits.lineBytes), limits_(limits), textBytes_(text.size()) {
        scan_.statements.reserve(text.size() / 2); // the faces are about half of most files
    }

    ObjScan run();

private:
    /// All numbers of the statement. NaN and infinity are let through for the caller to judge.
    std::size_t readNumbers(std::array<double, 8>& numbers);
    void position();
    void color(const vec3& stored);
    void smoothingGroup();
    void scaleColors();
    void normal();
    void texcoord();
    void face();
    void useMaterial();
    void useLibrary();
    void checkEnd();
    void noteUnusableNormals();

    StatementLines lines_;
    OtherStatements others_;
    const Limits& limits_;
    std::size_t textBytes_;
    ObjScan scan_;
    IndexSpace positions_{"vertex", "v"}, texcoords_{"texture coordinate", "vt"}, normals_{"normal", "vn"};
    std::vector<std::size_t> zeroNormalLines_; ///< per unusable vn, in order
    std::vector<std::uint64_t> zeroNormals_;
    std::vector<bool> normalUsed_;
    std::unordered_set<std::string> librariesSeen_, materialsSeen_;
    std::uint64_t faces_ = 0, triangles_ = 0;
    std::uint32_t group_ = 0; ///< smoothing group of the next face
};

std::size_t Scanner::readNumbers(std::array<double, 8>& numbers) {
    std::size_t count = 0;
    while (const auto token = lines_.nextToken()) {
        const auto number = readNumber(*token);
        if (!number && token->find(',') != std::string_view::npos)
            lines_.fail(inQuotes(*token, kShownToken) +
                        " is not a number; write a decimal point, as in 1.5, and blanks between numbers");
        if (!number && unusualCharacter(*token))
            lines_.fail(inQuotes(*token, kShownToken) + " is not a number" + unusualCharacterHint(*token));
        if (!number)
            lines_.fail(inQuotes(*token, kShownToken) + " is not a number; write a number such as 1.5 or -2e-3");
        if (count < numbers.size()) numbers[count] = *number;
        ++count;
    }
    return count;
}

void Scanner::position() {
    std::array<double, 8> numbers{};
    const std::size_t count = readNumbers(numbers);
    // x y z, then w, or a colour r g b, or both; w does not move the vertex.
    if (count != 3 && count != 4 && count != 6 && count != 7)
        lines_.fail("the vertex has " + counted(count, "number") + "; write x y z");
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(numbers[i]))
            lines_.fail("the vertex has a number that is not a finite number; write finite coordinates");
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(numbers[i]) > limits_.coordinate)
            lines_.fail("coordinate " + numberText(numbers[i]) + " is beyond \u00b1" + numberText(limits_.coordinate) +
                        "; rescale the model");
    scan_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    ++positions_.count;
    if (count == 7) others_.count(lines_, "v with 7 numbers is read as x y z w r g b; w is ignored");
    if (count >= 6) color(vec3(dvec3(numbers[count - 3], numbers[count - 2], numbers[count - 1])));
}

/// Colours are kept as they stand until all are known: only then is it clear whether they count to 1 or to 255.
void Scanner::color(const vec3& stored) {
    constexpr vec3 kWhite(1.0f);
    scan_.colors.resize(scan_.positions.size() - 1, kWhite); // vertices before this one had none
    scan_.colors.push_back(stored);
    if (glm::any(glm::lessThan(stored, vec3(0.0f)))) others_.count(lines_, "a vertex colour below 0 is read as 0");
    if (glm::any(glm::greaterThan(stored, vec3(255.0f)))) others_.count(lines_, "a vertex colour above 255 is read as 255");
    if (scan_.colorsInBytes == 0 && glm::any(glm::greaterThan(stored, kWhite))) scan_.colorsInBytes = lines_.line();
}

void Scanner::scaleColors() {
    if (scan_.colors.empty()) return;
    const float most = scan_.colorsInBytes > 0 ? 255.0f : 1.0f;
    for (vec3& color : scan_.colors)
        for (int channel = 0; channel < 3; ++channel)
            color[channel] = static_cast<float>(image::linearFromEncoded(std::clamp(color[channel] / most, 0.0f, 1.0f)));
    scan_.colors.resize(scan_.positions.size(), vec3(1.0f));
}

/// `s 3`: the faces from here on belong to group 3. `s off`, `s 0` and `s` alone: to none. `s on` is what some programs write of one group.
void Scanner::smoothingGroup() {
    const std::string_view word = lines_.nextToken().value_or("off");
    const double number = word == "off" ? 0 : word == "on" ? 1 : readNumber(word).value_or(-1);
    constexpr double kMost = 4294967295.0; // of 32 bits
    group_ = number >= 1 && number <= kMost ? static_cast<std::uint32_t>(number) : 0;
    if (!(number >= 0 && number <= kMost))
        others_.count(lines_, "s without a group's number (0 to 4294967295, on or off) is read as s off");
}

void Scanner::normal() {
    std::array<double, 8> numbers{};
    const std::size_t count = readNumbers(numbers);
    if (count != 3) lines_.fail("the normal has " + counted(count, "number") + "; write x y z");
    dvec3 normal(numbers[0], numbers[1], numbers[2]);
    // Divided by its largest number first, so that squaring neither overflows nor underflows.
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    const bool usable = std::isfinite(normal.x + normal.y + normal.z) && largest > 0.0;
    if (!usable) {
        zeroNormals_.push_back(scan_.normals.size());
        zeroNormalLines_.push_back(lines_.line());
    }
    scan_.normals.push_back(usable ? vec3(glm::normalize(normal / largest)) : vec3(0.0f));
    ++normals_.count;
}

void Scanner::texcoord() {
    std::array<double, 8> numbers{};
    const std::size_t count = readNumbers(numbers);
    if (count < 1 || count > 3) lines_.fail("the texture coordinate has " + counted(count, "number") + "; write u v");
    scan_.texcoords.emplace_back(numbers[0], numbers[1]); // v is 0 where it is left out; a third number is for solids
    ++texcoords_.count;
}

void Scanner::face() {
    std::uint64_t corners = 0;
    std::string& out = scan_.statements;
    out += 'f';
    while (const auto token = lines_.nextToken()) {
        if (++corners > limits_.polygonCorners)
            lines_.fail("the face has more than " + std::to_string(limits_.polygonCorners) +
                            " corners, the limit; split it, or set --limit polygon-corners=VALUE",
                        ExitStatus::overLimit);
        // v, v/vt, v//vn or v/vt/vn; an empty part after a slash means "none".
        const std::size_t slash = token->find('/');
        const std::size_t slash2 = slash == std::string_view::npos ? slash : token->find('/', slash + 1);
        const std::uint64_t v = positions_.resolve(token->substr(0, slash), lines_);
        out.append(1, ' ').append(std::to_string(v));
        if (slash == std::string_view::npos) continue;
        const std::string_view texcoord =
            token->substr(slash + 1, slash2 == std::string_view::npos ? slash2 : slash2 - slash - 1);
        if (!texcoord.empty()) out.append(1, '/').append(std::to_string(texcoords_.resolve(texcoord, lines_)));
        if (slash2 == std::string_view::npos || slash2 + 1 == token->size()) continue;
        const std::uint64_t n = normals_.resolve(token->substr(slash2 + 1), lines_);
        out.append(texcoord.empty() ? "//" : "/").append(std::to_string(n));
        if (n > normalUsed_.size() && n <= textBytes_) normalUsed_.resize(n); // more normals than bytes: refused later
        if (n <= normalUsed_.size()) normalUsed_[n - 1] = true;
    }
    if (corners < 3) lines_.fail("the face has " + counted(corners, "corner") + "; a face needs at least 3");
    out += '\n';
    if (group_ != 0) scan_.smoothingGroups.resize(faces_, 0); // faces before this one had none
    if (group_ != 0 || !scan_.smoothingGroups.empty()) scan_.smoothingGroups.push_back(group_);
    ++faces_;
    triangles_ += corners - 2;
    if (triangles_ > limits_.triangles)
        lines_.fail("more than " + std::to_string(limits_.triangles) +
                        " triangles, the limit; simplify the model, or set --limit triangles=VALUE",
                    ExitStatus::overLimit);
    if (const std::uint64_t needed = memoryForTriangles(triangles_, limits_); needed > limits_.memoryBytes)
        lines_.fail("for the " + counted(triangles_, "triangle") + " so far, " +
                        beyondMemory(needed, limits_.memoryBytes) + "; simplify the model, or set --limit memory=VALUE",
                    ExitStatus::overLimit);
}

void Scanner::useMaterial() {
    const std::string material(lines_.restOfLine());
    scan_.statements +=
        "usemtl " + material + "\n"; // without a name: what stands before the first usemtl has none either
    if (material.empty())
        others_.count(lines_, "usemtl has no name; the faces after it get the default material");
    else if (materialsSeen_.insert(material).second)
        scan_.usedMaterials.push_back({material, lines_.line()});
}

void Scanner::useLibrary() {
    const std::string library(lines_.restOfLine());
    if (library.empty()) return others_.count(lines_, "mtllib has no name and is ignored");
    if (!librariesSeen_.insert(library).second) return;
    scan_.statements += "mtllib " + std::to_string(scan_.libraries.size()) + "\n";
    scan_.libraries.push_back({library, lines_.line()});
}

void Scanner::checkEnd() {
    const IndexSpace::Ahead* first = nullptr;
    const IndexSpace* space = nullptr;
    for (const IndexSpace* candidate : {&positions_, &texcoords_, &normals_})
        if (const auto* ahead = candidate->firstOutOfRange(); ahead && (!first || ahead->line < first->line)) {
            first = ahead;
            space = candidate;
        }
    if (first) throw Error(ExitStatus::badInput, lines_.place(first->line) + ": " + space->outOfRangeMessage(*first));
    const auto refuse = [&](const std::string& message) {
        throw Error(ExitStatus::badInput, lines_.place(1) + ": " + message);
    };
    if (textBytes_ == 0) refuse("the file is empty, it has no faces; export the mesh again");
    if (others_.isCloseFault()) others_.failAtFault(lines_);
    if (positions_.count == 0 && faces_ == 0)
        refuse("is not an OBJ file (it has no v or f lines); give a Wavefront OBJ");
    if (faces_ == 0)
        refuse("the file has no faces (f lines)" + others_.firstUndrawn() + "; export the mesh with its faces");
}

void Scanner::noteUnusableNormals() {
    for (std::size_t i = 0; i < zeroNormals_.size(); ++i) {
        if (zeroNormals_[i] >= normalUsed_.size() || !normalUsed_[zeroNormals_[i]]) continue;
        if (scan_.unusableNormals++ == 0) scan_.unusableNormalLine = zeroNormalLines_[i];
    }
}

ObjScan Scanner::run() {
    while (lines_.nextStatement()) {
        const std::string_view keyword = lines_.keyword();
        if (keyword == "v")
            position();
        else if (keyword == "f" || keyword == "fo") // fo: as f was called in version 2.11 of the format
            face();
        else if (keyword == "vn")
            normal();
        else if (keyword == "vt")
            texcoord();
        else if (keyword == "s")
            smoothingGroup();
        else if (keyword == "usemtl")
            useMaterial();
        else if (keyword == "mtllib")
            useLibrary();
        else
            others_.take(lines_);
        if (others_.hasFault() && positions_.count + faces_ > 0) others_.failAtFault(lines_);
    }
    checkEnd();
    noteUnusableNormals();
    scaleColors();
    scan_.notes = others_.notes(lines_);
    return std::move(scan_);
}

} // namespace

ObjScan scanObj(std::string_view text, const std::filesystem::path& file, const Limits& limits) {
    return Scanner(text, file, limits).run();
}

} // namespace shadowlab::scene
