// A technique's visibility held against the exact judge, pixel by pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <ostream>

#include "app/judge/grid.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"

namespace shadowlab::testing {

/// Counts over all pixels. `falseLit` and `falseShadow` do not include pixels whose truth changes within `tiePx` of the
/// centre; those that would be wrong but for that are counted as `ties`.
struct TruthComparison {
    int compared = 0, lit = 0, shadowed = 0, turnedAway = 0, background = 0;
    int ties = 0, falseLit = 0, falseShadow = 0, coverage = 0;
    int core = 0;     ///< of the false ones: farther than 1.5 pixels from every true boundary (docs/conventions.md)
    int together = 0; ///< of the core ones: beside another one. A crack is a pixel alone, a wrong algorithm a region
    [[nodiscard]] int wrong() const { return falseLit + falseShadow + coverage; }
    TruthComparison& operator+=(const TruthComparison& other);
};
std::ostream& operator<<(std::ostream& stream, const TruthComparison& comparison);

/// How far from its centre a pixel's truth may change for the pixel to be excused; the hit is absent on background.
using TieRadius = std::function<double(const std::optional<trace::EyeHit>&)>;

/// The truth of one picture, found once and held against many.
class JudgedPicture {
public:
    JudgedPicture(scene::Snapshot snapshot, ivec2 size, int light, TieRadius tieRadiusPx);
    JudgedPicture(scene::Snapshot snapshot, ivec2 size, int light, double tieRadiusPx);

    [[nodiscard]] TruthComparison compare(const picture::VisibilityImage& image) const;
    /// How many pixels differ from the truth at their centres, ties included: for faults of thousands of pixels, each of which
    /// would have to be asked whether it is a tie.
    [[nodiscard]] int differing(const picture::VisibilityImage& image) const;

    [[nodiscard]] const scene::Snapshot& snapshot() const { return snapshot_; }
    [[nodiscard]] ivec2 size() const { return size_; }
    [[nodiscard]] int light() const { return light_; }
    [[nodiscard]] const std::optional<trace::EyeHit>& hit(int x, int y) const { return hits_.at(x, y); }
    [[nodiscard]] trace::Visibility truth(int x, int y) const { return truth_.at(x, y); }
    [[nodiscard]] bool isTie(int x, int y) const;

private:
    [[nodiscard]] float distanceToBoundary(int x, int y) const;

    scene::Snapshot snapshot_;
    ivec2 size_;
    int light_;
    TieRadius tieRadiusPx_;
    trace::ExactVisibility judge_;
    judge::Grid<std::optional<trace::EyeHit>> hits_;
    judge::Grid<trace::Visibility> truth_;
    mutable std::map<std::size_t, bool> ties_;               ///< of the pixels that were asked for
    mutable std::optional<judge::Grid<float>> distancePx_; ///< found when first asked for
};

/// Renders the visibility stage through the session, in a fresh slot with settings "param=value", and compares.
/// A pixel is excused when the truth is another one anywhere on circles of radius up to the tie radius around its
/// centre.
TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light,
                                 const TieRadius& tieRadiusPx);
TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light, double tieRadiusPx);

/// The visibility image alone.
picture::VisibilityImage renderVisibility(const scene::Snapshot& snapshot, const std::string& technique,
                                          const std::vector<std::string>& settings, ivec2 size, int light);

/// Two steps of the rasteriser's subpixel grid (GL_SUBPIXEL_BITS is 8 on Mesa's software renderers), and no less than
/// 1/64: nearer to an edge of the truth than this, no rasteriser promises on which side a pixel's centre falls.
inline constexpr double kTiePx = 1.0 / 64.0;

} // namespace shadowlab::testing
