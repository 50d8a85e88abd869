// One part of the window: which technique it shows, with which settings, and what of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/picture/outside/outside_view.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/picture/stage_ref.h"

namespace shadowlab::lab {

/// "resolution" -> "1024", as --set takes them.
using Values = std::map<std::string, std::string>;

/// What a pane shows, as plain values, so that it can be stored, compared, undone and written to a file.
struct PaneState {
    std::string technique;
    picture::StageRef stage;                ///< what of it
    std::map<std::string, Values> settings; ///< by technique: what differs from its defaults
    friend bool operator==(const PaneState&, const PaneState&) = default;

    /// The settings of the technique that is shown.
    [[nodiscard]] const Values& values() const;
};

/// Everything a pane's picture depends on.
struct PaneRequest {
    PaneState state;
    scene::Snapshot snapshot;
    View view;
    scene::Camera outsideCamera; ///< for the stage `outside`, which is a picture of its own size:
    ivec2 outsideSize{0};        ///< that of the pane, also where the other stages show a band of a larger picture
    picture::OutsideChoice outsideChoice{};
    int outsideType = 0;         ///< height that its labels' type is a share of (picture::OutsideLook); 0: the picture's own
    int draft = 1;               ///< by how much its picture is coarser than the pane
    int light = 0;               ///< for stages of one light that do not name theirs
    friend bool operator==(const PaneRequest&, const PaneRequest&);
};

/// The last picture of a pane, as it is shown.
struct PanePicture {
    gl::Texture2D
        texture; ///< encoded, row 0 at the bottom; of stages that are judged: the grey ground under the verdicts
    StageKind kind = StageKind::radiance;
    Display display;     ///< for the legend
    std::string caption; ///< of the stage; empty: the finished picture
    std::string note{};  ///< how a step is shown, where that is not as it is: "shown 8 times brighter"
    StageKey stage{};    ///< the technique's own stage that it is of; no id: none
};

/// How a pane is drawn, apart from what it shows.
struct PaneWork {
    Deadline deadline = Deadline::max();
    bool timePasses = true;  ///< measure each pass, which waits for the GPU; otherwise the panes are drawn concurrently
    bool refine = true;      ///< a picture that can get better, sample by sample, goes on doing so
    bool visibility = false; ///< publish the technique's answers for the request's light as well, to be judged
};

/// Draws a pane and keeps the result. Techniques that were shown before stay ready: going back to one costs nothing
/// but its frame.
class Pane {
public:
    /// Draws again if anything differs from what the picture was made of. Returns true if something was drawn, or is not
    /// finished. Work beyond the deadline waits for the next call; the last picture stays meanwhile. What fails is kept as
    /// `failure()`, and is not tried again before something changes.
    bool update(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, const PaneWork& work);
    /// The technique's answers for that light, if the picture was drawn with them, and all of it was.
    [[nodiscard]] const Stage* visibility(int light) const;

    /// What the technique of the picture is judged by, with its settings, for the light of the request.
    [[nodiscard]] judge::TruthOf judgedBy() const;

    /// The slot of that state, made or found, its parameters set. Throws Error (usage) for a value that is out of range.
    picture::Slot& slotFor(const PaneState& state);

    /// The technique's probe of the picked pixel of what was drawn last; nothing while it is not ready, or where no
    /// pixel is picked. Throws what the technique throws.
    std::optional<Probe> probe(const View& view);

    [[nodiscard]] const PanePicture& picture() const { return picture_; }
    [[nodiscard]] const picture::RenderedFrame& rendered() const { return rendered_; }
    [[nodiscard]] const std::string& failure() const { return failure_; }
    /// Whether what is shown is seen by the eye; a light's view of the scene, that of the second camera and a chart are not.
    [[nodiscard]] bool showsTheEyesView() const;
    /// What is written into the picture from outside, in pixels of it; nothing in other pictures.
    [[nodiscard]] std::span<const picture::PlacedLabel> outsideLabels() const {
        if (!outside_ || !drawn_.stage.isOutside()) return {};
        return outside_->labels();
    }
    [[nodiscard]] const PaneRequest& drawnFor() const { return drawnFor_; }
    /// The picture is still another technique's, of another stage or of another scene: what is asked for takes its time.
    [[nodiscard]] bool showsAnother() const;
    /// The technique's passes that run with the settings of the picture, in order, also where it stops after one of them. None
    /// while the picture is still another technique's, or of a scene with other lights, as it may be for long: a small window has
    /// no room for a new one, and from outside no passes run.
    [[nodiscard]] const std::vector<StageKey>& passesOf(std::string_view technique, const scene::Scene& scene) const;
    [[nodiscard]] double progress() const { return progress_; } ///< 0..1 of what the technique prepares
    /// 0..1 of what it draws; while pictures are not refined, of the first whole one.
    [[nodiscard]] double drawnShare() const { return rendered_.drawn; }
    /// The picture no longer counts: shaders have changed, or the driver has lost it.
    void forget() { drawnFor_ = {}; }

private:
    void keepPasses(const PaneRequest& request, const std::vector<StageKey>& passes);
    void draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, const PaneWork& work);
    bool drawOutside(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                     const PaneWork& work);
    void encode(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                const picture::ResolvedStage& stage, const picture::RenderedFrame& rendered);

    std::map<std::string, picture::Slot> slots_;    ///< by technique
    std::unique_ptr<picture::OutsideView> outside_; ///< made when it is first looked from there
    PanePicture picture_;
    gl::FinishedPicture finished_; ///< the picture before that, to be drawn over
    picture::RenderedFrame rendered_; ///< of the picture
    PaneRequest drawnFor_;
    bool isDrawn_ = false; ///< rendered_ is of drawnFor_, and not of what was asked for before
    bool hasWhole_ = false; ///< picture_ is all of drawnFor_
    std::vector<StageKey> passes_;
    std::string passesTechnique_;           ///< whose they are
    std::vector<std::string> passesLights_; ///< of the scene they ran for; they name lights by number
    PaneState drawn_;                       ///< of the picture
    std::string drawnScene_;                ///< its scene's name
    std::string failure_;
    double progress_ = 1;
    bool converged_ = true, timed_ = false;
};

/// A picture of the processor's on the graphics card, as the encoder leaves one: row 0 at the bottom.
gl::Texture2D textureOf(const image::Image& image);

} // namespace shadowlab::lab
