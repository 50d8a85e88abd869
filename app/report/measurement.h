// Measuring: every technique draws the same frames, and each of its pixels is compared with the truth.
//
// First every frame is judged. Then the sequence is drawn again without judging: that is the time of a frame,
// because judging in between would leave caches cold and processors asleep. Then it is drawn once more with a clock around every
// pass, which costs a little and is not counted. Techniques take turns of some frames each, so that disturbances by other programs
// affect all of them alike; the frames before those of a turn are drawn first and do not count.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/film/motion.h"
#include "app/judge/coverage_errors.h"
#include "app/judge/metrics/boundary.h"
#include "app/judge/metrics/flicker.h"
#include "app/judge/metrics/frame_times.h"
#include "app/judge/verdict.h"
#include "app/picture/judged_slot.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/report/frame_timer.h"

namespace shadowlab::report {

/// A picture against the one that `ray-traced` draws.
struct PictureErrors {
    double psnr = 0; ///< dB, of linear light; infinite for equal pictures
    double ssim = 1; ///< of the encoded pictures
    double flip = 0; ///< mean over the picture
};

/// How the shadows' coverage of pixels is judged.
struct CoverageAsked {
    int points = 0; ///< of each pixel, for the truth; 0: coverage is not judged
    int samples =
        1; ///< on a side of each pixel, for the technique's answer: it draws a picture as many times as wide and as high
};

/// The errors and times of one technique, for one light.
struct TechniqueErrors {
    std::string technique;
    judge::TruthOf truth = judge::TruthOf::centre; ///< what it was judged by
    judge::Counts counts;
    double served = 1; ///< share of the pixels with a surface that the technique can serve at all
    int coreErrors = 0;
    std::optional<double> edgeErrorPx;             ///< none: the truth has no boundary
    std::optional<judge::Displacement> boundaryPx; ///< none: the truth, or the technique, has no boundary
    std::optional<judge::CoverageErrors> coverage; ///< none: not asked for
    PictureErrors picture;
    std::optional<double> excessFlipRate; ///< none: a single frame, or no boundary
    bool converged = true;
    double firstPrepareMs = 0; ///< from nothing: trees, silhouettes; later frames only do what changed
    judge::FrameTimes times;
    std::vector<Counter> counters; ///< of the last frame, which may have had less to do than the first
};

class Measurement {
public:
    /// All of them must live as long as the measurement. Needs a current GL context.
    Measurement(picture::Session& session, std::vector<picture::Slot>& slots, int light, ivec2 size);

    /// Judges the coverage of pixels as well, in the first frame.
    void askForCoverage(const CoverageAsked& asked) { coverageAsked_ = asked; }

    /// Called whenever one technique is through with one frame, or with one turn: it may show how far the work is, or throw.
    void tell(std::function<void()> onStep) { onStep_ = std::move(onStep); }
    /// How often that is for a sequence of so many frames.
    [[nodiscard]] int steps(int frames) const;

    /// Judges the next frame of the sequence; the first one in all ways.
    void addFrame(const film::Moment& moment);
    /// How long the frames are that were added: in so many turns, 0 and up. Of a single frame, nothing moves before it.
    [[nodiscard]] int turns() const;
    void timeTurn(int turn);

    [[nodiscard]] std::vector<TechniqueErrors> results() const;
    /// What the first frame's truth took, ties included; without the tree, which is kept from frame to frame. Where some
    /// techniques are judged by the light's centre and others by its area, of both together.
    [[nodiscard]] double truthMs() const { return truthMs_; }
    /// What the true coverage took, in the same way; 0: not asked for.
    [[nodiscard]] double coverageMs() const { return coverageMs_; }

private:
    /// The truth of one frame, and its boundary.
    struct Judged {
        judge::Truth truth;
        std::vector<judge::BoundaryEdge> boundary;
        judge::Coverage coverage; ///< of the first frame, where it was asked for
    };
    struct Entry {
        picture::Slot* slot;
        TechniqueErrors result;
        judge::ExcessFlips flips;
    };
    /// One picture of the first frame, as linear light and as it is shown.
    struct Shown {
        std::vector<float> linear;
        image::Image encoded;
    };
    Judged truthOf(const View& view, const picture::LightTruth& light, bool first);
    std::vector<std::uint8_t> litOutsideTies(const picture::VisibilityImage& visibility, const judge::Truth& truth,
                                             const picture::LightTruth& light, const View& view);
    void judgeFirst(Entry& measured, const picture::RenderedFrame& rendered, const picture::Answers& answers,
                    const Judged& judged, const Shown& reference);
    judge::CoverageErrors coverageOf(picture::Slot& slot, const View& view, const picture::Answers& answers,
                                     const Judged& judged);
    Shown shown(const picture::Slot& slot) const;
    Shown referencePicture(const View& view);
    picture::RenderedFrame draw(picture::Slot& slot, const film::Moment& moment, bool timesPasses = false) {
        return drawMoment(session_, slot, moment, picture_, size_, timesPasses);
    }

    picture::Session& session_;
    std::vector<Entry> entries_;
    picture::PictureEncoder encoder_;
    gl::FinishedPicture picture_; ///< the last one that was timed
    int light_;
    ivec2 size_;
    std::vector<film::Moment> moments_; ///< that were added
    CoverageAsked coverageAsked_;
    std::vector<std::uint8_t>
        facingSamples_; ///< which samples of the first frame show a surface turned toward the light
    double truthMs_ = 0, coverageMs_ = 0;
    std::function<void()> onStep_ = [] {};
};

} // namespace shadowlab::report
