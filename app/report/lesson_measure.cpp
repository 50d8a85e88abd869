// SPDX-License-Identifier: MIT
#include "app/report/lesson_measure.h"

#include <algorithm>
#include <cmath>

#include "app/course/lessons/lesson_quantities.h"
#include "app/judge/metrics/flicker.h"
#include "app/picture/judged_slot.h"
#include "app/picture/stage_ref.h"
#include "app/report/measurement.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::report {

namespace {

/// The pixels whose middles lie in the box; all of them without one.
Region regionOf(const course::Lesson& lesson, const course::Expectation& expected) {
    if (!expected.look) return {ivec2(0), lesson.size};
    const dvec2 size(lesson.size);
    const course::LookBox box = course::inPictureOf(size.x / size.y, lesson.look[static_cast<std::size_t>(*expected.look)]);
    const ivec2 corner = glm::clamp(ivec2(glm::round(box.corner * size)), ivec2(0), lesson.size);
    const ivec2 end = glm::clamp(ivec2(glm::round((box.corner + box.size) * size)), corner, lesson.size);
    return {corner, end - corner};
}

template <typename Visit>
int forEachPixel(const Region& region, const Visit& visit) {
    for (int y = region.corner.y; y < region.corner.y + region.size.y; ++y)
        for (int x = region.corner.x; x < region.corner.x + region.size.x; ++x)
            visit(x, y);
    return region.size.x * region.size.y;
}

/// Measures one state of a lesson. What several expectations need is made once.
class StateMeasure {
public:
    StateMeasure(const course::Lesson& lesson, const course::ShownState& state)
        : lesson_(lesson), state_(state), session_(state.scene), slots_(course::slotsOf(state.slots)), frames_(slots_.size()) {
        view_.camera = state.camera;
        view_.size = lesson.size;
    }

    MeasuredValue value(const course::Expectation& expected) {
        switch (course::quantityOf(expected).of) {
        case course::LessonQuantity::Of::visibility: return judged(expected);
        case course::LessonQuantity::Of::motion: return motion(expected);
        case course::LessonQuantity::Of::picture: return level(expected);
        case course::LessonQuantity::Of::reference: return againstReference(expected);
        case course::LessonQuantity::Of::fact: return fact(expected);
        }
        return {};
    }

private:
    /// The result of a slot's frame, with its answers for the light where it says them.
    struct Drawn {
        picture::RenderedFrame rendered;
        image::Image picture;
        std::optional<picture::Answers> answers;
    };

    const Drawn& drawn(int number) {
        std::optional<Drawn>& frame = frames_[static_cast<std::size_t>(number)];
        if (!frame) frame = draw(slots_[static_cast<std::size_t>(number)]);
        return *frame;
    }

    Drawn draw(picture::Slot& slot) {
        const bool answers = publishes(*slot.info, kVisibilityStage) && !state_.scene->lights.empty();
        Drawn drawn;
        drawn.rendered = session_.render(
            slot, view_, answers ? picture::requestAnswers(*slot.info, state_.light) : FrameRequest());
        drawn.picture = encoder_.encode(slot.target.color, state_.scene->exposure);
        if (answers) drawn.answers = picture::readAnswers(*slot.info, drawn.rendered, state_.light);
        return drawn;
    }

    MeasuredValue judged(const course::Expectation& expected) {
        const Drawn& frame = drawn(expected.slot);
        if (!frame.answers)
            throw Error(ExitStatus::badInput, scene::shownPath(lesson_.text.file) + ": '" + expected.quantity +
                                                  "' is about a light, and " +
                                                  state_.slots[static_cast<std::size_t>(expected.slot)].technique +
                                                  " says nothing of one here; choose another quantity");
        const judge::Truth& truth =
            session_.truth(view_, session_.truthFor(slots_[static_cast<std::size_t>(expected.slot)], state_.light));
        const picture::AnswerErrors found = picture::judgeAnswers(*frame.answers, truth, judge::trueBoundary(truth));
        const judge::SlotErrors& errors = found.errors;
        const judge::Counts& counts = errors.judgement.counts;
        if (expected.quantity == "rmse") return {counts.rmse, counts.pixels - counts.ties};
        if (expected.quantity == "edgeErrorPx")
            return {errors.edgeErrorPx.value_or(0), errors.edgeErrorPx ? counts.pixels - counts.ties : 0};
        if (expected.quantity == "coreErrors")
            return {static_cast<double>(found.core), counts.pixels - counts.ties};
        int lit = 0, dark = 0, judged = 0;
        forEachPixel(regionOf(lesson_, expected), [&](int x, int y) {
            const judge::Verdict verdict = errors.judgement.verdicts[truth.index(x, y)];
            lit += verdict == judge::Verdict::falseLit ? 1 : 0;
            dark += verdict == judge::Verdict::falseShadow ? 1 : 0;
            judged += verdict == judge::Verdict::correct ? 1 : 0;
        });
        judged += lit + dark;
        if (expected.quantity == "falseLit") return {static_cast<double>(lit), judged};
        if (expected.quantity == "falseShadow") return {static_cast<double>(dark), judged};
        if (expected.quantity == "wrongPercent") return {100.0 * (lit + dark) / std::max(judged, 1), judged};
        return {static_cast<double>(lit + dark), judged};
    }

    MeasuredValue motion(const course::Expectation& expected) {
        if (expected.quantity == "crawl") return crawl(expected);
        std::vector<picture::Slot> slots = course::slotsOf({state_.slots[static_cast<std::size_t>(expected.slot)]});
        picture::Session session(state_.scene);
        Measurement measurement(session, slots, state_.light, lesson_.size);
        for (int frame = 0; frame < lesson_.motion.frames; ++frame)
            measurement.addFrame(film::momentAt(lesson_.motion, base(), frame));
        const std::optional<double> rate = measurement.results()[0].excessFlipRate;
        return {rate.value_or(0), rate ? lesson_.motion.frames - 1 : 0};
    }

    MeasuredValue crawl(const course::Expectation& expected) {
        picture::Slot slot = std::move(course::slotsOf({state_.slots[static_cast<std::size_t>(expected.slot)]}).front());
        trace::SceneTracer tracer;
        tracer.advance(state_.scene, Deadline::max());
        judge::Crawl crawl;
        for (int frame = 0; frame < lesson_.motion.frames; ++frame) {
            View view = view_;
            view.camera = film::momentAt(lesson_.motion, base(), frame).camera;
            const StageKey stage = picture::visibilityOf(state_.light);
            const picture::RenderedFrame rendered = session_.render(slot, view, {.stages = {stage}});
            const picture::VisibilityImage visibility = picture::readVisibility(picture::findStage(rendered, stage));
            const judge::Truth truth = session_.truthAtCentres(view, session_.truthFor(slot, state_.light));
            std::vector<std::uint8_t> lit(truth.visibility.size()), truthLit(truth.visibility.size());
            for (std::size_t i = 0; i < lit.size(); ++i) {
                lit[i] = visibility.greyAlpha[2 * i] > 127 ? 1 : 0;
                truthLit[i] = truth.visibility[i] == trace::Visibility::lit ? 1 : 0;
            }
            crawl.addFrame(tracer, view.camera, view.size, std::move(lit), std::move(truthLit));
        }
        return {crawl.percent().value_or(0), crawl.followed()};
    }

    /// The scene with the state's camera as its own: motions begin there.
    [[nodiscard]] scene::Snapshot base() const {
        scene::Scene scene = *state_.scene;
        scene.camera = state_.camera;
        return std::make_shared<const scene::Scene>(std::move(scene));
    }

    MeasuredValue level(const course::Expectation& expected) {
        const image::Image& picture = drawn(expected.slot).picture;
        double sum = 0, squares = 0;
        const int pixels = forEachPixel(regionOf(lesson_, expected), [&](int x, int y) {
            const image::Color8 color = picture.at(x, y);
            const double level = (color.r + color.g + color.b) / 3.0;
            sum += level;
            squares += level * level;
        });
        if (pixels == 0) return {};
        const double mean = sum / pixels;
        if (expected.quantity == "meanLevel") return {mean, pixels};
        return {std::sqrt(std::max(0.0, squares / pixels - mean * mean)), pixels};
    }

    MeasuredValue againstReference(const course::Expectation& expected) {
        std::vector<picture::Slot> slots = course::slotsOf({*expected.reference});
        const image::Image reference = draw(slots[0]).picture;
        const image::Image& picture = drawn(expected.slot).picture;
        double squares = 0;
        int differing = 0;
        const int pixels = forEachPixel(regionOf(lesson_, expected), [&](int x, int y) {
            const image::Color8 a = picture.at(x, y), b = reference.at(x, y);
            for (const int difference : {a.r - b.r, a.g - b.g, a.b - b.b})
                squares += difference * difference;
            differing += a == b ? 0 : 1;
        });
        if (expected.quantity == "differing") return {static_cast<double>(differing), pixels};
        return {std::sqrt(squares / (3.0 * std::max(pixels, 1))), pixels};
    }

    MeasuredValue fact(const course::Expectation& expected) {
        const Drawn& frame = drawn(expected.slot);
        std::vector<std::string> known;
        if (expected.quantity == "counter") {
            for (const Counter& counter : frame.rendered.result.counters) {
                if (counter.id == expected.fact) return {counter.built, 1};
                known.push_back(counter.id);
            }
        } else {
            picture::Slot& slot = slots_[static_cast<std::size_t>(expected.slot)];
            const Probe probe = slot.technique->probe(state_.scene, view_, lab::pixelAt(expected.pixel, view_.size),
                                                      state_.scene->lights.empty() ? kNoLight : state_.light);
            for (const Probe::Fact& fact : probe.facts) {
                if (fact.label == expected.fact && fact.numbers.empty())
                    throw Error(ExitStatus::badInput, scene::shownPath(lesson_.text.file) + ": the fact '" +
                                                          fact.label + "' is no number but \"" + fact.value +
                                                          "\"; choose one that is");
                if (fact.label == expected.fact) return {std::ranges::max(fact.numbers), 1};
                if (!fact.numbers.empty()) known.push_back(fact.label);
            }
        }
        throw Error(ExitStatus::badInput, scene::shownPath(lesson_.text.file) + ": no " + expected.quantity +
                                              " is called '" + expected.fact + "'; " +
                                              suggestion(expected.fact, known));
    }

    const course::Lesson& lesson_;
    const course::ShownState& state_;
    picture::Session session_;
    picture::PictureEncoder encoder_;
    std::vector<picture::Slot> slots_;
    std::vector<std::optional<Drawn>> frames_; ///< one for each slot, drawn when it is first needed
    View view_;
};

} // namespace

std::vector<MeasuredValue> measureState(const course::Lesson& lesson, std::size_t state) {
    StateMeasure measure(lesson, lesson.states[state]);
    std::vector<MeasuredValue> values;
    for (const course::Expectation& expected : lesson.expectations)
        values.push_back(measure.value(expected));
    return values;
}

std::vector<MeasuredExpectation> measureLesson(const course::Lesson& lesson) {
    std::vector<MeasuredExpectation> measured(lesson.expectations.size());
    for (std::size_t state = 0; state < lesson.states.size(); ++state) {
        const std::vector<MeasuredValue> values = measureState(lesson, state);
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const course::Expectation& expected = lesson.expectations[i];
            measured[i].values[state] = values[i].value;
            measured[i].compared[state] = values[i].compared;
            measured[i].holds[state] = (state == 0 ? expected.before : expected.after).holds(values[i].value);
        }
    }
    return measured;
}

bool holdsAsExpected(const std::vector<MeasuredExpectation>& measured) {
    return !measured.empty() && std::ranges::all_of(measured, [](const MeasuredExpectation& one) {
        return one.holds[0] && one.holds[1] && one.compared[0] > 0 && one.compared[1] > 0;
    });
}

} // namespace shadowlab::report
