// SPDX-License-Identifier: MIT
#include "tests/support/truth_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/judge/metrics/boundary.h"
#include "app/lab/settings.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::testing {

using trace::Visibility;

namespace {

// Farther than this from a true boundary no aliasing is to blame (docs/conventions.md).
constexpr float kCorePx = 1.5f;

/// Rings no wider apart than a quarter of the radius, 16 directions each: what lies within a disc is found.
bool truthChangesWithin(const trace::ExactVisibility& judge, const scene::Camera& camera, dvec2 centre, ivec2 size,
                        int light, double radius, Visibility truth) {
    for (int ring = 4; ring >= 1; --ring)
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * M_PI * i / 16, r = radius * ring / 4;
            if (judge.at(camera, centre + r * dvec2(std::cos(angle), std::sin(angle)), size, light) != truth)
                return true;
        }
    return false;
}

/// How many of the pixels have another one among their eight neighbours; they are in the order of rows.
int countTogether(const std::vector<ivec2>& pixels) {
    std::vector<bool> together(pixels.size(), false);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t j = i + 1; j < pixels.size() && pixels[j].y <= pixels[i].y + 1; ++j)
            if (std::abs(pixels[j].x - pixels[i].x) <= 1) together[i] = together[j] = true;
    return static_cast<int>(std::ranges::count(together, true));
}

} // namespace

TruthComparison& TruthComparison::operator+=(const TruthComparison& other) {
    compared += other.compared, lit += other.lit, shadowed += other.shadowed, turnedAway += other.turnedAway;
    background += other.background, ties += other.ties, falseLit += other.falseLit, falseShadow += other.falseShadow;
    coverage += other.coverage, core += other.core, together += other.together;
    return *this;
}

std::ostream& operator<<(std::ostream& stream, const TruthComparison& c) {
    return stream << c.compared << " compared: " << c.lit << " lit, " << c.shadowed << " shadowed, " << c.turnedAway
                  << " turned away, " << c.background << " background; " << c.falseLit << " false lit, "
                  << c.falseShadow << " false shadow, " << c.coverage << " wrong coverage, " << c.core
                  << " of the false ones core errors, " << c.together << " of those together, " << c.ties << " ties";
}

picture::VisibilityImage renderVisibility(const scene::Snapshot& snapshot, const std::string& technique,
                                          const std::vector<std::string>& settings, ivec2 size, int light) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    std::vector<std::string> full;
    for (const std::string& setting : settings)
        full.push_back(technique + "." + setting);
    lab::applySettings(slots, full);
    picture::Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = size;
    FrameRequest request;
    request.stages = {{"visibility", light}};
    const picture::RenderedFrame frame = session.render(slots[0], view, request);
    return picture::readVisibility(picture::findStage(frame, {"visibility", light}));
}

JudgedPicture::JudgedPicture(scene::Snapshot snapshot, ivec2 size, int light, TieRadius tieRadiusPx)
    : snapshot_(std::move(snapshot)), size_(size), light_(light), tieRadiusPx_(std::move(tieRadiusPx)),
      judge_(snapshot_), hits_(size.x, size.y), truth_(size.x, size.y) {
    trace::parallelFor(static_cast<std::size_t>(size.y), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < size.x; ++x) {
            std::optional<trace::EyeHit>& hit = hits_.at(x, y);
            hit = judge_.eyeHit(snapshot_->camera, dvec2(x + 0.5, y + 0.5), size_);
            truth_.at(x, y) = hit ? judge_.visibility(*hit, snapshot_->camera, light_) : Visibility::noSurface;
        }
    });
}

JudgedPicture::JudgedPicture(scene::Snapshot snapshot, ivec2 size, int light, double tieRadiusPx)
    : JudgedPicture(std::move(snapshot), size, light,
                    [=](const std::optional<trace::EyeHit>&) { return tieRadiusPx; }) {}

TruthComparison JudgedPicture::compare(const picture::VisibilityImage& image) const {
    TruthComparison result;
    std::vector<ivec2> core;
    for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) {
            const Visibility truth = truth_.at(x, y);
            ++result.compared;
            result.background += truth == Visibility::noSurface;
            result.turnedAway += truth == Visibility::turnedAway;
            result.shadowed += truth == Visibility::shadowed;
            result.lit += truth == Visibility::lit;
            const bool covered = image.alpha(x, y) == 255, lit = image.grey(x, y) > 127;
            const bool coverageWrong = covered != (truth != Visibility::noSurface);
            const bool litWrong = lit != (truth == Visibility::lit);
            if (!coverageWrong && !litWrong) continue;
            if (isTie(x, y)) {
                ++result.ties;
            } else if (coverageWrong) {
                ++result.coverage;
            } else {
                ++(lit ? result.falseLit : result.falseShadow);
                if (distanceToBoundary(x, y) > kCorePx) core.emplace_back(x, y);
            }
        }
    result.core = static_cast<int>(core.size());
    result.together = countTogether(core);
    return result;
}

int JudgedPicture::differing(const picture::VisibilityImage& image) const {
    int count = 0;
    for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) {
            const Visibility truth = truth_.at(x, y);
            const bool covered = image.alpha(x, y) == 255, lit = image.grey(x, y) > 127;
            count += covered != (truth != Visibility::noSurface) || lit != (truth == Visibility::lit);
        }
    return count;
}

bool JudgedPicture::isTie(int x, int y) const {
    const auto [known, isNew] = ties_.try_emplace(hits_.index(x, y), false);
    if (isNew)
        known->second = truthChangesWithin(judge_, snapshot_->camera, dvec2(x + 0.5, y + 0.5), size_, light_,
                                           tieRadiusPx_(hits_.at(x, y)), truth_.at(x, y));
    return known->second;
}

float JudgedPicture::distanceToBoundary(int x, int y) const {
    if (!distancePx_) {
        judge::Grid<judge::Shade> shades(size_.x, size_.y);
        judge::Grid<std::uint32_t> receivers(size_.x, size_.y);
        for (std::size_t i = 0; i < hits_.values.size(); ++i) {
            using enum Visibility;
            const Visibility truth = truth_.values[i];
            shades.values[i] = truth == lit          ? judge::Shade::lit
                               : truth == shadowed   ? judge::Shade::shadowed
                               : truth == turnedAway ? judge::Shade::turnedAway
                                                     : judge::Shade::outside;
            receivers.values[i] = hits_.values[i] ? hits_.values[i]->object : ~0u;
        }
        distancePx_ = judge::distanceToBoundary(judge::boundaryEdges(shades, receivers), size_);
    }
    return distancePx_->at(x, y);
}

TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light,
                                 const TieRadius& tieRadiusPx) {
    return JudgedPicture(snapshot, size, light, tieRadiusPx)
        .compare(renderVisibility(snapshot, technique, settings, size, light));
}

TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light, double tieRadiusPx) {
    return JudgedPicture(snapshot, size, light, tieRadiusPx)
        .compare(renderVisibility(snapshot, technique, settings, size, light));
}

} // namespace shadowlab::testing
