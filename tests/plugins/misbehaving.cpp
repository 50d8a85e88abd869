// Plug-ins that are wrong in one way each, for tests: which one, the build says (BEHAVIOUR), and under what name (MISBEHAVING).
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "techniques/frame.h"

namespace shadowlab::MISBEHAVING {

namespace {

enum Behaviour {
    crashes,
    neverEnds,
    eatsMemory,
    throws,
    breaksGl,
    badId,
    takenId,
    throwsInList,
    listsNone,
    crashesInList,
    exits
};

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};
const PassInfo kPasses[] = {{.id = "light", .title = "Add the light"}};

class Misbehaving final : public Technique {
public:
    Progress render(Frame& frame) override {
        frame.pass(kPasses[0], [&] { misbehave(frame); });
        return {};
    }

private:
    static void misbehave(Frame&) {
        volatile int* nowhere = nullptr;
        std::vector<std::vector<char>> memory;
        switch (BEHAVIOUR) {
        case crashes: *nowhere = 1; break;
        case neverEnds:
            for (volatile int i = 0;; i = 0) {
            }
        case eatsMemory:
            for (;;)
                memory.emplace_back(std::size_t{16} << 20, 'x');
        case throws: throw std::runtime_error("the student's own words");
        case breaksGl: glEnable(GL_TEXTURE_2D_ARRAY + 12345); break;
        case exits: std::exit(0);
        default: break;
        }
    }
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    if (BEHAVIOUR == throwsInList) throw std::runtime_error("no list today");
    if (BEHAVIOUR == listsNone) return {};
    if (BEHAVIOUR == crashesInList) std::abort();
    static const TechniqueInfo info[] = {{
        .id = BEHAVIOUR == badId     ? "Bad Id"
              : BEHAVIOUR == takenId ? "shadow-map"
                                     : "misbehaving",
        .title = "Misbehaving",
        .lightTypes = {scene::LightType::point},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Misbehaving>(); },
    }};
    return info;
}

} // namespace shadowlab::MISBEHAVING
