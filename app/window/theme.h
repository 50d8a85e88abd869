// How the window looks: type sizes, colours, distances. All lengths follow the size of the type.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include <imgui.h>

#include "techniques/foundation/image/text.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::window {

/// The faces by which formulas are set.
struct Faces {
    explicit Faces(const std::filesystem::path& folder) : upright(folder / "DejaVuSans.ttf"), bold(folder / "DejaVuSans-Bold.ttf") {}
    image::Font upright, bold;
};

struct Theme {
    float em = 16;          ///< pixels: the type size everything is measured in
    bool presenter = false; ///< large type, high contrast, for the last row of a lecture hall
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
    ImFont* code = nullptr; ///< every letter as wide as every other
    std::shared_ptr<const Faces> faces;
    // In pixels, as em is for `text`. Stored here because ImGui names them differently in each version.
    float headingSize = 20, codeSize = 14;
};

/// The type size for a window of that height on a screen of that scale (1: 96 dots an inch). Presenter mode: at least 1/32
/// of the height, which is read from the last row.
float typeSize(ivec2 windowPixels, float contentScale, bool presenter);

/// Loads the fonts at that size and sets colours and distances. The fonts have to be uploaded afterwards. `fontFile` is that of
/// texts; beside it lies DejaVuSansMono.ttf, for source. Throws Error (badInput) when one of them cannot be read.
Theme applyTheme(float em, bool presenter, const std::filesystem::path& fontFile);

/// Of the type's size: what the last row still reads in presenter mode. A text that has no room is set smaller down to it, in these steps.
constexpr float kSmallestType = 0.72f, kTypeStep = 0.04f;
/// The same theme with smaller type, for measuring what is drawn with ImGui::SetWindowFontScale(share).
Theme withType(Theme theme, float share);

/// A linear colour as ImGui takes it.
ImU32 shownColor(const vec3& linear, float alpha = 1);

// Of the window itself.
constexpr ImU32 kAccent = IM_COL32(0xE6, 0x9F, 0x00, 0xFF); ///< the current light, the picked pixel, what is chosen in a panel
constexpr ImU32 kPlateColor = IM_COL32(16, 16, 18, 230);    ///< under text on pictures (app/picture/labels.cpp)
constexpr ImU32 kPlateText = IM_COL32(245, 245, 245, 255);
// The result of a painted shadow: the colours of false lit and false shadow, and a third that differs from both.
constexpr ImU32 kPredictedRight = IM_COL32(0x00, 0x9E, 0x73, 0xC8), kPredictedMissed = IM_COL32(0xE6, 0x9F, 0x00, 0xC8),
                kPredictedWrong = IM_COL32(0x00, 0x72, 0xB2, 0xC8);
constexpr ImU32 kWarning = IM_COL32(0xD5, 0x5E, 0x00, 0xFF);

} // namespace shadowlab::window
