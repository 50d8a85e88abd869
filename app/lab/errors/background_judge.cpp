// SPDX-License-Identifier: MIT
#include "app/lab/errors/background_judge.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <list>
#include <stdexcept>

#include "app/lab/errors/background_priority.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::lab {

namespace {

using Clock = std::chrono::steady_clock;
using judge::Truth, judge::TruthOf;

// While a tree is built, it is checked this often whether the tree is still needed.
constexpr std::chrono::milliseconds kSlice{4};

void throwIfStopped(const std::stop_token& stop) {
    if (stop.stop_requested()) throw trace::Stopped();
}

/// What the thread keeps from task to task, and how it answers one.
class Judge {
public:
    using Publish = std::function<void(JudgeAnswer)>;

    /// Publishes one answer or more: for an exact task the reduced one comes first, and what is known of some slots before what
    /// takes longer. Throws trace::Stopped.
    void answer(const JudgeTask& task, const std::stop_token& stop, const Publish& publish) {
        const Clock::time_point start = Clock::now();
        const auto publishKnown = [&] {
            JudgeAnswer answer = judgeSlots(task, stop);
            answer.ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
            publish(std::move(answer));
        };
        const Key key{task.snapshot, task.view.camera, task.view.size, task.light};
        for (Kept& kept : kept_)
            bringToFront(kept, key);
        while (!tracer_.advance(task.snapshot, Clock::now() + kSlice))
            throwIfStopped(stop);
        const bool area = isAsked(task, TruthOf::area), centre = isAsked(task, TruthOf::centre) || !area;
        if (centre) {
            Known& known = knownOf(TruthOf::centre);
            const bool isNew = !known.truth;
            if (isNew) keep(known, reducedTruth(key, TruthOf::centre, stop), key, false);
            if (task.exact && !known.exact) {
                if (isNew) publishKnown();
                keep(known, exactTruth(key, TruthOf::centre, task, stop), key, true);
            }
        }
        if (area) {
            Known& known = knownOf(TruthOf::area);
            if (centre && (!known.truth || (task.exact && !known.exact))) publishKnown();
            if (task.exact && !known.exact) keep(known, exactTruth(key, TruthOf::area, task, stop), key, true);
            if (!known.truth) keep(known, reducedTruth(key, TruthOf::area, stop), key, false);
        }
        publishKnown();
    }

private:
    struct Key {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        int light = kNoLight;
        friend bool operator==(const Key&, const Key&) = default;
    };
    /// One truth, and what follows from it.
    struct Known {
        std::shared_ptr<const Truth> truth; ///< none: it is not known
        std::vector<judge::BoundaryEdge> boundary;
        std::optional<judge::Grid<float>> distancePx; ///< to it, if requested
        Key madeFor;
        bool exact = false;
    };

    static bool isAsked(const JudgeTask& task, TruthOf of) {
        return std::ranges::any_of(task.slots, [of](const SlotTask& slot) { return slot.truth == of; });
    }
    /// What is known of the view of the present task: the first of its list.
    Known& knownOf(TruthOf of) { return kept_[of == TruthOf::area ? 1 : 0].front(); }

    /// Pictures change their size when a layout is chosen or a panel opens, and change it back again.
    using Kept = std::list<Known>;
    static constexpr std::size_t kMostKept = 6;
    static void bringToFront(Kept& kept, const Key& key) {
        // A truth without ties is that of a moment in which something moved: it will not come back.
        std::erase_if(kept, [&](const Known& known) { return known.madeFor != key && !known.exact; });
        const auto found = std::ranges::find(kept, key, &Known::madeFor);
        if (found == kept.end())
            kept.emplace_front().madeFor = key;
        else
            kept.splice(kept.begin(), kept, found);
        if (kept.size() > kMostKept) kept.pop_back();
    }

    Truth reducedTruth(const Key& key, TruthOf of, const std::stop_token& stop) const {
        return judge::truthAtCentres(tracer_, key.camera, key.size, key.light, stop, of);
    }
    Truth exactTruth(const Key& key, TruthOf of, const JudgeTask& task, const std::stop_token& stop) const {
        return judge::exactTruth(tracer_, key.camera, key.size, key.light, task.rasterised, stop, of);
    }

    static void keep(Known& known, Truth truth, const Key& key, bool exact) {
        known.truth = std::make_shared<const Truth>(std::move(truth));
        known.boundary = judge::trueBoundary(*known.truth);
        known.distancePx.reset();
        known.madeFor = key;
        known.exact = exact;
    }

    JudgeAnswer judgeSlots(const JudgeTask& task, const std::stop_token& stop) {
        JudgeAnswer answer;
        answer.exact = true;
        std::array<std::shared_ptr<const picture::Panel>, 2> panels;
        for (std::size_t i = 0; i < kept_.size(); ++i)
            if (kept_[i].front().truth && task.wantsTruthPanel)
                panels[i] = std::make_shared<const picture::Panel>(picture::truthPanel(*kept_[i].front().truth, {}));
        const bool area =
            !knownOf(TruthOf::centre).truth || (!isAsked(task, TruthOf::centre) && isAsked(task, TruthOf::area));
        answer.truth = knownOf(area ? TruthOf::area : TruthOf::centre).truth;
        answer.truthPanel = panels[area ? 1 : 0];
        if (task.slots.empty()) answer.exact = knownOf(TruthOf::centre).exact;
        for (const SlotTask& slot : task.slots) {
            throwIfStopped(stop);
            answer.slots.emplace_back();
            Known& known = knownOf(slot.truth);
            answer.exact = answer.exact && known.exact;
            if (slot.visibility.greyAlpha.empty() || !known.truth) continue;
            auto [judgement, edgeErrorPx] =
                judge::slotErrors(*known.truth, known.boundary, slot.visibility.greyAlpha, slot.region);
            SlotAnswer& judged = answer.slots.back().emplace();
            judged.truth = known.truth;
            judged.truthPanel = panels[slot.truth == TruthOf::area ? 1 : 0];
            judged.exact = known.exact;
            judged.judgement = std::move(judgement);
            judged.edgeErrorPx = edgeErrorPx;
            if (slot.wantsCore && task.exact && known.exact) {
                if (!known.distancePx)
                    known.distancePx = judge::distanceToBoundary(known.boundary, known.truth->size, stop);
                judged.coreErrors =
                    judge::coreErrors(*known.truth, judged.judgement, *known.distancePx, slot.texelPx);
            }
            if (slot.wantsOverlay) {
                judged.overlay = picture::errorOverlay(*known.truth, judged.judgement, slot.region, slot.markWidth);
                if (slot.markWidth > picture::kOnePixel)
                    judged.onePixelEach = picture::errorOverlay(*known.truth, judged.judgement, slot.region).picture;
            }
        }
        return answer;
    }

    trace::SceneTracer tracer_;
    std::array<Kept, 2> kept_; ///< about the light's centre, and about its area
};

/// A wrong size would otherwise become an access outside of an array, on another thread, far from its cause.
void requireSound(const JudgeTask& task) {
    const auto pixels = static_cast<std::size_t>(task.view.size.x) * static_cast<std::size_t>(task.view.size.y);
    const std::vector<std::uint32_t>& drawn = task.rasterised.primitives;
    bool sound = task.light >= 0 && task.light < static_cast<int>(task.snapshot->lights.size()) &&
                 (drawn.empty() || drawn.size() == pixels);
    for (const SlotTask& slot : task.slots)
        sound = sound && (!slot.texelPx || slot.texelPx->values.size() == pixels);
    if (!sound) throw std::logic_error("a task for the judge whose light or sizes are not those of its view");
}

} // namespace

BackgroundJudge::BackgroundJudge(bool yields) : thread_([this, yields] { work(yields); }) {}

BackgroundJudge::~BackgroundJudge() {
    ending_ = true;
    stop_.request_stop();
    ++bell_;
    bell_.notify_one();
}

std::uint64_t BackgroundJudge::submit(JudgeTask task) {
    requireSound(task);
    if (task.exact || lastWasExact_) dropAll();
    lastWasExact_ = task.exact;
    return send(std::move(task));
}

void BackgroundJudge::forget() {
    dropAll();
    newest_.reset();
    lastWasExact_ = false;
    send(std::nullopt); // so that busy() comes to an end whether or not the thread had begun the last task
}

std::uint64_t BackgroundJudge::send(std::optional<JudgeTask> task) {
    orders_.put(std::make_unique<Order>(++submitted_, std::move(task), stop_.get_token()));
    ++bell_;
    bell_.notify_one();
    return submitted_;
}

void BackgroundJudge::dropAll() {
    stop_.request_stop();
    stop_ = std::stop_source();
    oldestWelcome_ = submitted_ + 1;
}

std::shared_ptr<const JudgeAnswer> BackgroundJudge::newest() {
    const std::unique_ptr<Outcome> outcome = outcomes_.take();
    if (!outcome || outcome->number < oldestWelcome_) return newest_;
    if (outcome->failure) std::rethrow_exception(outcome->failure);
    newest_ = outcome->answer;
    return newest_;
}

void BackgroundJudge::work(bool yields) {
    if (yields) yieldToDrawing();
    Judge judge;
    while (true) {
        const int rung = bell_; // read first, so that a signal from here on is not missed
        if (ending_) return;
        const std::unique_ptr<Order> order = orders_.take();
        if (!order) {
            bell_.wait(rung);
            continue;
        }
        const auto put = [&](JudgeAnswer answer) {
            answer.number = order->number;
            outcomes_.put(std::make_unique<Outcome>(order->number,
                                                    std::make_shared<const JudgeAnswer>(std::move(answer)), nullptr));
        };
        try {
            if (order->task) judge.answer(*order->task, order->stop, put);
        } catch (const trace::Stopped&) {
            // The result is no longer needed, and neither is its error.
        } catch (...) {
            judge = Judge(); // whatever it was in the middle of
            outcomes_.put(std::make_unique<Outcome>(order->number, nullptr, std::current_exception()));
        }
        finished_.store(order->number, std::memory_order_release);
    }
}

} // namespace shadowlab::lab
