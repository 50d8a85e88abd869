// The one place that renders a frame: for window, capture, measurement and tests alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/exact_view.h"
#include "techniques/frame.h"
#include "techniques/registry.h"

namespace shadowlab::picture {

/// One technique with its own parameters and its own target.
struct Slot {
    const TechniqueInfo* info;
    std::unique_ptr<Technique> technique;
    params::ParamList params;
    gl::Target target;
    std::size_t passes = 0;       ///< that have drawn what the target holds
    gl::FinishedPicture finished; ///< where a frame goes of which nothing but the picture is wanted
};

/// What came out of one frame besides the picture in the slot.
struct RenderedFrame {
    Frame::Result result;
    double prepareMs = 0;
    double frameMs = 0; ///< wall time of prepare and render to the end of the GL work, without read-back
    bool converged = true;
    double prepared = 1; ///< 0..1 of what the technique has to do before it can draw
    double drawn = 1;    ///< 0..1 of what it draws: of the first whole picture where no better one was asked for
};

/// A scene, its buffers, and the slots that draw it. Needs a current GL context for its whole life.
class Session {
public:
    explicit Session(scene::Snapshot snapshot) : snapshot_(std::move(snapshot)) {}
    /// Shows another scene; buffers of unchanged geometry stay.
    void setScene(scene::Snapshot snapshot) { snapshot_ = std::move(snapshot); }
    [[nodiscard]] const scene::Snapshot& snapshot() const { return snapshot_; }

    /// A slot that is not yet part of any layout. Throws Error (usage) for an unknown id.
    static Slot makeSlot(std::string_view techniqueId);

    /// Prepares and renders until the technique has converged, or the deadline of the request has passed: then the result
    /// says so, and the target holds the last picture there was. Call again to go on.
    /// Throws Error (badInput) for a requested stage that the technique does not have.
    RenderedFrame render(Slot& slot, const View& view, const FrameRequest& request = {});

    /// The scene on the graphics card, as of the last frame.
    [[nodiscard]] const gl::SceneBuffers& buffers() const { return buffers_; }

    /// Builds the tree for rays, as far as the deadline allows. Truth and outline otherwise build it themselves. Returns the share that
    /// is done, 1: all.
    double prepareTruth(Deadline deadline) { return exact_.prepare(snapshot_, deadline) ? 1 : exact_.prepared(); }
    /// For rays of other kinds through the scene. After prepareTruth() has returned 1 for it.
    [[nodiscard]] const trace::SceneTracer& tracer() const { return exact_.tracer(); }
    /// The truth of what the view shows of one light, with its ties. Valid until the next call about the same
    /// thing, the light's centre or its area.
    const judge::Truth& truth(const View& view, const LightTruth& light);
    /// The same without ties, for what follows a sequence.
    judge::Truth truthAtCentres(const View& view, const LightTruth& light) {
        return exact_.truthAtCentres(snapshot_, view, light);
    }
    /// What a slot is judged by, with its settings.
    [[nodiscard]] LightTruth truthFor(const Slot& slot, int light) const;
    /// Where the light's shadows end. Valid until the next call.
    const std::vector<judge::OutlineSegment>& outline(const View& view, int light) {
        return exact_.outline(snapshot_, view, light);
    }
    std::vector<std::uint8_t> tiesAmong(const View& view, const LightTruth& light, const std::vector<ivec2>& pixels) {
        return exact_.tiesAmong(snapshot_, view, light, pixels);
    }
    /// For a truth that is found elsewhere: see BackgroundJudge.
    judge::Rasterised rasterise(const View& view);

private:
    scene::Snapshot snapshot_;
    gl::SceneBuffers buffers_;
    ExactView exact_;
};

/// Was it? A technique that has not converged may have nothing to publish yet.
bool isPublished(const RenderedFrame& rendered, const StageKey& key);

/// What was published under that key. Throws std::logic_error if the technique did not publish a stage that it declares.
const Stage& findStage(const RenderedFrame& rendered, const StageKey& key);

/// What a technique declares about a stage.
const StageInfo& stageInfo(const TechniqueInfo& info, std::string_view id);

/// Throws Error (usage) when the pass did not run with the slot's settings, naming those that did.
void requirePassRan(const RenderedFrame& rendered, const StageKey& pass, const TechniqueInfo& info);

/// Index of the light of that name. Throws Error (usage).
int lightIndex(const scene::Scene& scene, std::string_view name);

} // namespace shadowlab::picture
