// What the window shows, as plain values: the scene and its camera, the layout, and what each pane shows. Undo restores
// an earlier document; a screenshot writes it to a file.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/lab/pane.h"
#include "app/picture/figure.h"

namespace shadowlab::lab {

constexpr int kPanes = 4; ///< of the grid; the other layouts show the first, or the first two of them

struct Document {
    scene::Snapshot scene; ///< as edited, at rest
    std::string sceneName; ///< as the command line takes it
    scene::Camera camera;
    scene::Camera outsideCamera; ///< the second camera, which shows the scene, the eye and its rays from outside
    picture::OutsideChoice outsideChoice; ///< what it shows of the techniques; its caster follows the selection
    picture::Layout layout = picture::Layout::split;
    double split = 0.5;           ///< share of the width that the left pane has
    std::optional<dvec2> picked;  ///< the picked pixel: a place (pixelAt), the same thing in the scene whatever the picture's shape
    std::optional<dvec2> partner; ///< a second one beside it, never alone
    int light = 0;                ///< the light that stages and errors are about
    int active = 0;               ///< the pane that keys and panels are about
    std::array<PaneState, kPanes> panes;
    friend bool operator==(const Document&, const Document&) = default;
};

/// The document that a scene is first shown with: shadow map beside shadow volume; other techniques in the panes behind them.
Document newDocument(scene::Snapshot scene, std::string sceneName);

/// Where the second camera stands at first.
scene::Camera outsideCameraOf(const scene::Scene& scene, const scene::Camera& eye);

/// A place in what a camera sees: shares of the width and height of a picture of 16 : 9, which lie beyond 0 and 1 in a wider one. A
/// camera's angle is that of a picture's height, so pictures of other shapes show more or less at their sides: shares of each would be
/// other points of the scene.
inline constexpr double kPlacesAspect = 16.0 / 9;
dvec2 placeOf(const dvec2& share, const dvec2& size);
/// Where a place is in a picture of that size: shares of its width and height.
dvec2 shareOf(const dvec2& place, const dvec2& size);
/// Does a picture of that size show the place? A narrow one may end before it.
bool isInPicture(const dvec2& place, ivec2 size);
/// The pixel at a place; where the picture ends before it, the last one.
ivec2 pixelAt(const dvec2& place, ivec2 size);

/// How many panes the layout shows, from the first.
int shownPanes(picture::Layout layout);

/// Earlier states, in order, and those that were undone.
class UndoHistory {
public:
    /// Call before a change: what is there now can be brought back. Changes of one gesture, a drag or a slider, have one
    /// name, and only the first of a run of equal names is kept.
    void remember(const Document& before, const std::string& gesture);
    /// The run of equal names ends: the button is up, the key released.
    void endGesture() { gesture_.clear(); }
    [[nodiscard]] bool canUndo() const { return !past_.empty(); }
    [[nodiscard]] bool canRedo() const { return !future_.empty(); }
    Document undo(const Document& now);
    Document redo(const Document& now);
    void clear();

private:
    static constexpr std::size_t kMost = 200; ///< snapshots share what they have in common, so a step is small
    std::vector<Document> past_, future_;
    std::string gesture_;
};

} // namespace shadowlab::lab
