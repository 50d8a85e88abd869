// `shadowlab report`: speed against error, for every technique's own sweeps.
// SPDX-License-Identifier: MIT
#include "app/cli/report.h"

#include <algorithm>

#include "app/cli/common_options.h"
#include "app/cli/measure.h"
#include "app/cli/messages.h"
#include "app/cli/progress.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/capture_arguments.h"
#include "app/lab/settings.h"
#include "app/picture/digest.h"
#include "app/report/machine.h"
#include "app/student/program_digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

using report::PlannedGroup;
using report::PointKey;

/// How often each point has its turn, and how long that is.
struct Effort {
    int rounds = 7; // of five frames each: thirty and more in all, enough for a 95th percentile
    report::TurnLength turn;
};
constexpr Effort kQuickEffort{3, {.warming = 2, .counted = 3, .resting = 1}};

class Reporter {
public:
    explicit Reporter(const ReportOptions& options)
        : options_(options), effort_(options.isQuick ? kQuickEffort : Effort{}), store_(options.output) {}

    int run() {
        loadScenes();
        context_ = context::createContext(options_.backend);
        requireDriverDraws(options_.size);
        const report::Plan plan = makePlan();
        store_.begin(plan);
        store_.keep(options_.shard, report::thisMachine(std::string(context_->backend())));
        const std::vector<PlannedGroup> groups = report::shardOf(plan, options_.shard);
        int work = 0;
        for (const PlannedGroup& group : groups)
            work += static_cast<int>(group.points.size()) * (1 + effort_.rounds);
        Progress progress("report: step", work, Progress::Remaining::told);
        progress_ = &progress;
        try {
            for (const PlannedGroup& group : groups)
                measureGroup(group);
        } catch (const context::Interrupted&) {
            note("interrupted; the same command goes on from here");
            throw;
        }
        writeReport(store_);
        if (measured_ == 0) note("all of it was measured before; for new times choose another folder");
        return 0;
    }

private:
    struct Shown {
        std::string asked;
        scene::Snapshot scene;
        int light;
    };

    void loadScenes() {
        std::vector<std::string> names = options_.scenes;
        if (names.empty())
            names = options_.isQuick ? std::vector<std::string>{"still-life", "room-with-lamps", "three-lights"}
                                     : scene::builtInScenes(context::assetsRoot());
        for (const std::string& name : names) {
            scene::Snapshot scene = scene::loadScene(name, loadOptions(options_.allowed));
            const int light = lightWithShadows(*scene, name, options_.light, "measured");
            if (std::ranges::any_of(scenes_, [&](const Shown& shown) { return shown.scene->name == scene->name; }))
                throw Error(ExitStatus::usage,
                            "two of the scenes are called '" + scene->name + "'; give them files of different names");
            scenes_.push_back({name, std::move(scene), light});
        }
    }

    [[nodiscard]] report::Plan makePlan() const {
        std::vector<std::string> techniques = options_.techniques;
        if (techniques.empty()) techniques = measuredTechniquesFrom({"all"});
        std::erase(techniques, report::kYardstick);
        techniques.emplace(techniques.begin(), report::kYardstick);
        report::Plan plan{SHADOWLAB_VERSION,
                          student::programDigest(),
                          options_.size,
                          options_.isQuick,
                          context::glRenderer(),
                          furtherWords(),
                          {}};
        for (const Shown& shown : scenes_) {
            const scene::Light& light = shown.scene->light(shown.light);
            PlannedGroup group{shown.asked, shown.scene->name, light.name, picture::digestOf(*shown.scene), {}};
            for (const std::string& technique : techniques)
                for (PointKey& point :
                     report::pointsOf(*picture::Session::makeSlot(technique).info, light, options_.isQuick))
                    group.points.push_back(std::move(point));
            plan.groups.push_back(std::move(group));
        }
        return plan;
    }

    [[nodiscard]] std::vector<std::string> furtherWords() const {
        std::vector<std::string> words;
        if (options_.backend != context::Backend::automatic) words = {"--backend", std::string(context_->backend())};
        for (const std::filesystem::path& folder : options_.allowed)
            words.insert(words.end(), {"--allow", folder.string()});
        const std::vector<std::string> global = course::globalArguments();
        words.insert(words.end(), global.begin(), global.end());
        return words;
    }

    void measureGroup(const PlannedGroup& group) {
        const Shown& shown = *std::ranges::find(scenes_, group.scene, &Shown::asked);
        report::Times times = store_.times(group, options_.shard);
        std::vector<picture::Slot> slots;
        for (const PointKey& point : group.points) {
            std::vector<picture::Slot> one;
            one.push_back(picture::Session::makeSlot(point.technique));
            std::vector<std::string> settings;
            for (const std::string& setting : point.settings)
                settings.push_back(point.technique + "." + setting);
            lab::applySettings(one, settings);
            slots.push_back(std::move(one.front()));
        }
        picture::Session session(shown.scene);
        judgeGroup(group, shown, session, slots);
        if (static_cast<int>(times.rounds.size()) >= effort_.rounds)
            return step(group.points.size() * times.rounds.size());
        step(group.points.size() * times.rounds.size());
        report::FrameTimer timer(session, shown.scene, options_.size, effort_.turn);
        for (std::size_t i = 0; i < slots.size(); ++i)
            timer.first(group.points[i].name(), slots[i], times);
        while (static_cast<int>(times.rounds.size()) < effort_.rounds) {
            const int round = static_cast<int>(times.rounds.size());
            report::Times::Round turns;
            for (std::size_t i = 0; i < slots.size(); ++i) {
                context::throwIfInterrupted();
                // Every other round runs backwards, so that no point always follows the same other point.
                const std::size_t at = round % 2 ? slots.size() - 1 - i : i;
                turns.emplace(group.points[at].name(), timer.turn(group.points[at].name(), slots[at], round));
                step(1);
            }
            times.rounds.push_back(std::move(turns));
            store_.keep(group, options_.shard, times);
            ++measured_;
        }
    }

    void judgeGroup(const PlannedGroup& group, const Shown& shown, picture::Session& session,
                    std::vector<picture::Slot>& slots) {
        View view;
        view.camera = shown.scene->camera;
        view.size = options_.size;
        std::optional<report::Judge> judge; // made when there is something to be judged: a truth takes seconds
        for (std::size_t i = 0; i < slots.size(); ++i) {
            context::throwIfInterrupted();
            if (!store_.judged(group, group.points[i])) {
                if (!judge) judge.emplace(session, view, shown.light);
                store_.keep(group, group.points[i], judge->judge(slots[i]));
                ++measured_;
            }
            step(1);
        }
    }

    void step(std::size_t count) {
        done_ += static_cast<int>(count);
        progress_->done(done_);
    }

    const ReportOptions& options_;
    Effort effort_;
    report::Store store_;
    std::vector<Shown> scenes_;
    std::unique_ptr<context::Context> context_;
    Progress* progress_ = nullptr;
    int done_ = 0;
    int measured_ = 0; ///< points and rounds that were not known before
};

} // namespace

int reportScenes(const ReportOptions& options) { return Reporter(options).run(); }

} // namespace shadowlab::cli
