// What a whole frame cannot be quicker than, measured: floors (floors.h) beside the techniques.
//
//   ninja -C build/release floor_bench
//   build/release/tests/floor_bench SCENE [FOLDER_WITH_ITS_MESHES [TECHNIQUE...]]
//
// Floors and techniques take turns, twelve frames at a time, the first light one degree further in each. Printed are the medians of a
// frame, and of the ratio of each technique to its floor in the same turn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/film/motion.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/floors.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

using speed::Floor;

constexpr ivec2 kSize{1280, 720};
constexpr int kRounds = 9, kFrames = 12, kWarming = 4;

/// Draws a whole frame and waits for it; milliseconds. Volumes are extruded before the clock starts.
double floorMs(speed::Floors& floors, Floor floor, const film::Moment& shown) {
    if (floor == Floor::passing || floor == Floor::failing) floors.extrude(shown.snapshot);
    const auto begin = std::chrono::steady_clock::now();
    floors.draw(floor, shown.snapshot, shown.camera, {.first = 0, .count = kSize.x});
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// A technique, and the floor of its kind.
struct Entry {
    std::string technique;
    std::vector<std::string> settings;
    Floor floor;
    std::vector<picture::Slot> slots{};
    std::vector<double> techniqueMs{}, floorMs{}, ratios{}; ///< medians, of each turn
};

/// The techniques that have a floor of their kind; or those that are named, others beside the plain frame.
std::vector<Entry> chosen(const std::vector<std::string>& named) {
    std::vector<Entry> entries;
    entries.push_back({"unshadowed", {}, Floor::plain});
    entries.push_back({"shadow-map", {"shadow-map.filter=hard", "shadow-map.resolution=2048"}, Floor::map});
    entries.push_back({"ray-traced", {}, Floor::plain});
    entries.push_back({"shadow-volume-zpass", {}, Floor::passing});
    entries.push_back({"shadow-volume-zfail", {}, Floor::failing});
    entries.push_back({"shadow-volume", {}, Floor::passing});
    if (named.empty()) return entries;
    for (const std::string& name : named)
        if (std::ranges::find(entries, name, &Entry::technique) == entries.end()) entries.push_back({name, {}, Floor::plain});
    std::erase_if(entries, [&](const Entry& entry) { return std::ranges::find(named, entry.technique) == named.end(); });
    return entries;
}

int run(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "floor_bench SCENE [FOLDER_WITH_ITS_MESHES [TECHNIQUE...]]\n");
        return 2;
    }
    scene::LoadOptions options{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
    if (argc > 2) options.allowed.emplace_back(argv[2]);
    const scene::Snapshot base = scene::loadScene(argv[1], options);
    std::vector<Entry> entries = chosen({argv + std::min(argc, 3), argv + argc});
    for (Entry& entry : entries) {
        entry.slots.push_back(picture::Session::makeSlot(entry.technique));
        lab::applySettings(entry.slots, entry.settings);
    }
    const film::Motion motion{.frames = 360, .orbitLightDegrees = 360.0, .orbitCameraDegrees = {}, .path = {}};
    picture::Session session(base);
    speed::Floors floors(kSize);
    scene::Snapshot previous;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<film::Moment> moments;
        for (int i = 0; i < kFrames; ++i) {
            film::Moment shown = film::momentAt(motion, base, kFrames * round + i, previous);
            previous = shown.snapshot;
            moments.push_back(std::move(shown));
        }
        for (std::size_t e = 0; e < entries.size(); ++e) {
            Entry& entry = entries[round % 2 ? entries.size() - 1 - e : e];
            std::vector<double> ours, floor;
            for (int i = 0; i < kFrames; ++i) {
                const double ms = floorMs(floors, entry.floor, moments[static_cast<std::size_t>(i)]);
                if (i >= kWarming) floor.push_back(ms);
            }
            gl::FinishedPicture finished;
            for (int i = 0; i < kFrames; ++i) {
                const film::Moment& shown = moments[static_cast<std::size_t>(i)];
                session.setScene(shown.snapshot);
                View view;
                view.camera = shown.camera;
                view.size = kSize;
                FrameRequest request;
                request.finished = &finished;
                const double ms = session.render(entry.slots.front(), view, request).frameMs;
                if (i >= kWarming) ours.push_back(ms);
            }
            entry.techniqueMs.push_back(median(ours));
            entry.floorMs.push_back(median(floor));
            entry.ratios.push_back(entry.techniqueMs.back() / entry.floorMs.back());
        }
    }
    std::printf("%s, %d x %d, %s, light moving\n%-24s %9s %9s %7s\n", argv[1], kSize.x, kSize.y, context::glRenderer().c_str(),
                "technique", "frame ms", "floor ms", "ratio");
    for (const Entry& entry : entries)
        std::printf("%-24s %9.2f %9.2f %7.2f\n", entry.technique.c_str(), median(entry.techniqueMs), median(entry.floorMs), median(entry.ratios));
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        return shadowlab::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "floor_bench: %s\n", error.what());
        return 1;
    }
}
