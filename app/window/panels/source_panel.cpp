// SPDX-License-Identifier: MIT
#include "app/window/panels/source_panel.h"

#include <algorithm>
#include <cmath>

#include "app/picture/steps/stepping.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/widgets.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/frame.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

// Most lines of the sources have no more columns than this; longer ones go on in the next row.
constexpr float kColumns = 84;
constexpr float kLargestListing = 0.5f; ///< of the window's width: the picture is what the step is about
constexpr float kMostPseudocode = 0.3f; ///< of the panel's height
constexpr float kBetweenLinesEm = 0.12f;
constexpr std::size_t kNumberColumns = 4, kHangingIndent = 4, kFewestColumns = 12;

constexpr ImU32 kCurrent = IM_COL32(0xE6, 0x9F, 0x00, 0x38); ///< behind the lines of the step: the accent, faintly
constexpr ImU32 kValues = IM_COL32(0x56, 0xB4, 0xE9, 0xFF);  ///< of the picked pixel: Okabe and Ito's sky blue

std::size_t columnsOf(std::string_view text) { // UTF-8: what is no continuation begins a letter
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Of a text the bytes of its first few letters.
std::size_t bytesOf(std::string_view text, std::size_t columns) {
    std::size_t at = 0;
    for (std::size_t letter = 0; at < text.size() && letter < columns; ++letter)
        for (++at; at < text.size() && (text[at] & 0xC0) == 0x80;)
            ++at;
    return at;
}

/// Columns that all lines begin with empty: of a snippet from within a function they are no use.
std::size_t commonIndent(const std::vector<picture::StepLine>& lines) {
    std::size_t least = std::string::npos;
    for (const picture::StepLine& line : lines)
        if (!line.text.empty() && !line.text.starts_with('#'))
            least = std::min(least, line.text.find_first_not_of(' '));
    return least == std::string::npos ? 0 : least;
}

/// A line in rows of at most so many columns, broken at blanks where there are any; what goes on is indented deeper.
std::vector<std::string> rowsOf(std::string_view line, std::size_t columns) {
    std::vector<std::string> rows;
    std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string_view::npos) return {""};
    indent = std::min(indent + kHangingIndent, columns / 2);
    std::string begin;
    while (columnsOf(line) + begin.size() > columns) {
        const std::size_t fits = bytesOf(line, columns - begin.size());
        const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
        std::size_t cut = line.rfind(' ', fits);
        if (cut == std::string_view::npos || cut <= first) cut = fits; // one long word
        rows.push_back(begin + std::string(line.substr(0, cut)));
        line.remove_prefix(std::min(line.find_first_not_of(' ', cut), line.size()));
        begin.assign(indent, ' ');
    }
    if (!line.empty()) rows.push_back(begin + std::string(line));
    return rows;
}

class Rows {
public:
    explicit Rows(bool numbered)
        : column_(ImGui::CalcTextSize("M").x), begin_(numbered ? static_cast<float>(kNumberColumns + 1) * column_ : 0),
          columns_(std::max(kFewestColumns, static_cast<std::size_t>(
                                                std::max(0.0f, ImGui::GetContentRegionAvail().x - begin_) / column_))) {
    }

    /// Of a text in which every line is of the step, none is marked.
    void draw(const picture::StepLine& line, bool marks) const {
        const std::vector<std::string> rows = rowsOf(line.text, columns_);
        for (std::size_t i = 0; i < rows.size(); ++i)
            row(rows[i], line.isCurrent && marks, i == 0 && begin_ > 0 ? line.number : 0,
                line.isCurrent || !marks ? ImGui::GetColorU32(ImGuiCol_Text)
                                         : ImGui::GetColorU32(ImGuiCol_TextDisabled));
        if (line.values.empty()) return;
        const std::string indent(std::min(line.text.find_first_not_of(' '), columns_ / 2), ' ');
        for (const std::string& values : rowsOf(indent + line.values, columns_))
            row(values, line.isCurrent && marks, 0, kValues);
    }

    [[nodiscard]] std::size_t count(const std::vector<picture::StepLine>& lines) const {
        std::size_t rows = 0;
        for (const picture::StepLine& line : lines)
            rows += rowsOf(line.text, columns_).size();
        return rows;
    }

private:
    void row(const std::string& text, bool isCurrent, int number, ImU32 color) const {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetTextLineHeightWithSpacing();
        if (isCurrent)
            ImGui::GetWindowDrawList()->AddRectFilled(
                corner, {corner.x + ImGui::GetContentRegionAvail().x, corner.y + height}, kCurrent);
        if (number > 0) {
            const std::string digits = std::to_string(number);
            const float right = static_cast<float>(kNumberColumns - std::min(kNumberColumns, digits.size())) * column_;
            ImGui::GetWindowDrawList()->AddText({corner.x + right, corner.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                                                digits.c_str());
        }
        ImGui::GetWindowDrawList()->AddText({corner.x + begin_, corner.y}, color, text.c_str());
        ImGui::Dummy({0, ImGui::GetTextLineHeight()});
    }

    float column_, begin_; ///< pixels: of a letter, and where text begins
    std::size_t columns_;
};

void heading(const Theme& theme, const std::string& text) {
    ImGui::PushFont(theme.text);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", text.c_str());
    ImGui::PopFont();
}

void part(const Theme& theme, const std::string& title, const std::vector<picture::StepLine>& lines, bool numbered,
          bool marks) {
    if (lines.empty()) return;
    heading(theme, title);
    ImGui::PushFont(theme.code);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, std::round(theme.em * kBetweenLinesEm)});
    const Rows rows(numbered);
    const std::size_t indent = numbered ? commonIndent(lines) : 0;
    for (picture::StepLine line : lines) {
        if (!line.text.starts_with('#')) line.text.erase(0, indent);
        rows.draw(line, marks);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::Spacing();
}

/// Of a text without numbers, in pixels.
float heightOf(const Theme& theme, const std::vector<picture::StepLine>& lines) {
    ImGui::PushFont(theme.code);
    const float rows = static_cast<float>(Rows(false).count(lines));
    ImGui::PopFont();
    return rows * (theme.codeSize + std::round(theme.em * kBetweenLinesEm));
}

} // namespace

float SourcePanel::width(const WindowState& ui, const Theme& theme, float windowWidth) {
    if (!ui.shown.source || !theme.code) return 0;
    const float column = theme.code->CalcTextSizeA(theme.codeSize, FLT_MAX, 0, "M").x;
    const float wanted = (kColumns + kNumberColumns + 1) * column + 2 * ImGui::GetStyle().WindowPadding.x +
                         ImGui::GetStyle().ScrollbarSize;
    return std::round(std::min(wanted, windowWidth * kLargestListing));
}

void SourcePanel::update(WindowState& ui) {
    if (!source_ || reloadsRead_ != gl::shaderReloads()) source_ = SourceText::read();
    reloadsRead_ = gl::shaderReloads();
    const lab::Document& document = ui.bench.document();
    const lab::PaneState& state = ui.bench.activeState();
    lab::Pane& pane = ui.bench.pane(document.active);
    const TechniqueInfo& info = findTechnique(state.technique);
    const scene::Scene& scene = *ui.bench.shownScene();
    const std::vector<StageKey>& passes = pane.passesOf(state.technique, scene);
    const auto now = picture::stepOf(state.stage, passes, scene, document.light);
    const lab::PickedPixel& picked = ui.bench.pickedPixel();
    const bool isKnown = picked.askedFor.view.picked && picked.askedFor.state.technique == state.technique;
    shown_ = picture::stepSource(info, now ? &passInfo(info.passes, passes[*now].id) : nullptr,
                                 pane.slotFor(state).params, *source_, isKnown ? &picked.probe : nullptr);
}

void SourcePanel::draw(WindowState& ui, const Area& area, const Theme& theme) {
    update(ui);
    const lab::PaneState& state = ui.bench.activeState();
    beginIn("source", area, ImGuiWindowFlags_NoNav);
    panelTabs(ui);
    const std::string step = state.technique + " " + state.stage.text();
    if (step != shownStep_) ImGui::SetScrollY(0);
    shownStep_ = step;
    if (ui.requests.scrollSource != 0)
        ImGui::SetScrollY(ImGui::GetScrollY() + static_cast<float>(ui.requests.scrollSource * area.size.y) / 2);
    ui.requests.scrollSource = 0;
    part(theme, "Formula", shown_.formula, false, false);
    // A long procedure would leave the step's own source below the panel's end: then it is those lines of it that the step carries out.
    const bool isLong = heightOf(theme, shown_.pseudocode) > kMostPseudocode * static_cast<float>(area.size.y);
    part(theme, "Pseudocode", isLong ? picture::linesOfStep(shown_.pseudocode) : shown_.pseudocode, false, true);
    for (const picture::SourcePiece& piece : shown_.pieces)
        part(theme, piece.file, piece.lines, true, true);
    ImGui::PushTextWrapPos();
    for (const std::string& fault : shown_.faults)
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kWarning), "%s", fault.c_str());
    if (!isStepping(ui)) ImGui::TextDisabled("PageDown goes to the first step, and shows its lines of source.");
    ImGui::PopTextWrapPos();
    ImGui::End();
}

} // namespace shadowlab::window
