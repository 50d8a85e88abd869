// What lights and casters cost that cannot be seen.
//
//   ninja -C build/release economy_bench && build/release/tests/economy_bench FOLDER [TECHNIQUE[,PARAM=VALUE...]]...
//
// Writes two scenes into the folder: crowded.json with eight lights and two hundred casters, and needed.json, from which all
// that cannot be seen is deleted (crowded_scene.h). Draws both, taking turns, the eye creeping aside from frame to frame so
// that nothing can be kept that depends on it. Printed are the medians, and the median of the ratios of turns that follow
// each other. The pictures must be equal byte by byte, but for those of maps, which are fitted to the casters there are; exits
// with 1 where they are not, or the ratio is above 2.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/speed/crowded_scene.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{640, 360};
constexpr int kRounds = 11, kWarming = 2;
constexpr double kMostTimes = 2.0;

/// One of the two scenes, drawn by one technique.
struct Entry {
    picture::Session session;
    std::vector<picture::Slot> slots = {};
    std::vector<double> ms = {};

    Entry(const scene::Snapshot& snapshot, const std::string& text) : session(snapshot) {
        std::istringstream words(text);
        std::string technique, setting;
        std::getline(words, technique, ',');
        slots.push_back(picture::Session::makeSlot(technique));
        while (std::getline(words, setting, ','))
            lab::applySettings(slots, {technique + "." + setting});
    }
    void draw(int frame) {
        View view;
        view.camera = session.snapshot()->camera;
        view.camera.targetWorld.x += 1e-4 * frame;
        view.size = kSize;
        ms.push_back(session.render(slots[0], view).frameMs);
    }
    std::vector<vec4> picture() { return gl::readTexels(slots[0].target.color); }
};

bool keepsTo(const std::string& technique, const scene::Snapshot& whole, const scene::Snapshot& part) {
    Entry crowded(whole, technique), needed(part, technique);
    bool same = true;
    for (int i = 0; i < kWarming + kRounds; ++i) {
        Entry* const order[] = {&crowded, &needed};
        for (int k = 0; k < 2; ++k)
            order[(i + k) % 2]->draw(i);
        if (i < kWarming) same = same && crowded.picture() == needed.picture();
    }
    std::vector<double> ratios;
    for (std::size_t i = kWarming; i < crowded.ms.size(); ++i)
        ratios.push_back(crowded.ms[i] / needed.ms[i]);
    const double ratio = median(ratios);
    std::printf("%-36s %10.2f %10.2f %8.2f  %s\n", technique.c_str(), median(crowded.ms), median(needed.ms), ratio,
                same ? "same bytes" : "another picture");
    std::fflush(stdout);
    return (same || technique.starts_with("shadow-map")) && ratio <= kMostTimes;
}

int run(const std::filesystem::path& folder, const std::vector<std::string>& techniques) {
    std::filesystem::create_directories(folder);
    scene::Snapshot snapshots[2];
    for (int i = 0; i < 2; ++i) {
        const std::filesystem::path file = folder / (i == 0 ? "crowded.json" : "needed.json");
        image::OutputFile output(file);
        output.write(speed::crowdedScene(i == 0));
        output.commit();
        snapshots[i] =
            scene::loadScene(file.string(), {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    }
    std::printf("%-36s %10s %10s %8s\n", "technique", "crowded ms", "needed ms", "ratio");
    bool all = true;
    for (const std::string& technique : techniques)
        all = keepsTo(technique, snapshots[0], snapshots[1]) && all;
    return all ? 0 : 1;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "economy_bench FOLDER [TECHNIQUE[,PARAM=VALUE...]]...\n");
        return 2;
    }
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        std::vector<std::string> techniques(argv + 2, argv + argc);
        if (techniques.empty())
            techniques = {"planar",
                          "shadow-map",
                          "shadow-map,filter=hard",
                          "shadow-volume-zpass,eye-correction=true",
                          "shadow-volume-zfail",
                          "shadow-volume",
                          "ray-traced"};
        return shadowlab::run(argv[1], techniques);
    } catch (const shadowlab::Error& error) {
        std::fprintf(stderr, "economy_bench: %s\n", error.what());
        return 1;
    }
}
