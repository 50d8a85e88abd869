// The three ways to count shadow volumes, each in the form that is meant to be exact, compared with the judge.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab::testing {

struct ExactWay {
    std::string technique;
    std::vector<std::string> settings;
};
inline const ExactWay kExactWays[] = {
    {"shadow-volume-zpass", {"eye-correction=true"}}, {"shadow-volume-zfail", {}}, {"shadow-volume", {}}};

// Isolated pixels at cracks between side faces: the rasteriser's rounding. About 2e-6 of the pixels with llvmpipe; other
// rasterisers clip a little worse.
inline constexpr double kCrackShare = 3e-5;

inline constexpr ivec2 kCaseSize{320, 240};

/// Fewer of them, and a comparison proves nothing.
struct Least {
    int lit = 500, shadowed = 500;
};

class VolumeCase : public GlTest {
protected:
    /// The truth of a picture, as far as it can be drawn here.
    [[nodiscard]] JudgedPicture judged(const scene::Scene& scene, int light = 0, ivec2 size = kCaseSize) const;

    /// All three ways: up to cracks as they are counted, and without a wrong pixel once repaired.
    static void expectExact(const JudgedPicture& picture, const Least& least = {});
    /// For each light of the scene.
    void expectExact(const scene::Scene& scene, const Least& least = {}) const;

    static picture::VisibilityImage draw(const JudgedPicture& picture, const std::string& technique,
                                         std::vector<std::string> settings = {});
    static picture::VisibilityImage draw(const JudgedPicture& picture, const ExactWay& way, bool repair);
    /// How many pixels a naive variant gets wrong: that is what shows that the comparison sees the fault.
    static int wrongWith(const JudgedPicture& picture, const std::string& technique,
                         const std::vector<std::string>& settings) {
        return picture.differing(draw(picture, technique, settings));
    }
    [[nodiscard]] static bool isRenderer(std::string_view name);
};

} // namespace shadowlab::testing
