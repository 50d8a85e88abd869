// Checks and clamps MTL statements line by line.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/mtl_clean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/unusual_characters.h"
#include "techniques/foundation/scene/obj/statement_lines.h"

namespace shadowlab::scene {

namespace {

/// A statement with numbers: how many, and between what.
struct NumberStatement {
    std::string_view keyword;
    std::size_t count;
    double low, high;
};

constexpr std::array kStatements{
    NumberStatement{"Kd", 3, 0.0, 1.0},  NumberStatement{"Ks", 3, 0.0, 1.0},
    NumberStatement{"Ke", 3, 0.0, 1e6},  // radiance; a million times white is brighter than any lamp
    NumberStatement{"Ns", 1, 0.0, 1e6},  // as for shininess in scene files
    NumberStatement{"Ni", 1, 0.1, 10.0}, // as for ior in scene files
    NumberStatement{"d", 1, 0.0, 1.0},   NumberStatement{"Tr", 1, 0.0, 1.0},
    NumberStatement{"Tf", 3, 0.0, 1.0},  NumberStatement{"Pm", 1, 0.0, 1.0},
    NumberStatement{"Pr", 1, 0.0, 1.0},  NumberStatement{"Ka", 3, 0.0, 1.0},
    NumberStatement{"illum", 1, 0.0, 10.0}};

/// What exporters write where nobody chose a colour: white, black, or the 0.2 that is the format's own default.
bool isUsualAmbient(const dvec3& color) { return color == dvec3(1.0) || color == dvec3(0.0) || color == dvec3(0.2); }

class Cleaner {
public:
    Cleaner(std::string_view text, const std::filesystem::path& file, const Limits& limits)
        : lines_(text, file, limits.lineBytes) {}

    CleanMtl run(std::vector<std::string>& notes) {
        while (lines_.nextStatement()) {
            const std::string keyword(lines_.keyword());
            const auto statement = std::ranges::find(kStatements, keyword, &NumberStatement::keyword);
            if (keyword == "newmtl")
                newMaterial();
            else if (statement == kStatements.end() && keyword != "map_d" && keyword != "map_Kd")
                other(keyword);
            else if (!inMaterial_)
                ignore(keyword + " stands before the first newmtl and is ignored");
            else if (statement != kStatements.end())
                numbers(*statement);
            else
                map(keyword);
        }
        endMaterial();
        if (clamped_ > 0)
            notes.push_back(lines_.place(firstClampedLine_) + ": " + firstClamped_ +
                            (clamped_ > 1 ? " (and " + counted(clamped_ - 1, "more value") + ")" : ""));
        for (const Ignored& ignored : ignored_)
            notes.push_back(lines_.place(ignored.firstLine) + ": " + ignored.what +
                            (ignored.count > 1 ? " (and " + counted(ignored.count - 1, "more time") + ")" : ""));
        if (!repeated_.empty())
            notes.push_back(lines_.place(repeatedLine_) + ": material '" + shown(repeated_) +
                            "' is defined twice; the first definition is used");
        return std::move(result_);
    }

private:
    /// Statements of one kind that change nothing here: one note tells of them all.
    struct Ignored {
        std::string what;
        std::size_t firstLine, count;
    };

    void ignore(const std::string& what) { ignore(what, lines_.line()); }

    void ignore(const std::string& what, std::size_t line) {
        const auto known = std::ranges::find(ignored_, what, &Ignored::what);
        if (known == ignored_.end())
            ignored_.push_back({what, line, 1});
        else
            ++known->count;
    }

    void newMaterial() {
        endMaterial();
        const std::string name(lines_.restOfLine());
        if (name.empty()) ignore("newmtl has no name; its material cannot be used");
        isDefinition_ = names_.insert(name).second;
        if (!name.empty() && !isDefinition_ && repeated_.empty()) {
            repeated_ = name;
            repeatedLine_ = lines_.line();
        }
        inMaterial_ = true;
        statements_ = {};
        diffuse_ = ambient_ = {};
        material_ = name;
        // Defaults first: a later statement of the file replaces them. 0.8 is the scene's default grey.
        result_.text += "newmtl " + std::to_string(result_.names.size()) + "\nKd 0.8 0.8 0.8\nNs 32\nNi 1.5\n";
        result_.names.push_back(name);
    }

    /// A newmtl that is not read as one would give its values to the material before it, and a no-break space hides any statement.
    void other(const std::string& keyword) {
        const std::string isNone = inQuotes(keyword, 40) + " is no statement of MTL";
        const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
        if (const std::string_view plain = withoutOuterBlanks(keyword); !plain.empty() && isLetter(plain.front()))
            if (const auto unusual = unusualCharacter(keyword))
                lines_.fail(isNone + ": it holds " + unusual->name + "; " + unusual->remedy);
        if (inSmallLetters(keyword) == "newmtl") lines_.fail(isNone + "; write newmtl in small letters");
        const auto isLike = [&](std::string_view known) { return inSmallLetters(keyword) == inSmallLetters(known); };
        const auto mayMean = [&](std::string_view known) { ignore(isNone + " and is ignored; " + std::string(known) + " may be meant"); };
        for (const NumberStatement& statement : kStatements)
            if (isLike(statement.keyword)) return mayMean(statement.keyword);
        for (const std::string_view map : {"map_Kd", "map_d"})
            if (isLike(map)) return mayMean(map);
        ignore(shown(keyword, 40) + " is not supported and ignored");
    }

    /// What can be judged only when all statements of a material are known.
    void endMaterial() {
        if (!inMaterial_) return;
        if (ambient_ && *ambient_ != diffuse_.value_or(dvec3(0.8)) && !isUsualAmbient(*ambient_))
            ignore("Ka is not supported and ignored; ambient light is reflected as Kd says", ambientLine_);
        if (statements_.see == 1.0 && !statements_.opacity)
            ignore("Tr 1 makes material '" + shown(material_) + "' wholly transparent, which ray tracing alone shows; if it is opaque, write d 1",
                   seeLine_);
        if (const auto& Tf = statements_.transmission; Tf && (Tf->x != Tf->y || Tf->y != Tf->z))
            ignore("the colours of Tf are not supported; its mean is used", transmissionLine_);
        if (isDefinition_) result_.more.try_emplace(material_, std::move(statements_));
    }

    void map(const std::string& keyword) {
        const std::size_t line = lines_.line();
        MtlMap parsed = parseMtlMap(onOneLine(lines_.restOfStatement()));
        parsed.place = lines_.place(line);
        if (keyword == "map_Kd" && parsed.channel != MaskChoice::Channel::alphaOrBrightness) parsed.ignored.emplace_back("-imfchan");
        for (const std::string& option : parsed.ignored)
            ignore("option " + option + " of " + keyword + " is not supported and ignored", line);
        if (parsed.file.empty()) return ignore(keyword + " names no image and is ignored", line);
        auto& kept = keyword == "map_d" ? statements_.alphaMap : statements_.diffuseMap;
        if (kept && !kept->looksLike(parsed))
            ignore("a further " + keyword + " of one material takes the place of the one before it, which is ignored", line);
        kept = std::move(parsed);
    }

    /// What tinyobjloader does not tell from what was left out.
    void keep(std::string_view keyword, const std::array<double, 3>& values) {
        const dvec3 color(values[0], values[1], values[2]);
        if (keyword == "Kd") diffuse_ = color, statements_.hasDiffuse = true;
        if (keyword == "Ka") ambient_ = color, ambientLine_ = lines_.line();
        if (keyword == "Ns") statements_.hasShininess = true;
        if (keyword == "Tf") statements_.transmission = color, transmissionLine_ = lines_.line();
        if (keyword == "Pm") statements_.metallic = values[0];
        if (keyword == "Pr") statements_.roughness = values[0];
        if (keyword == "d") statements_.opacity = values[0];
        if (keyword == "Tr") statements_.see = values[0], seeLine_ = lines_.line();
        if (keyword != "illum") return;
        statements_.illum = static_cast<int>(values[0]);
        if (statements_.illum == 0 || *statements_.illum >= 8)
            ignore("illum " + std::to_string(*statements_.illum) + " is not supported; the material is drawn as illum 2");
    }

    void numbers(const NumberStatement& statement) {
        std::array<double, 3> values{};
        std::size_t count = 0;
        while (const auto token = lines_.nextToken()) {
            if (count == 0 && (*token == "spectral" || *token == "xyz" || *token == "-halo")) // other forms
                return ignore(std::string(statement.keyword) + " " + std::string(*token) +
                              " is not supported and ignored");
            if (count == statement.count) break;
            const auto value = readNumber(*token);
            if (!value || !std::isfinite(*value))
                lines_.fail(inQuotes(*token, 40) + " in " + std::string(statement.keyword) + " is not a finite number" +
                            (unusualCharacter(*token) ? unusualCharacterHint(*token) : "; write a number such as 0.8"));
            values[count++] = clamped(*value, statement);
        }
        if (count == 0) lines_.fail(std::string(statement.keyword) + " has no number; write one after it");
        // One number for a colour means grey.
        if (count < statement.count) values[1] = count < 2 ? values[0] : values[1];
        if (count < statement.count && statement.count == 3) values[2] = values[0];
        keep(statement.keyword, values);
        result_.text += statement.keyword;
        for (std::size_t i = 0; i < statement.count; ++i)
            result_.text.append(1, ' ').append(numberText(values[i]));
        result_.text += '\n';
    }

    double clamped(double value, const NumberStatement& statement) {
        const double result = std::clamp(value, statement.low, statement.high);
        if (result != value && clamped_++ == 0) {
            firstClampedLine_ = lines_.line();
            firstClamped_ = std::string(statement.keyword) + " " + numberText(value) + " is clamped to " +
                            numberText(statement.low) + ".." + numberText(statement.high);
        }
        return result;
    }

    StatementLines lines_;
    CleanMtl result_;
    bool inMaterial_ = false, isDefinition_ = false; ///< of a name's definitions, the first one counts
    std::string material_;
    std::size_t ambientLine_ = 0, transmissionLine_ = 0, seeLine_ = 0;
    MtlStatements statements_; ///< of the material
    std::optional<dvec3> diffuse_, ambient_;
    std::set<std::string> names_;
    std::size_t clamped_ = 0, firstClampedLine_ = 0, repeatedLine_ = 0;
    std::string firstClamped_, repeated_;
    std::vector<Ignored> ignored_;
};

} // namespace

CleanMtl cleanMtl(std::string_view text, const std::filesystem::path& file, const Limits& limits,
                  std::vector<std::string>& notes) {
    return Cleaner(text, file, limits).run(notes);
}

} // namespace shadowlab::scene
