// SPDX-License-Identifier: MIT
#include "tests/support/truth_comparison.h"

#include <cmath>

#include "app/session/settings.h"

namespace shadowlab::testing {

namespace {

/// Rings no wider apart than a quarter of the radius, 16 directions each: what lies within a disc is found.
bool truthChangesWithin(const trace::ExactVisibility& judge, const scene::Camera& camera, dvec2 centre, ivec2 size,
                        int light, double radius, trace::Visibility truth) {
    for (int ring = 4; ring >= 1; --ring)
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * M_PI * i / 16, r = radius * ring / 4;
            if (judge.at(camera, centre + r * dvec2(std::cos(angle), std::sin(angle)), size, light) != truth)
                return true;
        }
    return false;
}

} // namespace

TruthComparison& TruthComparison::operator+=(const TruthComparison& other) {
    compared += other.compared, lit += other.lit, shadowed += other.shadowed, turnedAway += other.turnedAway;
    background += other.background, ties += other.ties, falseLit += other.falseLit, falseShadow += other.falseShadow;
    coverage += other.coverage;
    return *this;
}

std::ostream& operator<<(std::ostream& stream, const TruthComparison& c) {
    return stream << c.compared << " compared: " << c.lit << " lit, " << c.shadowed << " shadowed, " << c.turnedAway
                  << " turned away, " << c.background << " background; " << c.falseLit << " false lit, "
                  << c.falseShadow << " false shadow, " << c.coverage << " wrong coverage, " << c.ties << " ties";
}

session::VisibilityImage renderVisibility(const scene::Snapshot& snapshot, const std::string& technique,
                                          const std::vector<std::string>& settings, ivec2 size, int light) {
    std::vector<session::Slot> slots;
    slots.push_back(session::Session::makeSlot(technique));
    std::vector<std::string> full;
    for (const std::string& setting : settings)
        full.push_back(technique + "." + setting);
    session::applySettings(slots, full);
    session::Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = size;
    FrameRequest request;
    request.stages = {{"visibility", light}};
    const session::RenderedFrame frame = session.render(slots[0], view, request);
    return session::readVisibility(session::findStage(frame, {"visibility", light}));
}

TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light,
                                 const TieRadius& tieRadiusPx) {
    const session::VisibilityImage image = renderVisibility(snapshot, technique, settings, size, light);
    using trace::Visibility;
    const trace::ExactVisibility judge(snapshot);
    const scene::Camera& camera = snapshot->camera;
    TruthComparison result;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const dvec2 centre(x + 0.5, y + 0.5);
            const std::optional<trace::EyeHit> hit = judge.eyeHit(camera, centre, size);
            const Visibility truth = hit ? judge.visibility(*hit, camera, light) : Visibility::noSurface;
            ++result.compared;
            result.background += truth == Visibility::noSurface;
            result.turnedAway += truth == Visibility::turnedAway;
            result.shadowed += truth == Visibility::shadowed;
            result.lit += truth == Visibility::lit;
            const bool covered = image.alpha(x, y) == 255, lit = image.grey(x, y) > 127;
            const bool coverageWrong = covered != hit.has_value();
            const bool litWrong = lit != (truth == Visibility::lit);
            if (!coverageWrong && !litWrong) continue;
            if (truthChangesWithin(judge, camera, centre, size, light, tieRadiusPx(hit), truth))
                ++result.ties;
            else if (coverageWrong)
                ++result.coverage;
            else
                ++(lit ? result.falseLit : result.falseShadow);
        }
    return result;
}

TruthComparison compareWithTruth(const scene::Snapshot& snapshot, const std::string& technique,
                                 const std::vector<std::string>& settings, ivec2 size, int light, double tieRadiusPx) {
    return compareWithTruth(snapshot, technique, settings, size, light,
                            [=](const std::optional<trace::EyeHit>&) { return tieRadiusPx; });
}

} // namespace shadowlab::testing
