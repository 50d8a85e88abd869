// SPDX-License-Identifier: MIT
#include "app/picture/steps/step_source.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "techniques/foundation/base/error.h"

namespace shadowlab::picture {

namespace {

// Around a snippet: what is said of it right before its anchor. No more fits beside a picture.
constexpr int kLinesBefore = 3;
constexpr int kMostBetween = 3; ///< lines between two snippets of one file that are shown with them

constexpr LineRange kAllLines{1, 1 << 20};

const Probe::Fact* factIn(const std::vector<Probe::Fact>& facts, std::string_view label) {
    const auto found = std::ranges::find(facts, label, &Probe::Fact::label);
    return found == facts.end() ? nullptr : &*found;
}

/// Of the pixel itself, else of the first ray of its tree that has it.
const Probe::Fact* factOf(const Probe& probe, std::string_view label) {
    if (const Probe::Fact* fact = factIn(probe.facts, label)) return fact;
    for (const Probe::Node& node : probe.tree)
        if (const Probe::Fact* fact = factIn(node.facts, label)) return fact;
    return nullptr;
}

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Does the name stand in the line, and not as a part of a longer one?
bool holds(std::string_view line, std::string_view name) {
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool begins = at == 0 || !isOfWord(line[at - 1]) || !isOfWord(name.front());
        const bool ends = end == line.size() || !isOfWord(line[end]) || !isOfWord(name.back());
        if (begins && ends) return true;
    }
    return false;
}

/// Of an equation it is said what it is, not what it is equal to.
bool isEquation(std::string_view text) { return text.find('=') != std::string_view::npos; }

/// Says the values of names where they are met first.
class ShownValues {
public:
    /// Of a step; without one of the whole. What the step itself says of a name comes first.
    ShownValues(const TechniqueInfo& info, const PassInfo* pass, const Probe* probe) : probe_(probe) {
        if (pass) named_.assign(pass->values.begin(), pass->values.end());
        for (const NamedValue& value : info.values)
            if (std::ranges::find(named_, value.name, &NamedValue::name) == named_.end()) named_.push_back(value);
    }

    std::string of(std::string_view line) {
        std::string values;
        if (!probe_) return values;
        for (const auto& [name, label] : named_) {
            if (said_.contains(name) || !holds(line, name)) continue;
            const Probe::Fact* fact = factOf(*probe_, label);
            if (!fact) continue;
            said_.insert(name);
            values += (values.empty() ? "" : ", ") + std::string(name) +
                      (isEquation(name) || isEquation(fact->value) ? ": " : " = ") + fact->value +
                      (fact->unit.empty() ? "" : " " + fact->unit);
        }
        return values;
    }

private:
    std::vector<NamedValue> named_;
    const Probe* probe_;
    std::set<std::string_view> said_;
};

std::vector<StepLine> textLines(std::string_view text, LineRange current, ShownValues values) {
    std::vector<StepLine> lines;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) {
        const int number = static_cast<int>(lines.size()) + 1;
        const bool isCurrent = number >= current.first && number <= current.last;
        lines.push_back({number, line, isCurrent, isCurrent ? values.of(line) : ""});
    }
    return lines;
}

bool isUsed(const AnchorUse& use, const params::ParamList& params) {
    if (use.parameter.empty()) return true;
    const auto param = std::ranges::find(params, use.parameter, &params::Param::id);
    return param != params.end() && params::valueText(*param) == use.value;
}

/// A piece that almost reaches the one before, in the same file, becomes a part of it.
void addPiece(StepSource& step, const Snippet& snippet, const std::vector<std::string>& file, ShownValues& values) {
    const int last = snippet.lines.last;
    int first = snippet.lines.first - 1; // the anchor
    const auto isComment = [&](int number) {
        const std::string& line = file[static_cast<std::size_t>(number) - 1];
        const std::size_t begin = line.find_first_not_of(' ');
        return begin != std::string::npos && line.compare(begin, 2, "//") == 0;
    };
    while (first > 1 && first > snippet.lines.first - 1 - kLinesBefore && isComment(first - 1))
        --first;
    const bool goesOn = !step.pieces.empty() && step.pieces.back().file == snippet.file &&
                        step.pieces.back().lines.back().number + 1 + kMostBetween >= first &&
                        step.pieces.back().lines.front().number <= first;
    if (!goesOn) step.pieces.push_back({snippet.file, {}, {}});
    SourcePiece& piece = step.pieces.back();
    piece.anchors.push_back(snippet.anchor);
    const int begin = goesOn ? piece.lines.back().number + 1 : first;
    for (int number = begin; number <= last; ++number)
        if (const std::string& line = file[static_cast<std::size_t>(number) - 1]; line.find("// [anchor: ") == std::string::npos)
            piece.lines.push_back({number, line, false, ""});
    for (StepLine& line : piece.lines) {
        if (line.isCurrent || line.number < snippet.lines.first || line.number > snippet.lines.last) continue;
        line.isCurrent = true;
        line.values = values.of(line.text);
    }
}

} // namespace

StepSource stepSource(const TechniqueInfo& info, const PassInfo* pass, const params::ParamList& params,
                      const SourceText& source, const Probe* probe) {
    StepSource step;
    step.pseudocode = textLines(info.pseudocode, pass ? pass->pseudocodeLines : LineRange(), {info, pass, probe});
    if (!pass) return step;
    step.formula = textLines(pass->formula, kAllLines, {info, pass, probe});
    ShownValues values(info, pass, probe);
    for (const AnchorUse& use : anchorsOf(*pass)) {
        if (!isUsed(use, params)) continue;
        try {
            const Snippet& snippet = source.at(use.anchor);
            addPiece(step, snippet, source.lines(snippet.file), values);
        } catch (const Error& fault) {
            step.faults.emplace_back(fault.what());
        }
    }
    return step;
}

std::vector<StepLine> linesOfStep(const std::vector<StepLine>& lines) {
    if (std::ranges::none_of(lines, &StepLine::isCurrent)) return lines;
    std::vector<StepLine> kept;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].isCurrent)
            kept.push_back(lines[i]);
        else if (i == 0 || lines[i - 1].isCurrent)
            kept.push_back({.number = lines[i].number, .text = "...", .values = {}});
    return kept;
}

} // namespace shadowlab::picture
