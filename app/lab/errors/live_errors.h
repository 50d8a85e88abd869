// The errors of the pictures in the window, found while they are on show: pictures are submitted to the judge in the background, and
// its answers are turned into pictures and numbers.
//
// While something moves, one pane after the other is judged, every second or so and without ties: each time the pane is
// drawn with its answers as well, which costs a little. When all is at rest, every pane is judged exactly, once. Techniques
// that are judged by a light's area, which takes seconds, are judged at rest only, after all others.
//
// What has changed is seen first and judged from the next frame on: so the window reacts at once.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/lab/errors/background_judge.h"
#include "app/lab/errors/history.h"
#include "app/lab/workbench.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::lab {

/// The errors of one pane, of the whole picture also where a band of it is seen. They are those of the picture that was judged,
/// which may be a moment old.
struct PaneErrors {
    judge::Counts counts;              ///< wrong(): falseLit + falseShadow
    std::optional<double> edgeErrorPx; ///< wrong pixels for each pixel of true boundary; none: no shadow ends in the picture
    std::optional<int> coreErrors;
    bool exact = false; ///< ties are known; else some of the wrong pixels may be ties
    PaneRequest judged; ///< what it is about

    /// The edge error to be said. Beyond five wrong pixels for each pixel of a true edge they do not lie along it: they are stripes, or
    /// whole areas, and a distance of edges would say something else.
    [[nodiscard]] std::optional<double> saidEdgeErrorPx() const {
        constexpr double kLargest = 5;
        return edgeErrorPx && *edgeErrorPx <= kLargest ? edgeErrorPx : std::nullopt;
    }
};

/// A stage that has been judged, ready to be seen: the ground, and over it the verdicts.
struct JudgedPicture {
    gl::Texture2D ground, verdicts; ///< of one size; without ground the verdicts cover everything
    gl::Texture2D onePixelEach;     ///< the verdicts without enlarged marks, for a magnifier; none: they have no such marks
    PanePicture legend;             ///< its kind and key; no texture
    bool exact = false;
};

class LiveErrors {
public:
    /// The font is for the numbers of the stage `scanline`. It must live as long. `yields`: see BackgroundJudge.
    LiveErrors(const image::Font& font, bool yields) : font_(font), judge_(yields), history_(kHistory) {}

    /// Before the panes are drawn: which of them are to publish their answers. True if any is.
    bool ask(Workbench& bench, ivec2 areaSize, double seconds);
    /// Called after the panes are drawn: submits what they published, and takes what has been found. True if a picture has changed.
    bool update(Workbench& bench, ivec2 areaSize, double seconds);

    /// Nothing when the pane has not been judged yet, or shows something that cannot be.
    [[nodiscard]] const PaneErrors* errors(int pane) const;
    /// What covers the pane in the document's layout: the difference, or its judged stage; nothing where it shows its own picture.
    [[nodiscard]] const JudgedPicture* shownOn(const Document& document, int pane) const;
    /// True in the frame in which something else is to be shown than in the one before, at rest.
    [[nodiscard]] bool seesNew() const { return isNew_; }
    /// Of a pane that shows `truth`, `error` or `scanline`; nothing before the first verdict.
    [[nodiscard]] const JudgedPicture* picture(int pane) const;
    /// Of the layout `diff`.
    [[nodiscard]] const JudgedPicture* difference() const { return difference_ ? &*difference_ : nullptr; }
    [[nodiscard]] const History& history() const { return history_; }
    /// Are they exact, and of what is on show now? Else they are about to change.
    [[nodiscard]] bool areFinal(int pane) const {
        const PaneErrors* const known = errors(pane);
        return known && known->exact && seen_ == exactFor_;
    }
    /// Is every pane on show judged exactly?
    [[nodiscard]] bool isDone() const { return done_; }
    /// Why the last errors could not be found: said once. Empty: nothing new has failed.
    [[nodiscard]] std::string takeFailure() { return std::exchange(failure_, {}); }

private:
    static constexpr std::size_t kHistory = 600; ///< samples of the plot: about a minute of moving

    /// What was handed over, until the answer comes.
    struct Submitted {
        std::vector<int> panes;
        std::vector<PaneRequest> requests;
        std::map<int, gl::Texture2D> grounds;                ///< of panes that show a judged stage
        std::map<int, picture::VisibilityImage> answers;              ///< of those that show `scanline`
        std::optional<image::Image> diffGround;               ///< of `diff`: the picture of the first pane
        int markWidth = picture::kOnePixel;
    };
    /// What there is to be judged in a frame. The layout decides what is made of the verdicts.
    struct OnShow {
        picture::Layout layout = picture::Layout::single;
        std::vector<PaneRequest> requests; ///< one for each pane
        friend bool operator==(const OnShow&, const OnShow&) = default;
    };
    void forgetOthers(const Workbench& bench, const std::vector<PlacedPane>& placed, const OnShow& shown);
    void forgetAreas(const Workbench& bench, const std::vector<PlacedPane>& placed);
    void submit(Workbench& bench, const std::vector<PlacedPane>& placed, const std::vector<int>& panes, int markWidth, bool exact);
    void take(const Workbench& bench, const JudgeAnswer& answer, double seconds);
    void showPicture(const Workbench& bench, const JudgeAnswer& answer, Submitted& submitted, std::size_t slot);

    const image::Font& font_;
    BackgroundJudge judge_;
    std::map<std::uint64_t, Submitted> submitted_;
    std::shared_ptr<const JudgeAnswer> taken_; ///< the last answer
    std::map<int, PaneErrors> errors_;
    std::map<int, JudgedPicture> pictures_;
    std::optional<JudgedPicture> difference_;
    History history_;
    int replacements_ = 0; ///< of the document, when it was last looked at
    static OnShow onShow(const Workbench& bench, const std::vector<PlacedPane>& placed);
    OnShow exactFor_; ///< what the last exact task was about
    OnShow seen_;     ///< in the last frame
    std::vector<int> wanted_;           ///< panes that are to publish their answers now
    double lastSubmit_ = 0, restSince_ = 0;
    std::size_t turn_ = 0; ///< the pane that is judged next while something moves
    bool done_ = false, isNew_ = false;
    std::string failure_; ///< not yet taken
};

} // namespace shadowlab::lab
