// The lab itself, without window and widgets: a document, the panes that draw it, and what the user may do to it. The window
// shows its pictures and turns keys into calls; headless pictures of the window and tests use the same.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/lab/animation.h"
#include "app/lab/document.h"
#include "app/lab/pane.h"

namespace shadowlab::lab {

/// A pane in the window's picture area.
struct PlacedPane {
    int pane = 0;
    picture::Cell cell;
};

/// A pixel, and its probe.
struct PickedPixel {
    PaneRequest askedFor;
    Probe probe;
    double tookMs = 0;
};

class Workbench {
public:
    /// Needs a current GL context for its whole life.
    explicit Workbench(Document document);

    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const Animation& animation() const { return animation_; }
    /// The scene as it is now: where animation has brought it.
    [[nodiscard]] const scene::Snapshot& shownScene() const { return shown_; }
    /// Boxes around its objects, in their order.
    [[nodiscard]] const std::vector<scene::Bounds>& bounds();
    [[nodiscard]] const Pane& pane(int i) const { return panes_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Pane& pane(int i) { return panes_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const PaneState& activeState() const { return document_.panes[static_cast<std::size_t>(document_.active)]; }
    [[nodiscard]] picture::Session& session() { return session_; }
    [[nodiscard]] const picture::PictureEncoder& encoder() const { return encoder_; }

    /// What of the picture area is used: panes of a grid are all of one size, so that one truth serves them all.
    [[nodiscard]] ivec2 shownSize(ivec2 areaSize) const;
    /// The panes of the layout, in a picture area of that size. Empty where the area is too small for them.
    [[nodiscard]] std::vector<PlacedPane> placed(ivec2 areaSize) const;
    /// What a placed pane has to show, drawn with 1 / `draft` of the pixels in each direction. In the layout `split` that is the
    /// band that is seen, so that the window reacts soon. But a pane that is to be judged is drawn whole: verdicts are of whole
    /// pictures, so that they are the same numbers in every layout. At rest all are judged, and then the split line is dragged
    /// over pictures that are already there. In the layout `diff` panes show the finished picture, whatever their stage.
    [[nodiscard]] PaneRequest requestFor(const PlacedPane& placed, int draft = 1) const;

    /// Draws what has changed. `areaSize` is the picture area in pixels. Returns true if anything was drawn. Work that is
    /// not done by the deadline goes on in the next call.
    bool update(ivec2 areaSize, Deadline deadline);
    /// How much coarser than the screen moving pictures are drawn, so that the window reacts at once: 1, 2 or 4.
    [[nodiscard]] int draft() const { return draft_; }
    /// Draws coarse as long as something moves and full frames take too long (kTooSlowMs).
    void setMoving(bool moving) { moving_ = moving; }
    /// Labels of the view from outside in the window's own type, whatever the size of a pane; 0: in that of the picture.
    void setOutsideType(int height) { outsideType_ = height; }
    void allowDraft(bool allowed) { draftAllowed_ = allowed; }
    /// Draws every pane whole at once: for what looks at one place in several panes.
    void drawWhole(bool whole) { whole_ = whole; }
    /// Draws every pane again, after its shaders have changed.
    void drawAnew();
    /// The panes that publish their answers with the next frame, to be judged.
    void wantVisibility(std::vector<int> panes) { answering_ = std::move(panes); }
    void setTimePasses(bool on) { timePasses_ = on; }
    [[nodiscard]] bool isAtRest() const { return !moving_ && !animation_.playing; }

    // --- changes that can be undone; `gesture` names a run of changes that are one (document.h)
    void change(const std::string& gesture, const std::function<void(Document&)>& edit);
    /// The same for what is in the scene. An animation stops: what is dragged must not move away by itself.
    void changeScene(const std::string& gesture, const std::function<scene::Snapshot(const scene::Snapshot&)>& edit);
    void endGesture() { history_.endGesture(); }
    void undo();
    void redo();
    [[nodiscard]] const UndoHistory& history() const { return history_; }

    /// The camera, which stays what it is where it would have no view. While an animation plays, which undo takes back as a whole, no
    /// step of its own.
    void setCamera(const scene::Camera& camera);
    void setOutsideCamera(const scene::Camera& camera);
    void resetOutsideCamera();
    /// The object whose volume is seen from outside: the selected one. Not a change that can be undone.
    void setOutsideCaster(std::optional<std::size_t> object) { document_.outsideChoice.caster = object; }

    // --- changes that cannot be undone: what is asked, and of which pane
    /// Picks the pixel at that share of a picture's width and height. The background has no probe: then no pixel is picked any more.
    void pick(const dvec2& place);
    /// A second pixel, for techniques in which two places exchange light. Without a first one it is the first.
    void pickPartner(const dvec2& place);
    /// Of both; of the second alone.
    void unpick();
    void unpickPartner() { document_.partner.reset(); }
    void activate(int pane);

    /// Another scene in place of this one; layout, techniques and settings stay.
    void showScene(scene::Snapshot scene, std::string sceneName);

    /// Replaces the whole document, as a step of a lesson does.
    void showDocument(Document document);
    /// How often a scene or a whole document was put in place of the one before: what was found of that one is of no use.
    [[nodiscard]] int replacements() const { return replacements_; }

    void play(bool playing);
    void setAnimation(const std::function<void(Animation&)>& edit) { edit(animation_); }
    /// Lets time go by.
    void advance(double seconds);

    /// The probe of the picked pixel by the active pane's technique, of the last picture for which there was time.
    [[nodiscard]] const PickedPixel& pickedPixel() const { return pickedPixel_; }

private:
    bool askAboutPixel(const PaneRequest& request, Pane& pane);
    void settle();
    void chooseDraft(double tookMs);
    void changeCamera(const std::function<void(Document&)>& edit);
    void show(Document document);

    Document document_;
    int replacements_ = 0, outsideType_ = 0;
    UndoHistory history_;
    Animation animation_;
    scene::Snapshot shown_;
    scene::Snapshot bounded_; ///< the scene that the boxes are of
    std::vector<scene::Bounds> bounds_;
    picture::Session session_;
    picture::PictureEncoder encoder_;
    std::array<Pane, kPanes> panes_;
    PickedPixel pickedPixel_;
    bool isNewlyPicked_ = false;
    bool moving_ = false, timePasses_ = true, draftAllowed_ = true, whole_ = false;
    int draft_ = 1;
    bool draftHelps_ = true, draftIsNew_ = false;
    std::optional<std::chrono::steady_clock::time_point> begun_; ///< the last frame, if something was drawn in it
    double drawnShare_ = 1;                                      ///< of the pictures of the last frame
    double fullMs_ = 0, draftMs_ = 0; ///< what frames take, on average: those in full, and those of the present draft
    std::vector<int> answering_;
};

} // namespace shadowlab::lab
