// `shadowlab capture`: one picture, or a sequence, of one or several techniques.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/capture_stats.h"
#include "app/commands/command_line.h"
#include "app/context/signals.h"
#include "app/session/assets.h"
#include "app/session/orbit.h"
#include "app/session/picture.h"
#include "app/session/session.h"
#include "app/session/settings.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png.h"
#include "techniques/foundation/scene/load.h"

namespace shadowlab::commands {

namespace {

/// `name_####.png` with the hashes replaced by the frame's number, counted from 1, padded with zeros to their width.
std::filesystem::path numbered(const std::filesystem::path& pattern, int frame) {
    std::string name = pattern.filename().string();
    const std::size_t first = name.find('#');
    if (first == std::string::npos) return pattern;
    const std::size_t width = name.find_first_not_of('#', first) == std::string::npos ? name.size() - first : name.find_first_not_of('#', first) - first;
    std::string number = std::to_string(frame + 1);
    if (number.size() < width) number.insert(0, width - number.size(), '0');
    return pattern.parent_path() / name.replace(first, width, number);
}

class Capture {
public:
    explicit Capture(const CaptureOptions& options) : options_(options) {}

    int run() {
        image::probeWritable(numbered(options_.output, 0));
        if (!options_.stats.empty()) image::probeWritable(options_.stats);
        std::vector<std::string> notes;
        base_ = scene::loadScene(options_.scene, {.assetsRoot = session::assetsRoot(), .allowed = options_.allowed, .limits = {}});
        for (const std::string& note : base_->notes) std::fprintf(stderr, "shadowlab: note: %s\n", note.c_str());
        if (!options_.light.empty()) defaultLight_ = session::lightIndex(*base_, options_.light);
        for (const std::string& id : options_.techniques) slots_.push_back(session::Session::makeSlot(id));
        session::applySettings(slots_, options_.settings);
        for (const session::Slot& slot : slots_)
            if (!options_.stage.empty()) stages_.push_back(session::parseStage(options_.stage, *slot.info, *base_, defaultLight_));

        context_ = context::createContext(options_.backend);
        session_ = std::make_unique<session::Session>(base_);
        encoder_ = std::make_unique<session::PictureEncoder>();
        stats_ = std::make_unique<CaptureStats>(*base_, options_, *context_, slots_);
        for (int frame = 0; frame < options_.frames; ++frame) {
            context::throwIfInterrupted();
            renderFrame(frame);
        }
        if (!options_.stats.empty()) image::writeWhole(options_.stats, stats_->json());
        // The session's buffers and the slots' targets go before the context they live in.
        encoder_.reset();
        slots_.clear();
        session_.reset();
        return 0;
    }

private:
    void renderFrame(int frame) {
        const double share = static_cast<double>(frame) / options_.frames;
        session_->setScene(scene::Snapshot(options_.orbitLightDegrees ? session::withLightsTurned(base_, share * *options_.orbitLightDegrees) : base_));
        View view;
        view.camera = options_.orbitCameraDegrees ? session::turned(base_->camera, share * *options_.orbitCameraDegrees) : base_->camera;

        const std::vector<session::Cell> cells = session::layoutCells(options_.layout, static_cast<int>(slots_.size()), options_.size);
        const std::filesystem::path path = numbered(options_.output, frame);
        std::vector<session::Panel> panels;
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            session::Slot& slot = slots_[i];
            const bool exactVisibility = !stages_.empty() && !stages_[i].isPass && stages_[i].key.id == "visibility";
            const int supersample = exactVisibility ? 1 : options_.supersample;
            if (cells[i].pictureSize.x < 1 || cells[i].pictureSize.y < 1)
                throw Error(ExitStatus::usage, "--size: too small for " + std::to_string(slots_.size()) + " pictures; choose a larger size");
            view.size = cells[i].pictureSize * supersample;
            FrameRequest request;
            request.timePasses = !options_.stats.empty();
            if (!stages_.empty() && stages_[i].isPass) request.stopAfter = stages_[i].key;
            if (!stages_.empty() && !stages_[i].isPass) request.stages = {stages_[i].key};
            const session::RenderedFrame rendered = session_->render(slot, view, request);
            stats_->add(i, rendered);

            if (exactVisibility && slots_.size() == 1) {
                const session::VisibilityImage visibility = session::readVisibility(session::findStage(rendered, stages_[i].key));
                image::writeWhole(path, image::encodeGreyAlpha(visibility.width, visibility.height, visibility.greyAlpha, stats_->pngText()));
                return;
            }
            panels.push_back(panel(i, rendered, supersample));
        }
        const bool needsFont = std::ranges::any_of(panels, [](const session::Panel& p) { return !p.title.empty() || session::hasLegend(p); });
        if (needsFont && !font_) font_ = std::make_unique<image::Font>(session::assetsRoot() / "fonts" / "DejaVuSans.ttf");
        const image::Image figure = session::composeFigure(cells, panels, options_.size, font_.get());
        image::writeWhole(path, image::encodePng(figure, {.opaque = true, .text = stats_->pngText()}));
    }

    session::Panel panel(std::size_t i, const session::RenderedFrame& rendered, int supersample) const {
        const session::Slot& slot = slots_[i];
        session::Panel panel;
        if (options_.labels && slots_.size() > 1) panel.title = slot.info->title;
        if (stages_.empty() || stages_[i].isPass) {
            if (!stages_.empty()) session::requirePassRan(rendered, stages_[i].key, *slot.info);
            panel.picture = encoder_->encode(slot.target.color, base_->exposure, supersample);
            return panel;
        }
        const Stage& stage = session::findStage(rendered, stages_[i].key);
        const StageInfo& info = session::stageInfo(*slot.info, stage.key.id);
        const bool targetSized = stage.texture.size() == slot.target.size();
        panel.picture = encoder_->encode(stage, info.kind, base_->exposure, targetSized ? supersample : 1);
        panel.kind = info.kind;
        panel.display = stage.display;
        return panel;
    }

    const CaptureOptions& options_;
    scene::Snapshot base_;
    int defaultLight_ = kNoLight;
    std::unique_ptr<context::Context> context_;
    std::unique_ptr<session::Session> session_;
    std::unique_ptr<session::PictureEncoder> encoder_;
    std::vector<session::Slot> slots_;
    std::vector<session::StageChoice> stages_;
    std::unique_ptr<CaptureStats> stats_;
    std::unique_ptr<image::Font> font_;
};

} // namespace

int capture(const CaptureOptions& options) { return Capture(options).run(); }

} // namespace shadowlab::commands
