// SPDX-License-Identifier: MIT
#include "app/course/explore/explored_slide.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/course/explore/explored_numbers.h"
#include "app/course/explore/explored_parts.h"
#include "app/course/explore/explored_variants.h"
#include "app/course/explore/lamp_track.h"
#include "app/course/state_motion.h"
#include "app/drawing/prose.h"
#include "app/judge/metrics/frame_times.h"
#include "app/picture/derived_stages.h"
#include "app/picture/judged_slot.h"
#include "app/picture/panel.h"
#include "app/picture/steps/step_source.h"
#include "app/picture/steps/stepping.h"
#include "app/picture/verdict_panels.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

using Json = nlohmann::json;

/// One technique with one value of a setting: what is drawn at every position of the lamp.
struct Variant {
    picture::Slot slot;
    std::vector<double> frameMs; ///< of each position
    std::vector<Json> states;    ///< of each position
};

film::Motion motionOf(const Explore& explore, int positions) {
    film::Motion motion;
    motion.frames = positions;
    if (positions > 1) motion.orbitLightDegrees = explore.lampDegrees;
    return motion;
}

class Explorer {
public:
    Explorer(const Slide& slide, const Explore& explore, const ExploreRequest& request, const image::Font& font,
             const image::Font& bold, FrameTimes& times)
        : slide_(slide), explore_(explore), request_(request), font_(font), bold_(bold), times_(times),
          state_(slide.pictures.front().state), panes_(panesOf(slide, explore)),
          motion_(motionOf(explore, state_.scene->lights.empty() ? 1 : request.size.lampPositions)),
          moments_(statesInMotion(state_, motion_)),
          light_(picture::stageLight(*state_.scene, state_.light)), session_(state_.scene), settings_(variantsOf(panes_, explore)) {
        for (const std::vector<lab::PaneState>& ofPane : settings_.drawn) {
            std::vector<Variant>& variants = variants_.emplace_back();
            for (const lab::PaneState& drawn : ofPane)
                variants.push_back({std::move(slotsOf({drawn}).front()), {}, {}});
        }
    }

    ExploredSlide draw() {
        const int positions = request_.lampPositionsToDraw > 0 ? std::min(request_.lampPositionsToDraw, motion_.frames) : motion_.frames;
        const bool isTrial = request_.lampPositionsToDraw > 0;
        std::size_t stateBytes = 0;
        for (int lamp = 0; lamp < positions; ++lamp) {
            // A trial's positions are spread over the track.
            const int frame = lamp * motion_.frames / positions;
            session_.setScene(moments_[static_cast<std::size_t>(frame)].scene);
            const std::size_t before = pack_.bytes().size();
            for (std::size_t pane = 0; pane < panes_.size(); ++pane)
                for (Variant& variant : variants_[pane]) {
                    variant.states.push_back(drawState(variant, frame));
                    if (request_.onState) request_.onState();
                }
            stateBytes += pack_.bytes().size() - before;
            if (isTrial ? lamp == 0 : isOneOf(request_.size.positionsWithSteps, frame))
                for (std::size_t pane = 0; pane < panes_.size(); ++pane) {
                    drawViews(pane, frame);
                    if (explore_.steps) drawSteps(pane, frame);
                }
            if (!isTrial && isOneOf(request_.size.askPositions, frame)) ask(frame);
        }
        const Json states = statesJson();
        return {json(states), pack_.bytes(), stateBytes, solvedStates(states)};
    }

private:
    [[nodiscard]] View view() const {
        View view;
        view.camera = state_.camera;
        view.size = request_.size.picture;
        return view;
    }

    /// Of all positions of the lamp some, evenly spread, the first among them.
    [[nodiscard]] bool isOneOf(int positions, int frame) const {
        const int every = (motion_.frames + positions - 1) / std::max(1, positions);
        return positions > 0 && frame % every == 0;
    }

    picture::Panel panel(picture::Slot& slot, const picture::ResolvedStage& stage, const std::optional<dvec2>& range = {}) {
        picture::Cell cell{0, 0, request_.size.picture.x, request_.size.picture.y, request_.size.picture, 0};
        picture::PanelRequest request;
        request.stage = stage;
        request.camera = state_.camera;
        request.supersample = stage.isDerived() ? 1 : request_.supersample;
        const SlidePicture& first = slide_.pictures.front();
        const ivec2 samples = request_.size.picture * request.supersample;
        if (first.pixel) request.picked = lab::pixelAt(*first.pixel, samples);
        if (first.partner) request.partner = lab::pixelAt(*first.partner, samples);
        request.font = &font_;
        request.liftsSteps = true;
        request.range = range;
        request.markWidth = picture::wideMark(request_.size.picture.y);
        picture::Panel panel = picture::renderPanel(session_, slot, encoder_, cell, request).panel;
        panel.picture = centred(panel.picture, request_.size.picture);
        return panel;
    }

    /// Photographs lose what is not seen; colours that mean something are kept as they are.
    int add(const picture::Panel& panel) {
        return pack_.add(panel.picture, panel.kind == StageKind::radiance ? image::WebpKind::photo : image::WebpKind::exact);
    }

    Json drawState(Variant& variant, int frame) {
        picture::Slot& slot = variant.slot;
        FrameRequest timed;
        timed.finished = &slot.finished;
        // The first frame finds silhouettes and builds trees: with a lamp that rests, the next ones are what a frame costs.
        const int frames = motion_.frames > 1 ? 1 : kFramesAtRest;
        for (int i = 0; i < frames; ++i)
            variant.frameMs.push_back(session_.render(slot, view(), timed).frameMs);
        // Judged next, while the technique still holds that frame: the picture below has more samples and is computed anew.
        std::optional<picture::JudgedSlot> judgedSlot;
        if (explore_.errors && light_ != kNoLight && publishes(*slot.info, kVisibilityStage))
            judgedSlot.emplace(picture::judgeSlot(session_, slot, view(), light_));
        Json state{{"lamp", frame}, {"picture", add(panel(slot, {}))}, {"numbers", Json::object()}};
        if (!judgedSlot) return state;
        const picture::JudgedSlot& judged = *judgedSlot;
        const judge::Counts& counts = judged.found.errors.judgement.counts;
        const picture::Panel verdicts =
            picture::errorOverlay(judged.truth, judged.found.errors.judgement, {}, picture::wideMark(request_.size.picture.y));
        const picture::Panel truth = picture::truthPanel(judged.truth, {});
        state["verdict"] = pack_.add(verdicts.picture, image::WebpKind::exact);
        state["truth"] = pack_.add(truth.picture, image::WebpKind::exact);
        keepLonger(verdictColors_, legendJson(verdicts));
        keepLonger(truthColors_, legendJson(truth));
        const ExploredNumbers numbers{judged.found.core, counts.falseLit, counts.falseShadow,
                                      counts.lit + counts.shadowed + counts.turnedAway, judged.found.errors.edgeErrorPx, {}};
        for (const ExploredNumber& number : kExploredNumbers)
            if (const auto& value = numbers.*number.value) state["numbers"][number.key] = *value;
        return state;
    }

    /// Colours without the counts of one state. What seldom occurs, a surface where there is none, is named only where it does.
    static void keepLonger(Json& kept, Json legend) {
        for (Json& entry : legend) {
            const std::string label = entry[1];
            entry[1] = label.substr(0, label.rfind(": "));
        }
        if (legend.size() > kept.size()) kept = std::move(legend);
    }

    void drawViews(std::size_t pane, int frame) {
        picture::Slot& slot = variants_[pane].front().slot;
        for (const picture::StageRef& stage : panes_[pane].stages) {
            const picture::ResolvedStage resolved = picture::resolve(stage, *slot.info, *state_.scene, state_.light);
            Json& view = place(views_, pane, stage.text());
            const std::string caption = picture::captionOf(*slot.info, resolved.key.id);
            view["label"] = caption.substr(0, caption.find_first_of(",;:(")); // the words before any explanation
            view["caption"] = caption;
            addAt(view, frame, slot, resolved);
        }
    }

    void drawSteps(std::size_t pane, int frame) {
        picture::Slot& slot = variants_[pane].front().slot;
        const picture::RenderedFrame whole = session_.render(slot, view());
        for (const StageKey& key : whole.result.passes) {
            const PassInfo& pass = passInfo(slot.info->passes, key.id);
            Json& step = place(steps_, pane, picture::refOf(key, true, *state_.scene).text());
            const bool namesLight = key.light != kNoLight && state_.scene->lights.size() > 1;
            step["title"] = std::string(pass.title) + (namesLight ? ", light " + state_.scene->light(key.light).name : "");
            step["why"] = pass.why;
            step["formula"] = linesOf(pass.formula);
            step["lines"] = Json::array();
            for (int line = std::max(1, pass.pseudocodeLines.first); line <= pass.pseudocodeLines.last; ++line)
                step["lines"].push_back(line);
            addAt(step, frame, slot, picture::shownInStep({key, true}, *slot.info, light_));
        }
    }

    /// What the stage shows with the lamp there. Colours that stand for numbers keep the range of the first position: a colour means one
    /// value however the lamp moves.
    void addAt(Json& shownAt, int frame, picture::Slot& slot, const picture::ResolvedStage& stage) {
        const std::string key = std::string(slot.info->id) + " " + stage.key.id + " " + std::to_string(stage.key.light);
        const auto range = ranges_.find(key);
        const picture::Panel shown = panel(slot, stage, range == ranges_.end() ? std::nullopt : std::optional(range->second));
        ranges_.try_emplace(key, shown.display.minimum, shown.display.maximum);
        if (!shownAt.contains("legend")) {
            shownAt["legend"] = legendJson(shown);
            shownAt["scale"] = scaleJson(shown);
            shownAt["note"] = shown.note;
        }
        shownAt["at"].push_back({frame, add(shown)});
    }
    static Json linesOf(std::string_view text) {
        Json lines = Json::array();
        std::istringstream stream{std::string(text)};
        for (std::string line; std::getline(stream, line);)
            lines.push_back(line);
        return lines;
    }

    /// The entry of that pane and id, in the order in which they were first drawn.
    static Json& place(Json& all, std::size_t pane, const std::string& id) {
        for (Json& one : all)
            if (one["pane"] == pane && one["id"] == id) return one;
        all.push_back({{"pane", pane}, {"id", id}, {"at", Json::array()}});
        return all.back();
    }

    void ask(int frame) {
        const std::vector<dvec2> points = askedPoints(request_.size.askPoints);
        if (points.empty()) return;
        if (ask_.is_null()) {
            ask_ = {{"points", Json::array()}, {"answers", Json::array()}};
            for (const dvec2& point : points)
                ask_["points"].push_back({point.x, point.y});
        }
        for (std::size_t pane = 0; pane < panes_.size(); ++pane)
            for (std::size_t i = 0; i < points.size(); ++i) {
                View asked = view();
                asked.picked = ivec2(points[i] * dvec2(asked.size));
                const PicturePack::Piece piece =
                    pack_.addPiece(answerOf(variants_[pane].front().slot, session_.snapshot(), asked, light_, font_, bold_));
                ask_["answers"].push_back({pane, frame, i, piece.offset, piece.length});
            }
    }

    /// Of a technique with its settings in this slide: measured now, unless it was measured before.
    double frameMs(std::size_t pane, std::size_t variant) {
        const picture::Slot& slot = variants_[pane][variant].slot;
        std::string key = slide_.name + " " + std::string(slot.info->id);
        for (const params::Param& param : slot.params)
            if (params::isChanged(param)) key += " " + param.id + "=" + params::valueText(param);
        key += " " + std::to_string(request_.size.picture.x) + "x" + std::to_string(request_.size.picture.y);
        const auto [found, isNew] = times_.emplace(key, 0);
        if (isNew) found->second = std::round(judge::median(variants_[pane][variant].frameMs) * 100) / 100; // no clock is finer here
        return found->second;
    }

    /// Does the lab change that parameter?
    [[nodiscard]] bool isTried(const std::string& id) const { return std::ranges::find(settings_.knobs, id, &Knob::id) != settings_.knobs.end(); }

    Json panesJson() const {
        Json panes = Json::array();
        for (std::size_t i = 0; i < panes_.size(); ++i) {
            const picture::Slot& slot = variants_[i].front().slot;
            Json lines = Json::array();
            for (const picture::StepLine& line : picture::stepSource(*slot.info, nullptr, slot.params, {}).pseudocode)
                lines.push_back(line.text);
            std::string settings;
            for (const params::Param& param : slot.params)
                if (params::isChanged(param) && !isTried(std::string(slot.info->id) + "." + param.id))
                    settings += (settings.empty() ? "" : ", ") + params::labelOf(param) + " " + valueWords(params::valueText(param), param);
            panes.push_back({{"technique", slot.info->id}, {"title", slot.info->title}, {"settings", settings}, {"pseudocode", std::move(lines)}});
        }
        return panes;
    }

    Json statesJson() {
        Json states = Json::array();
        for (std::size_t pane = 0; pane < panes_.size(); ++pane)
            for (std::size_t combination = 0; combination < settings_.combinations.size(); ++combination) {
                const auto own = static_cast<std::size_t>(settings_.places[pane][combination]);
                const double ms = request_.lampPositionsToDraw == 0 ? frameMs(pane, own) : 0;
                for (Json state : variants_[pane][own].states) {
                    state["pane"] = pane;
                    state["variant"] = combination;
                    state["numbers"]["frameMs"] = ms;
                    states.push_back(std::move(state));
                }
            }
        return states;
    }

    /// Whose shadows are judged and asked about, where there are several lights.
    [[nodiscard]] std::string lightNote() const {
        const std::size_t lights = state_.scene->lights.size();
        if (lights < 2) return "";
        return "All " + std::to_string(lights) + " lights turn together: in the plan the others are smaller. Errors, truth and answers are about the light '" +
               state_.scene->light(light_).name + "'.";
    }

    /// At how many places of the lamp, with whatever setting, the task is solved.
    [[nodiscard]] int solvedStates(const Json& states) const {
        if (!explore_.task) return 0;
        return static_cast<int>(std::ranges::count_if(states, [&](const Json& state) {
            const Json& numbers = state["numbers"];
            return state["pane"] == explore_.task->pane && numbers.contains(explore_.task->number) &&
                   explore_.task->bound.holds(numbers[explore_.task->number].get<double>());
        }));
    }

    Json taskJson() const {
        if (!explore_.task) return {};
        const ExploreTask& task = *explore_.task;
        return {{"question", drawing::proseMarkup(task.question)}, {"told", drawing::proseMarkup(task.told)}, {"pane", task.pane}, {"number", task.number},
                {"atLeast", task.bound.atLeast ? Json(*task.bound.atLeast) : Json()},
                {"atMost", task.bound.atMost ? Json(*task.bound.atMost) : Json()}};
    }

    std::string json(const Json& states) {
        Json sheets = Json::array(), settings = Json::array();
        for (const PicturePack::Sheet& sheet : pack_.sheets())
            sheets.push_back({sheet.piece.offset, sheet.piece.length, sheet.firstTile, sheet.count, sheet.columns, sheet.border});
        for (const Knob& knob : settings_.knobs)
            settings.push_back({{"id", knob.id}, {"label", knob.label}, {"values", knob.values}, {"labels", knob.labels}, {"start", knob.start}});
        const double aspect = static_cast<double>(request_.size.picture.x) / request_.size.picture.y;
        const Json all{{"width", request_.size.picture.x}, {"height", request_.size.picture.y}, {"tile", kTileSide},
                       {"sheets", std::move(sheets)}, {"maps", pack_.maps()}, {"panes", panesJson()},
                       {"lamp", motion_.frames > 1 ? lampTrack(moments_, explore_.lampDegrees, aspect, light_) : Json()},
                       {"settings", std::move(settings)}, {"variants", settings_.combinations}, {"states", states},
                       {"machine", request_.machine}, {"verdictColors", verdictColors_}, {"truthColors", truthColors_},
                       {"verdictNote", "A wrong pixel that stands alone is drawn as a square of " +
                                           std::to_string(picture::wideMark(request_.size.picture.y)) + " pixels."},
                       {"lightNote", lightNote()}, {"views", views_}, {"steps", steps_}, {"ask", ask_}, {"task", taskJson()}};
        return all.dump(-1, ' ', false, Json::error_handler_t::replace);
    }

    static constexpr int kFramesAtRest = 5;

    const Slide& slide_;
    const Explore& explore_;
    const ExploreRequest& request_;
    const image::Font &font_, &bold_;
    FrameTimes& times_;
    const ShownState& state_; ///< of the slide's first picture
    std::vector<ExploredPane> panes_;
    film::Motion motion_;
    std::vector<ShownState> moments_; ///< one for each position of the lamp
    int light_;
    picture::Session session_;
    picture::PictureEncoder encoder_;
    ExploredVariants settings_;
    std::vector<std::vector<Variant>> variants_; ///< of each pane
    PicturePack pack_;
    Json verdictColors_ = Json::array(), truthColors_ = Json::array(), views_ = Json::array(), steps_ = Json::array(), ask_;
    std::map<std::string, dvec2> ranges_; ///< of stages whose colours stand for numbers
};

} // namespace

ExploredSlide exploredSlide(const Slide& slide, const Explore& explore, const ExploreRequest& request, const image::Font& font,
                            const image::Font& bold, FrameTimes& times) {
    return Explorer(slide, explore, request, font, bold, times).draw();
}

int exploredStates(const Slide& slide, const Explore& explore, const ExploreSize& size) {
    int variants = 0;
    for (const std::vector<lab::PaneState>& ofPane : variantsOf(panesOf(slide, explore), explore).drawn)
        variants += static_cast<int>(ofPane.size());
    return variants * (slide.pictures.front().state.scene->lights.empty() ? 1 : size.lampPositions);
}

} // namespace shadowlab::course
