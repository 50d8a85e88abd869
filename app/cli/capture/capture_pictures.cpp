// `shadowlab capture` without --ui: draws the pictures of the techniques, one frame after another, and writes them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <utility>

#include "app/cli/capture/capture_checks.h"
#include "app/cli/capture/capture_outputs.h"
#include "app/cli/capture/capture_stats.h"
#include "app/cli/common_options.h"
#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/film/film_encoder.h"
#include "app/film/motion.h"
#include "app/lab/settings.h"
#include "app/picture/derived_stages.h"
#include "app/picture/difference_panel.h"
#include "app/picture/panel.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/picture/stage_ref.h"
#include "app/picture/steps/step_captions.h"
#include "app/picture/steps/stepping.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/foundation/scene/query/view/empty_view.h"

namespace shadowlab::cli {

namespace {

bool isBlack(const image::Image& picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3 && picture.rgba[i] != 0) return false; // the fourth is alpha
    return true;
}

class Capture {
public:
    explicit Capture(const CaptureOptions& options)
        : options_(options), exactVisibility_(options.techniques.size() == 1 && !options.stages.empty() &&
                                              options.stages[0].isVisibility()),
          size_(options.size) {}

    int run() {
        for (const std::string& id : options_.techniques)
            slots_.push_back(picture::Session::makeSlot(id));
        lab::applySettings(slots_, options_.settings);
        checkOutputs(options_);
        loadScene();
        motion_ = motionOf(options_.motion, *base_);
        requirePlaceForNumbers(options_, motion_.frames);
        checkFurtherOutputs(options_, motion_.frames);
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            stages_.emplace_back();
            if (i < options_.stages.size())
                stages_[i] = picture::resolve(options_.stages[i], *slots_[i].info, *base_, defaultLight_);
        }

        context_ = context::createContext(options_.backend);
        checkGlLimits();
        sayNotes();
        session_ = std::make_unique<picture::Session>(base_);
        encoder_ = std::make_unique<picture::PictureEncoder>();
        stats_ = std::make_unique<CaptureStats>(*base_, options_, *context_, slots_);
        if (isFilm(options_)) film_ = film::makeFilm(options_.output, options_.time, stats_->pngText());
        if (options_.steps) {
            renderSteps();
            return 0;
        }
        for (int frame = 0; frame < motion_.frames; ++frame) {
            context::throwIfInterrupted();
            renderFrame(frame);
        }
        context::throwIfInterrupted();
        if (film_) film_->finish();
        if (!options_.stats.empty()) image::writeWhole(options_.stats, stats_->json());
        return 0;
    }

private:
    void loadScene() {
        base_ = loadSeenFrom(options_.scene, options_.view, loadOptions(options_.allowed, options_.normals));
        image::requireNoInput(numbered(options_.output, 0)); // it may be an image that the scene shows
        if (!options_.light.empty()) defaultLight_ = picture::lightIndex(*base_, options_.light);
    }

    /// Said when nothing stands in the way of the picture any more: a refusal is one line, without remarks before it.
    void sayNotes() const {
        for (const std::string& remark : base_->notes)
            note(remark);
        if (base_->lights.empty())
            note("scene '" + base_->name + "' has no lights: no shadow is drawn, and what lights it is ambient light, its background or what glows");
        if (base_->objects.empty()) note("scene '" + base_->name + "' has no objects; only its background is seen");
        for (const std::string& remark : lab::settingsWithoutEffect(slots_))
            note(remark);
    }

    /// Checks the driver's limits before anything is allocated.
    void checkGlLimits() const {
        const int needed = requireDrawable(options_);
        const int limit = context::largestSide();
        if (needed > limit)
            throw Error(ExitStatus::overLimit, "the picture needs " + std::to_string(needed) +
                                                   " samples on a side, this OpenGL driver draws " +
                                                   std::to_string(limit) +
                                                   "; choose a smaller --size or --supersample");
    }

    /// One picture after another: of each step what it shows in the window, and its title below.
    void renderSteps() {
        const film::Moment moment = film::momentAt(motion_, base_, 0, session_->snapshot());
        session_->setScene(moment.snapshot);
        View view;
        view.camera = moment.camera;
        view.size = options_.size;
        const std::vector<StageKey> passes = session_->render(slots_[0], view, {}).result.passes;
        if (options_.labels) captions_.emplace(*slots_[0].info, passes, *base_, font(), options_.size);
        if (captions_) size_.y -= captions_->height();
        if (size_.y < 2 * options_.size.y / 3)
            throw Error(ExitStatus::usage,
                        "--size: no room for the titles of the steps below the picture; choose a larger "
                        "size, or --labels false");
        for (step_ = 0; step_ < passes.size(); ++step_) {
            context::throwIfInterrupted();
            stages_[0] = picture::shownInStep({passes[step_], true}, *slots_[0].info,
                                              picture::stageLight(*base_, defaultLight_));
            renderFrame(0);
        }
        film_->finish();
    }

    void renderFrame(int frame) {
        const film::Moment moment = film::momentAt(motion_, base_, frame, session_->snapshot());
        session_->setScene(moment.snapshot);
        std::vector<picture::Cell> cells =
            picture::layoutCells(options_.layout, static_cast<int>(slots_.size()), size_, options_.split);
        const std::filesystem::path path = numbered(options_.output, frame);
        sayWhyNothingIsSeen(moment, cells[0].pictureSize, frame);
        if (options_.layout == picture::Layout::diff) {
            View view;
            view.camera = moment.camera;
            view.size = cells[0].pictureSize;
            writeFigure(frame, path, cells, {difference(view)});
            return;
        }
        if (exactVisibility_) {
            writeVisibility(path, cells[0], moment.camera);
            return;
        }
        std::vector<picture::Panel> panels;
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            picture::RenderedPanel drawn = picture::renderPanel(*session_, slots_[i], *encoder_, cells[i],
                                                                panelRequest(i, cells[i], moment.camera));
            stats_->add(i, drawn.rendered);
            if (options_.labels && slots_.size() > 1) drawn.panel.title = slots_[i].info->title;
            panels.push_back(std::move(drawn.panel));
        }
        if (frame == 0) sayThatAllIsBlack(panels);
        writeFigure(frame, path, cells, panels);
    }

    /// Of finished pictures, where nothing else was said of why there is nothing to be seen.
    void sayThatAllIsBlack(const std::vector<picture::Panel>& panels) const {
        if (saidWhyNothingIsSeen_ || base_->objects.empty() || !std::ranges::all_of(stages_, &picture::ResolvedStage::isPicture)) return;
        if (std::ranges::all_of(panels, isBlack, &picture::Panel::picture))
            note("every pixel is black: no light reaches what is in view, or nothing there reflects any; a rect, a spot and what glows with \"emits\": \"front\" shine to one side "
                 "alone, and what is closed keeps light in or out");
    }

    /// Of the first picture without any surface. What the second camera sees is another question.
    void sayWhyNothingIsSeen(const film::Moment& moment, ivec2 size, int frame) {
        const bool isOutside =
            !options_.stages.empty() && std::ranges::all_of(options_.stages, &picture::StageRef::isOutside);
        if (saidWhyNothingIsSeen_ || isOutside || base_->objects.empty()) return; // without objects it was said before
        const std::string why = scene::whyNothingIsSeen(*moment.snapshot, moment.camera, options_.supersample * size);
        if (why.empty()) return;
        note((motion_.frames > 1 ? "in frame " + std::to_string(frame + 1) + " no surface is in view: "
                                 : "no surface is in view: ") +
             why);
        saidWhyNothingIsSeen_ = true;
    }

    void writeFigure(int frame, const std::filesystem::path& path, const std::vector<picture::Cell>& cells,
                     const std::vector<picture::Panel>& panels) {
        const bool needsFont = std::ranges::any_of(
            panels, [](const picture::Panel& p) { return !p.title.empty() || picture::hasLegend(p); });
        const picture::Figure figure = picture::composeFigure(cells, panels, size_, needsFont ? &font() : nullptr);
        if (frame == 0)
            for (const std::string& remark : figure.notes)
                note(remark);
        if (film_)
            film_->add(captions_ ? captions_->below(figure.picture, step_, panels.front().note) : figure.picture);
        else
            image::writeWhole(path, image::encodePng(figure.picture, {.opaque = true, .text = stats_->pngText()}));
    }

    /// Both techniques' answers for one light, and one picture of what is wrong with either.
    picture::Panel difference(const View& view) {
        if (base_->lights.empty())
            throw Error(ExitStatus::usage, "--layout: diff is about one light and scene '" + base_->name +
                                               "' has none; choose another layout or scene");
        const int light = std::max(defaultLight_, 0);
        for (const picture::Slot& slot : slots_) // refuses a technique that says nothing of one light
            picture::resolve({std::string(kVisibilityStage)}, *slot.info, *base_, light);
        picture::RenderedDifference drawn =
            picture::renderDifference(*session_, slots_, *encoder_, view, light, markWidth(), !options_.stats.empty());
        for (std::size_t i = 0; i < slots_.size(); ++i)
            stats_->add(i, drawn.rendered[i]);
        if (options_.labels)
            drawn.panel.title = std::string(slots_[0].info->title) + " against " + std::string(slots_[1].info->title);
        return std::move(drawn.panel);
    }

    /// What the cell of a slot shows.
    picture::PanelRequest panelRequest(std::size_t i, const picture::Cell& cell, const scene::Camera& camera) {
        picture::PanelRequest request;
        request.stage = stages_[i];
        request.camera = camera;
        request.supersample = options_.supersample;
        if (picture::followsPicked(*slots_[i].info, stages_[i].key.id)) {
            request.picked = within("--pixel", options_.pixel, cell.pictureSize);
            request.partner = within("--partner", options_.partner, cell.pictureSize);
        }
        request.row = options_.row;
        request.outside = outsideCamera();
        request.markWidth = markWidth();
        request.outsideChoice = picture::outsideChoiceOf(options_.volumes, options_.nearClip, *base_, "--volumes");
        request.typeHeight = size_.y;
        if (stages_[i].isDerived()) request.font = &font();
        request.liftsSteps = options_.steps;
        request.timePasses = !options_.stats.empty();
        return request;
    }

    /// The visibility image itself: measured shares, not a figure of them.
    void writeVisibility(const std::filesystem::path& path, const picture::Cell& cell, const scene::Camera& camera) {
        const View view = picture::viewOf(cell, *slots_[0].info, panelRequest(0, cell, camera));
        FrameRequest request = picture::frameFor(stages_[0]);
        request.timePasses = !options_.stats.empty();
        const picture::RenderedFrame rendered = session_->render(slots_[0], view, request);
        stats_->add(0, rendered);
        const picture::VisibilityImage visibility =
            picture::readVisibility(picture::findStage(rendered, stages_[0].key));
        image::writeWhole(
            path, image::encodeGreyAlpha(visibility.width, visibility.height, visibility.greyAlpha, stats_->pngText()));
    }

    [[nodiscard]] int markWidth() const {
        return options_.enlarge ? picture::wideMark(options_.size.y) : picture::kOnePixel;
    }

    const image::Font& font() {
        if (!font_) font_ = std::make_unique<image::Font>(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
        return *font_;
    }

    /// A pixel that was asked for, of a picture of that size: each of several is smaller than the whole. Of its samples, the
    /// one in the middle.
    [[nodiscard]] std::optional<ivec2> within(const std::string& option, std::optional<ivec2> pixel, ivec2 size) const {
        if (!pixel) return {};
        if (pixel->x >= size.x || pixel->y >= size.y)
            throw Error(ExitStatus::usage, option + ": each technique's picture has " + std::to_string(size.x) + " x " +
                                               std::to_string(size.y) + " pixels; choose one within");
        return *pixel * options_.supersample + options_.supersample / 2;
    }

    /// The second camera that was asked for, its other properties those of the scene's.
    [[nodiscard]] std::optional<scene::Camera> outsideCamera() const {
        if (!options_.outside) return {};
        const auto& [x, y, z, targetX, targetY, targetZ] = *options_.outside;
        scene::Camera camera = scene::outsideCameraFor(*base_, base_->camera);
        camera.positionWorld = {x, y, z};
        camera.targetWorld = {targetX, targetY, targetZ};
        if (!scene::hasView(camera))
            throw Error(ExitStatus::usage, "--outside: from there nothing can be seen; choose a target apart from the "
                                           "camera, and not straight above or below it");
        return camera;
    }

    const CaptureOptions& options_;
    const bool exactVisibility_; ///< the output is the visibility image itself, not a figure of it
    scene::Snapshot base_;
    film::Motion motion_;
    int defaultLight_ = kNoLight;
    std::unique_ptr<context::Context> context_; ///< before all that lives in it, so that it is destroyed after them
    std::unique_ptr<picture::Session> session_;
    std::unique_ptr<picture::PictureEncoder> encoder_;
    std::vector<picture::Slot> slots_;
    std::vector<picture::ResolvedStage> stages_; ///< one for each slot
    std::unique_ptr<CaptureStats> stats_;
    ivec2 size_;                       ///< of the picture, without what stands below it
    std::unique_ptr<film::Film> film_; ///< none: a file for each picture
    std::unique_ptr<image::Font> font_;
    std::optional<picture::StepCaptions> captions_; ///< of steps, and the one that is drawn now
    std::size_t step_ = 0;
    bool saidWhyNothingIsSeen_ = false;
};

} // namespace

int capturePictures(const CaptureOptions& options) { return Capture(options).run(); }

} // namespace shadowlab::cli
