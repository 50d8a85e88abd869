// SPDX-License-Identifier: MIT
#include "app/report/frame_timer.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "app/judge/metrics/frame_times.h"
#include "app/report/spread.h"

namespace shadowlab::report {

namespace {

using SteadyClock = std::chrono::steady_clock;
using judge::elapsedMs;

/// Of this process in memory. 0 where the system does not say.
double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return file ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20) : 0;
}

// A turn takes about so long at most: ten seconds for a round of thirty points, in which a machine's speed seldom changes.
constexpr double kTurnMs = 400;

} // namespace

film::Moment FrameTimer::momentOf(int frame) {
    const film::Motion motion{.frames = 360, .orbitLightDegrees = 360.0, .orbitCameraDegrees = {}, .path = {}};
    film::Moment moment = film::momentAt(motion, base_, frame % motion.frames, previous_);
    previous_ = moment.snapshot;
    return moment;
}

picture::RenderedFrame drawMoment(picture::Session& session, picture::Slot& slot, const film::Moment& moment,
                                  gl::FinishedPicture& finished, ivec2 size, bool timesPasses) {
    session.setScene(moment.snapshot);
    View view;
    view.camera = moment.camera;
    view.size = size;
    FrameRequest request;
    request.timePasses = timesPasses;
    request.finished = &finished;
    return session.render(slot, view, request);
}

/// What is left to do for the picture: nothing, where finished pixels were drawn.
double FrameTimer::encode(picture::Slot& slot, const picture::RenderedFrame& drawn, const film::Moment& moment) {
    const SteadyClock::time_point start = SteadyClock::now();
    encoder_.finish(picture_, slot.target, drawn.result, moment.snapshot->exposure);
    glFinish();
    return elapsedMs(start);
}

void FrameTimer::first(const std::string& name, picture::Slot& slot, Times& times) {
    const double before = residentMegabytes();
    const film::Moment moment = momentOf(0);
    times.firstMs[name] = draw(slot, moment).frameMs;
    times.residentMegabytes[name] = std::max(0.0, residentMegabytes() - before);
    const SteadyClock::time_point start = SteadyClock::now();
    draw(slot, momentOf(1));
    usualMs_[name] = elapsedMs(start);
}

Turn FrameTimer::turn(const std::string& name, picture::Slot& slot, int round) {
    const double usualMs = std::max(usualMs_[name], 0.1);
    const int most = static_cast<int>(kTurnMs / usualMs);
    const int counted = std::clamp(most, 1, length_.counted);
    const int warming = std::clamp(most - counted, 0, length_.warming);
    const int resting = std::clamp(most, 1, length_.resting);
    Turn turn;
    int frame = round * (length_.warming + length_.counted);
    film::Moment moment;
    for (int i = 0; i < warming + counted; ++i) {
        moment = momentOf(frame++);
        const picture::RenderedFrame drawn = draw(slot, moment);
        const double encodeMs = encode(slot, drawn, moment);
        if (i < warming) continue;
        turn.frame.push_back(drawn.frameMs + encodeMs);
        turn.prepare.push_back(drawn.prepareMs);
        turn.draw.push_back(drawn.frameMs - drawn.prepareMs);
        turn.encode.push_back(encodeMs);
    }
    for (int i = 0; i < resting; ++i) {
        const picture::RenderedFrame drawn = draw(slot, moment);
        turn.atRest.push_back(drawn.frameMs + encode(slot, drawn, moment));
    }
    for (const gl::PassTimer::Result& pass : draw(slot, momentOf(frame), true).result.passMs)
        turn.passes.push_back({pass.name, pass.elapsedMs});
    return turn;
}

std::optional<Costs> costsOf(const Times& times, const std::string& point, const std::string& yardstick) {
    Costs costs;
    std::vector<double> frame, prepare, draw, encode, atRest, shadow;
    std::map<std::string, std::vector<double>> passes;
    std::vector<std::string> order;
    const auto add = [](std::vector<double>& to, const std::vector<double>& more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    for (const Times::Round& round : times.rounds) {
        const auto turn = round.find(point);
        if (turn == round.end()) continue;
        add(frame, turn->second.frame), add(prepare, turn->second.prepare), add(draw, turn->second.draw);
        add(encode, turn->second.encode), add(atRest, turn->second.atRest);
        for (const Costs::Pass& pass : turn->second.passes) {
            if (!passes.contains(pass.id)) order.push_back(pass.id);
            passes[pass.id].push_back(pass.ms);
        }
        if (const auto base = round.find(yardstick); base != round.end())
            shadow.push_back(judge::median(turn->second.frame) - judge::median(base->second.frame));
    }
    if (frame.empty()) return std::nullopt;
    costs.frames = static_cast<int>(frame.size());
    costs.frame = spreadOf(frame), costs.prepare = spreadOf(prepare), costs.draw = spreadOf(draw);
    costs.encode = spreadOf(encode), costs.atRest = spreadOf(atRest), costs.shadow = spreadOf(shadow);
    for (const std::string& id : order)
        costs.passes.push_back({id, judge::median(passes[id])});
    if (const auto first = times.firstMs.find(point); first != times.firstMs.end()) costs.firstMs = first->second;
    if (const auto grown = times.residentMegabytes.find(point); grown != times.residentMegabytes.end())
        costs.residentMegabytes = grown->second;
    return costs;
}

} // namespace shadowlab::report
