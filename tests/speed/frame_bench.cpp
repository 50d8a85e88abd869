// How long frames of several techniques take, drawn one after the other as fast as they can be, as a game would.
//
//   ninja -C build/release frame_bench
//   build/release/tests/frame_bench SCENE [--still] [TECHNIQUE[,PARAM=VALUE...]]...
//
// Techniques take turns, twelve frames at a time, the light one degree further in each (--still: it stays), so that whatever
// else the machine does falls on all alike. Of each turn the first frames do not count: caches are full of what the one
// before left there. Prints the median of a frame and what it costs more than the first technique's, which is `unshadowed`
// unless another is named first, and the median ratio to the second's in the same turn. `measure` prints times as well, but
// judges each frame in between, and so draws it with cold caches.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/film/motion.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{1280, 720};
constexpr int kRounds = 21, kFrames = 12, kWarming = 4;

struct Entry {
    std::string name; ///< as it was given
    std::vector<picture::Slot> slots;
    std::vector<double> turns; ///< median of each, milliseconds
};

/// "shadow-volume,repair=false" as a slot of its own with that set.
Entry entryOf(const std::string& text) {
    std::istringstream words(text);
    std::string technique, setting;
    std::getline(words, technique, ',');
    Entry entry{text, {}, {}};
    entry.slots.push_back(picture::Session::makeSlot(technique));
    while (std::getline(words, setting, ','))
        lab::applySettings(entry.slots, {technique + "." + setting});
    return entry;
}

double medianFrameMs(picture::Session& session, picture::Slot& slot, std::span<const film::Moment> moments) {
    std::vector<double> ms;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        session.setScene(moments[i].snapshot);
        View view;
        view.camera = moments[i].camera;
        view.size = kSize;
        const double frameMs = session.render(slot, view).frameMs;
        if (i >= kWarming) ms.push_back(frameMs);
    }
    return median(std::move(ms));
}

int run(int argc, char** argv) {
    bool still = false;
    std::vector<Entry> entries;
    for (int i = 2; i < argc; ++i) {
        if (std::strcmp(argv[i], "--still") == 0)
            still = true;
        else
            entries.push_back(entryOf(argv[i]));
    }
    if (argc < 2) {
        std::fprintf(stderr, "frame_bench SCENE [--still] [TECHNIQUE[,PARAM=VALUE...]]...\n");
        return 2;
    }
    if (entries.empty())
        for (const char* id : {"unshadowed", "shadow-volume-zpass,eye-correction=true", "shadow-volume-zfail",
                               "shadow-volume,repair=false"})
            entries.push_back(entryOf(id));

    const scene::Snapshot base =
        scene::loadScene(argv[1], {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    film::Motion motion{.frames = 360, .orbitLightDegrees = std::nullopt, .orbitCameraDegrees = {}, .path = {}};
    if (!still) motion.orbitLightDegrees = 360.0;
    picture::Session session(base);
    scene::Snapshot previous;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<film::Moment> moments;
        for (int i = 0; i < kFrames; ++i) {
            moments.push_back(film::momentAt(motion, base, (kFrames * round + i) % motion.frames, previous));
            previous = moments.back().snapshot;
        }
        for (std::size_t e = 0; e < entries.size(); ++e) {
            Entry& entry = entries[round % 2 ? entries.size() - 1 - e : e];
            entry.turns.push_back(medianFrameMs(session, entry.slots.front(), moments));
        }
    }
    std::printf("%s, %d x %d, %s, light %s\n%-44s %9s %9s %12s\n", argv[1], kSize.x, kSize.y,
                context::glRenderer().c_str(), still ? "still" : "moving", "technique", "frame ms", "cost ms",
                "to second");
    for (const Entry& entry : entries) {
        std::vector<double> cost, ratio;
        for (std::size_t i = 0; i < entry.turns.size(); ++i) {
            cost.push_back(entry.turns[i] - entries.front().turns[i]);
            if (entries.size() > 1) ratio.push_back(entry.turns[i] / entries[1].turns[i]);
        }
        std::printf("%-44s %9.2f %9.2f %12.3f\n", entry.name.c_str(), median(entry.turns), median(cost),
                    ratio.empty() ? 1.0 : median(ratio));
    }
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        return shadowlab::run(argc, argv);
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "frame_bench: %s\n", error.what());
        return 1;
    }
}
