// A plug-in for tests that is wrong in one way: which one, the environment variable MISBEHAVIOUR says.
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "techniques/frame.h"

namespace shadowlab::misbehaving {

namespace {

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};
const PassInfo kPasses[] = {{.id = "light", .title = "Add the light"}};

bool is(std::string_view behaviour) {
    const char* asked = std::getenv("MISBEHAVIOUR");
    return asked && asked == behaviour;
}

void misbehave() {
    volatile int* nowhere = nullptr;
    std::vector<std::vector<char>> memory;
    if (is("crashes")) *nowhere = 1;
    if (is("never-ends"))
        for (volatile int i = 0;; i = 0) {
        }
    while (is("eats-memory"))
        memory.emplace_back(std::size_t{16} << 20, 'x');
    if (is("throws")) throw std::runtime_error("the student's own words");
    if (is("breaks-gl")) glEnable(GL_COLOR); // no capability
    if (is("exits")) std::exit(0);
}

class Misbehaving final : public Technique {
public:
    Progress render(Frame& frame) override {
        frame.pass(kPasses[0], misbehave);
        return {};
    }
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    if (is("throws-in-list")) throw std::runtime_error("no list today");
    if (is("lists-none")) return {};
    if (is("crashes-in-list")) std::abort();
    if (is("exits-in-list")) std::exit(0);
    static const TechniqueInfo info[] = {{
        .id = is("bad-id")     ? "Bad Id"
              : is("taken-id") ? "shadow-map"
                               : "misbehaving",
        .title = "Misbehaving",
        .lightTypes = {scene::LightType::point},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Misbehaving>(); },
    }};
    return info;
}

} // namespace shadowlab::misbehaving
