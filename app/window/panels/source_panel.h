// The step on show as text: formula, pseudocode, and the lines of source that do it, beside its picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/picture/steps/step_source.h"
#include "app/window/pictures.h"

namespace shadowlab::window {

/// Shows it, and keeps what it has read of the sources until shaders are compiled again.
class SourcePanel {
public:
    /// Pixels that it takes of a window of that width; 0 while it is not on show.
    [[nodiscard]] static float width(const WindowState& ui, const Theme& theme, float windowWidth);
    void draw(WindowState& ui, const Area& area, const Theme& theme);

    /// What it showed last.
    [[nodiscard]] const picture::StepSource& shown() const { return shown_; }

private:
    void update(WindowState& ui);

    std::optional<SourceText> source_;
    int reloadsRead_ = -1;
    picture::StepSource shown_;
    std::string shownStep_; ///< technique and stage: with another one it begins at its top
};

} // namespace shadowlab::window
