// The text of a frame, read from what ImGui has drawn: what of it is cut, and what lies over other text.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "app/window/screen.h"

namespace shadowlab::testing {

/// A letter as it was drawn.
struct ShownLetter {
    ImWchar code = 0;
    ImVec4 box;       ///< left, top, right, bottom in pixels
    bool isCut = false; ///< a part of it is not seen
};

inline bool isWithin(const ImVec4& inner, const ImVec4& outer, float tolerance) {
    return inner.x >= outer.x - tolerance && inner.y >= outer.y - tolerance && inner.z <= outer.z + tolerance && inner.w <= outer.w + tolerance;
}

/// All letters of the last frame, panel by panel. A letter is four vertices of its glyph's place in the atlas; where ImGui itself has
/// clipped it, only of a part of that place.
inline std::vector<ShownLetter> shownLetters() {
    struct Glyph {
        ImWchar code;
        ImVec4 uv;
    };
    std::vector<Glyph> glyphs;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) glyphs.push_back({static_cast<ImWchar>(glyph.Codepoint), {glyph.U0, glyph.V0, glyph.U1, glyph.V1}});
    std::vector<ShownLetter> letters;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer)
            for (unsigned int at = 0; at + 6 <= command.ElemCount; ++at) {
                const ImDrawIdx* const index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + at)];
                if (index[1] != index[0] + 1 || index[2] != index[0] + 2 || index[3] != index[0] || index[5] != index[0] + 3) continue;
                const ImDrawVert& low = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
                const ImDrawVert& high = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[2])];
                const ImVec4 uv(low.uv.x, low.uv.y, high.uv.x, high.uv.y);
                if (uv.x >= uv.z || uv.y >= uv.w) continue; // of one colour: no letter
                const auto glyph = std::ranges::find_if(glyphs, [&](const Glyph& one) { return isWithin(uv, one.uv, 1e-6f); });
                if (glyph == glyphs.end()) continue;
                const ImVec4 box(low.pos.x, low.pos.y, high.pos.x, high.pos.y);
                letters.push_back({glyph->code, box, !isWithin(glyph->uv, uv, 1e-6f) || !isWithin(box, command.ClipRect, 1)});
            }
    }
    return letters;
}

/// Letters as text, for messages.
inline std::string textOf(const std::vector<ShownLetter>& letters) {
    std::string text;
    for (const ShownLetter& letter : letters)
        text += letter.code < 128 ? static_cast<char>(letter.code) : '?';
    return text;
}

/// The letters that are cut, or that stand for what was cut. `ellipses`: so many are of formulas.
inline std::vector<ShownLetter> cutLetters(const std::vector<ShownLetter>& letters, int ellipses) {
    constexpr ImWchar kEllipsis = 0x2026;
    std::vector<ShownLetter> cut;
    for (const ShownLetter& one : letters)
        if (one.isCut || (one.code == kEllipsis && ellipses-- <= 0)) cut.push_back(one);
    return cut;
}

/// Letters of which another covers a good part. A bold letter is the same one twice, a little apart.
inline std::vector<ShownLetter> coveredLetters(const std::vector<ShownLetter>& letters) {
    constexpr float kMuch = 0.5f, kTouch = 2, kBoldShift = 4; // pixels, as neighbours may touch
    constexpr ImWchar kPrime = 0x2032;                              // in formulas it leans over its letter
    std::vector<ShownLetter> covered;
    for (std::size_t i = 0; i < letters.size(); ++i)
        for (std::size_t j = i + 1; j < letters.size(); ++j) {
            const ImVec4 &a = letters[i].box, &b = letters[j].box;
            const float width = std::min(a.z, b.z) - std::max(a.x, b.x), height = std::min(a.w, b.w) - std::max(a.y, b.y);
            const float smaller = std::min((a.z - a.x) * (a.w - a.y), (b.z - b.x) * (b.w - b.y));
            const bool isBold = letters[i].code == letters[j].code && std::abs(a.x - b.x) < kBoldShift && std::abs(a.y - b.y) < 1;
            const bool isPrime = letters[i].code == kPrime || letters[j].code == kPrime;
            if (!isBold && !isPrime && width > kTouch && height > kTouch && width * height > kMuch * smaller) covered.push_back(letters[i]);
        }
    return covered;
}

/// Whether all of a panel is seen without scrolling.
inline bool hasRoom(const char* panel) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(panel);
    return !window || !window->WasActive || (window->ScrollMax.x <= 0 && window->ScrollMax.y <= 0);
}

} // namespace shadowlab::testing
