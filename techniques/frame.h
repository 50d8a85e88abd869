// One frame of one technique: what it may look at, where it draws, and how it tells what it did.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/pass_timer.h"
#include "techniques/foundation/gl/scene/scene_buffers.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/technique.h"

namespace shadowlab {

/// Names one stage, or one pass, of one light (kNoLight: of the whole frame).
struct StageKey {
    std::string id;
    int light = kNoLight;
    friend bool operator==(const StageKey&, const StageKey&) = default;
};

/// A published intermediate picture. Owns its texture; lives as long as the frame's result.
struct Stage {
    StageKey key;
    gl::Texture2D texture;
    Display display;
};

struct Counter {
    std::string id;
    double built = 0, of = 0; ///< "casters 3 of 12"; of = 0: a plain number
    std::string unit;
};

/// Something the technique found in the scene, in words: "floor", "(0, 1, 0)·P + 0 = 0".
struct Note {
    std::string label, text;
    vec3 colorLinear; ///< that it has in the stages
};

/// What the session asks of one frame.
struct FrameRequest {
    std::vector<StageKey> stages{};      ///< to be published
    std::optional<StageKey> stopAfter{}; ///< pass after which nothing more is drawn: step mode, and stage `pass:ID`
    bool timePasses = false;
    bool waitForGl = true; ///< until all is drawn; else frameMs is only what it took to ask for it
    /// Go on making the picture better when there is one; else the first whole picture is enough: it is of no use any more when
    /// something has moved.
    bool refine = true;
    Deadline deadline = Deadline::max();
    /// Nothing is wanted but the picture as it is shown, one sample a pixel, with the scene's exposure: a technique that can draws it
    /// in here at once (Frame::drawFinished), without a picture of radiance. Others, and frames of which more is asked, draw as ever.
    gl::FinishedPicture* finished = nullptr;
};

/// Of which scenes a technique is able to draw finished pixels. Its shader does not cut holes, unless it is `any`.
enum class FinishedScenes { withOneLight, withLights, any };

class Frame {
public:
    Frame(const scene::Snapshot& snapshot, const View& view, const gl::SceneBuffers& buffers, const gl::Target& target,
          FrameRequest request);

    [[nodiscard]] const scene::Scene& scene() const { return *snapshot_; }
    [[nodiscard]] const scene::Snapshot& snapshot() const { return snapshot_; }
    [[nodiscard]] const View& view() const { return view_; }
    /// The view's camera, its near plane moved out as far as what is in view allows (scene/query/view/depth_fit.h): draw with
    /// this.
    [[nodiscard]] const scene::Camera& camera() const { return camera_; }
    /// From here on camera() and eye() have the near plane of the view itself: for an algorithm in which it cuts.
    void useNearPlaneOfView();
    /// From here on what eye() projects ends at a far plane just beyond the scene, as in most programs; without this it ends
    /// nowhere.
    void useFarPlane();
    /// Within a pass: draws only in that part of the picture from here on, and at most in the view's region; none: in all of
    /// that.
    void scissorTo(const std::optional<scene::PicturePart>& part) const;
    /// The pixels that scissorTo(part) draws in.
    [[nodiscard]] Region pixelsOf(const std::optional<scene::PicturePart>& part) const;
    /// From here on drawSurfaces with eye() draws what is out of view as well: for a technique told to leave nothing out.
    void drawWhatIsOutOfView();
    [[nodiscard]] const gl::EyeMatrices& eye() const { return eye_; }
    [[nodiscard]] const gl::SceneBuffers& buffers() const { return buffers_; }
    [[nodiscard]] const gl::Target& target() const { return target_; }
    /// For a technique that is able to draw finished pixels, before its first pass: true if that is all that is wanted. The passes
    /// then draw to request.finished instead of target().color; depth and stencil stay target()'s.
    bool drawFinished(FinishedScenes able = FinishedScenes::withOneLight);
    [[nodiscard]] bool drawsFinished() const { return result_.isFinished; }
    /// Within a pass of a frame that draws finished pixels: both pictures are drawn to, the one in shadow as well.
    void bindInShadowToo();
    /// The same of several lights: in the place of the picture in shadow a bit for each light is drawn to, where it is hidden.
    void bindHiddenLights();
    /// Where finished pixels go; for a technique that computes them on the processor.
    [[nodiscard]] const gl::Texture2D& finishedPicture() const { return request_.finished->color; }
    /// The finished picture in which the light is hidden everywhere; of several lights, the bits of those that are hidden.
    [[nodiscard]] const gl::Texture2D& inShadow() const { return request_.finished->inShadow; }
    [[nodiscard]] Deadline deadline() const { return request_.deadline; }
    [[nodiscard]] bool refines() const { return request_.refine; }
    /// The pass after which nothing more is drawn; none: the picture is finished.
    [[nodiscard]] const std::optional<StageKey>& stopsAfter() const { return request_.stopAfter; }

    /// Runs `draw` as one named pass: baseline state, the frame's target bound, a debug group, a timer and a GL error
    /// check around it. Skipped once the pass asked for by step mode has run.
    void pass(const PassInfo& info, const std::function<void()>& draw, int light = kNoLight);

    /// Is nothing asked for but the picture as it is when all passes have run? A technique that would draw once more what it drew last
    /// may then leave it as it is.
    [[nodiscard]] bool wantsOnlyPicture() const { return request_.stages.empty() && !request_.stopAfter && !request_.timePasses; }
    /// Is anybody going to look at this stage? Do not draw it otherwise.
    [[nodiscard]] bool wants(std::string_view stage, int light = kNoLight) const;
    /// Hands an intermediate picture over.
    void publish(std::string_view stage, int light, gl::Texture2D texture, Display display = {});
    /// Publishes a copy of what the target's colour holds now.
    void publishTarget(std::string_view stage, int light = kNoLight);
    /// Draws a stage into a new texture of the target's size that shares the target's depth and stencil, and publishes
    /// it.
    void drawStage(std::string_view stage, int light, GLenum format, const std::function<void()>& draw,
                   Display display = {});
    /// drawStage with a copy of the target's depth and stencil, for what marks pixels while it is drawn: the target's stay as they are.
    void drawStageOnCopy(std::string_view stage, int light, GLenum format, const std::function<void()>& draw);
    /// The same as drawStage, starting from what the target's colour holds now; `greyed` without its colours, as a ground for
    /// coloured lines and faces.
    void drawOverTarget(std::string_view stage, int light, bool greyed, const std::function<void()>& draw,
                        Display display = {});
    /// "Built 3 of 12": how much of the scene the technique had to handle. Counts of one id add up.
    void count(std::string_view id, double built, double of = 0, std::string_view unit = "");

    /// Something to be listed beside the settings: what the technique found, a line each.
    void note(std::string label, std::string text, const vec3& colorLinear);

    struct Result {
        std::vector<Stage> stages;
        std::vector<Note> notes;
        std::vector<Counter> counters;
        std::vector<StageKey> passes; ///< in the order they ran
        std::vector<gl::PassTimer::Result> passMs;
        bool isFinished = false; ///< the picture is in the request's `finished`, not in the target
    };
    Result takeResult();

private:
    void makeFinished(gl::Texture2D& picture) const;
    gl::Texture2D copyOfTarget(std::string_view name) const;
    gl::Texture2D greyedTarget(std::string_view name) const;
    void drawInto(gl::Texture2D& texture, const gl::Texture2D& depthStencil, std::string_view stage, bool clear,
                  const std::function<void()>& draw) const;

    scene::Snapshot snapshot_;
    const View& view_;
    scene::Camera camera_;
    gl::EyeMatrices eye_;
    const gl::SceneBuffers& buffers_;
    const gl::Target& target_;
    FrameRequest request_;
    gl::Framebuffer finished_, finishedAndInShadow_, hiddenLights_; ///< of request_.finished, with the target's depth and stencil
    gl::PassTimer timer_;
    Result result_;
    bool stopped_ = false;
};

/// The pass of that id in a technique's list.
const PassInfo& passInfo(std::span<const PassInfo> passes, std::string_view id);

} // namespace shadowlab
