// Truth and errors of what the window shows, found beside the running picture.
//
// A thread of low priority works on a copy: the scene, the view, and each technique's visibility image, read back by the thread
// that draws. It never uses OpenGL. It caches the tree of the scene and the last truths from task to task: where only a technique's
// settings changed, or the window has gone back to an earlier layout, no ray is traced again.
//
// While things move, tasks should be *reduced*: the truth at the pixels' centres, without ties. A reduced task is finished even when
// the next one has come; otherwise a picture that changes faster than it can be judged would never be judged. Of several waiting
// tasks only the newest is kept. An *exact* task is for a picture at rest: it cancels the current task, gives the reduced answer
// first and then the exact one, and is itself cancelled when the next task comes.
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "app/judge/slot_errors.h"
#include "app/lab/errors/mailbox.h"
#include "app/picture/picture.h"
#include "app/picture/verdict_panels.h"

namespace shadowlab::lab {

/// What there is to judge in one slot. Without an image (a technique that publishes no visibility) nothing is.
struct SlotTask {
    picture::VisibilityImage visibility;                        ///< of the region's pixels: readVisibility(stage, region)
    Region region;                                     ///< of the view; empty: all of it
    judge::TruthOf truth = judge::TruthOf::centre; ///< what the technique is judged by: Session::truthFor()
    bool wantsOverlay = false;                         ///< draw the errors, to be laid over the slot's picture
    int markWidth = picture::kOnePixel;                ///< of wrong pixels that stand alone, in the overlay
    bool wantsCore = false;                            ///< count core errors; exact tasks only
    std::optional<judge::Grid<float>> texelPx{}; ///< for them: readTexelSizes(); none: the technique has no texels
};

/// One moment of the window.
struct JudgeTask {
    scene::Snapshot snapshot;
    View view; ///< its region does not matter: the truth is that of the whole view
    int light = 0;
    bool exact = false;
    judge::Rasterised rasterised; ///< Session::rasterise(); exact tasks only
    bool wantsTruthPanel = false;
    std::vector<SlotTask> slots;
};

struct SlotAnswer {
    std::shared_ptr<const judge::Truth> truth; ///< that it was compared with
    std::shared_ptr<const picture::Panel> truthPanel;     ///< of it, where asked for
    bool exact = false;                          ///< its ties are known
    judge::Judgement judgement;
    std::optional<double> edgeErrorPx; ///< none: no shadow ends in the region
    std::optional<int> coreErrors;     ///< none: not asked for, or not exact
    std::optional<picture::Panel> overlay;      ///< errorOverlay(), where asked for
    std::optional<image::Image> onePixelEach;   ///< the same without wide marks, where the overlay may have some
};

struct JudgeAnswer {
    std::uint64_t number = 0; ///< of the task
    bool exact = false;       ///< all ties are known; also of a reduced task whose exact truth was still in memory
    /// About the light's centre; about its area, where no slot is judged by the centre.
    std::shared_ptr<const judge::Truth> truth;
    std::shared_ptr<const picture::Panel> truthPanel;
    std::vector<std::optional<SlotAnswer>> slots; ///< none: there was nothing to judge, or its truth comes later
    double ms = 0;                                ///< from the task's beginning to its answer
};

/// All functions are called by one thread, the one that draws. None of them blocks but the destructor, which waits for the
/// current piece of work: some milliseconds, and a sixth of a second for a scene of a million triangles, whose tree is folded
/// in one piece.
class BackgroundJudge {
public:
    /// `yields`: run at low priority, so that drawing is never delayed. Without it the thread runs at normal priority, for captures
    /// and tests, which wait for the answer.
    explicit BackgroundJudge(bool yields = true);
    ~BackgroundJudge();
    BackgroundJudge(const BackgroundJudge&) = delete;
    BackgroundJudge& operator=(const BackgroundJudge&) = delete;

    /// Takes the place of a task that has not begun. Returns the task's number, larger than all before.
    std::uint64_t submit(JudgeTask task);
    /// Nothing of what was submitted is of interest any more: another scene, another light. newest() is empty until the
    /// next task is answered.
    void forget();

    /// The last answer; its number never falls, and once an exact task is submitted, or forget() was called, no answer to
    /// an older one appears any more. Throws on what went wrong in the background, once.
    std::shared_ptr<const JudgeAnswer> newest();
    /// Is there an answer to come?
    [[nodiscard]] bool busy() const { return finished_.load(std::memory_order_acquire) < submitted_; }

private:
    struct Order {
        std::uint64_t number = 0;
        std::optional<JudgeTask> task; ///< none: only wakes the thread
        std::stop_token stop;
    };
    struct Outcome {
        std::uint64_t number = 0;
        std::shared_ptr<const JudgeAnswer> answer;
        std::exception_ptr failure; ///< instead of an answer
    };
    std::uint64_t send(std::optional<JudgeTask> task);
    void dropAll();
    void work(bool yields);

    // Of the thread that draws.
    std::uint64_t submitted_ = 0;
    std::uint64_t oldestWelcome_ = 1; ///< outcomes of smaller numbers are dropped
    bool lastWasExact_ = false;
    std::stop_source stop_; ///< of all orders since the last dropAll()
    std::shared_ptr<const JudgeAnswer> newest_;
    // Between the threads.
    Mailbox<Order> orders_;
    Mailbox<Outcome> outcomes_;
    std::atomic<std::uint64_t> finished_ = 0; ///< the last order that was done with
    std::atomic<int> bell_ = 0;               ///< incremented for each order and at the end; the thread waits for a change
    std::atomic<bool> ending_ = false;
    std::jthread thread_; ///< last: it uses all of the above
};

} // namespace shadowlab::lab
