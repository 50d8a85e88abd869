// A light in the wrong place.
//
// It moves each boundary by its own amount: the further the receiver is behind its caster, the more. So rays to a light that is moved
// predict every pixel. The usual slips give exact places, which are tried first; any other is found by search.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"
#include "app/picture/verdict_reasons.h"
#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/shading.h"

namespace shadowlab::foreign {

namespace {

using picture::fixed;

std::string vectorText(const dvec3& v) { return "(" + fixed(v.x, 3) + ", " + fixed(v.y, 3) + ", " + fixed(v.z, 3) + ")"; }

/// A place, or a direction, that a slip of the pen leads to.
struct Slip {
    std::string what; ///< before the place
    dvec3 value{0.0};
};

std::vector<Slip> slipsOf(const dvec3& right) {
    return {{"x is negated", {-right.x, right.y, right.z}},
            {"y is negated", {right.x, -right.y, right.z}},
            {"z is negated", {right.x, right.y, -right.z}},
            {"x and z are negated", {-right.x, right.y, -right.z}},
            {"all of it is negated", -right},
            {"y and z are exchanged", {right.x, right.z, right.y}},
            {"y and z are exchanged, and one of them negated", {right.x, -right.z, right.y}},
            {"y and z are exchanged, and one of them negated", {right.x, right.z, -right.y}},
            {"x and y are exchanged", {right.y, right.x, right.z}},
            {"x and z are exchanged", {right.z, right.y, right.x}}};
}

class MovedLight {
public:
    explicit MovedLight(const Evidence& evidence)
        : evidence_(evidence), source_(evidence.source()), isDirection_(source_.type == scene::LightType::directional), casts_(castingTriangles(evidence)) {}

    void addSlips(std::vector<Cause>& causes) const {
        const dvec3 right = isDirection_ ? source_.directionWorld : source_.positionWorld;
        std::vector<Slip> slips = slipsOf(right);
        if (!isDirection_) {
            for (const double factor : {100.0, 0.01})
                slips.push_back({factor > 1 ? "it is 100 times too large" : "it is 100 times too small", factor * right});
            for (const scene::Light& other : evidence_.tracer.scene().lights)
                if (other.type != scene::LightType::directional && &other != &source_) slips.push_back({"it is that of '" + other.name + "'", other.positionWorld});
        }
        // As small a change as rays could not see is none.
        constexpr double kNoChange = 1e-3;
        for (const Slip& slip : slips) {
            if (glm::length(slip.value - right) < kNoChange) continue;
            scene::Light moved = source_;
            (isDirection_ ? moved.directionWorld : moved.positionWorld) = slip.value;
            Cause cause{"light-displaced", "", "mend the light's " + std::string(isDirection_ ? "direction" : "position") + " where it is read or transformed", withLight(evidence_, moved, casts_)};
            if (isAllDark(cause.predictions)) continue;
            cause.likelihood = 0.97; // many are tried
            cause.what = (isDirection_ ? "the light's direction is wrong: " : "the light's position is wrong: ") + slip.what + ", so that it is " + vectorText(slip.value) +
                         ": this explains " + share(cause.predictions) + " of the wrong pixels";
            addIfExplains(evidence_, std::move(cause), causes);
        }
    }

    void addSearched(std::vector<Cause>& causes) const {
        const double distance = isDirection_ ? 1 : std::max(glm::length(source_.positionWorld - evidence_.camera.targetWorld), 1e-6);
        const Evidence some = thinned(evidence_);
        // Of two places that explain as much, the nearer.
        constexpr double kForNearer = 1e-3;
        const auto costIn = [&](const Evidence& evidence, const std::vector<double>& by) {
            return kForNearer * std::hypot(by[0], by[1], isDirection_ ? 0.0 : by[2]) / distance - explained(evidence, withLight(evidence, movedBy(by), casts_));
        };
        const auto costOf = [&](const std::vector<double>& by) { return costIn(some, by); };
        const std::vector<double> none(isDirection_ ? 2 : 3, 0.0);
        // From a step that moves a shadow by some pixels, and from a sixteenth of the distance, to what moves it by less than a hundredth of a
        // pixel: a small move is overlooked by steps that are large, and a large one by small steps.
        std::vector<double> by = none;
        for (const double part : {512.0, 16.0}) {
            if (costOf(by) <= -kAlmostAll) break;
            const std::vector<double> found = patternSearch(none, distance / part, distance / 8192, costOf);
            if (costOf(found) < costOf(by)) by = found;
        }
        if (costOf(by) > -kEnough) {
            // From far away: as far as the scene is wide.
            const std::vector<double> wide = patternSearch(none, std::max(distance / 2, 0.25 * sceneSize()), distance / 8192, costOf);
            if (costOf(wide) < costOf(by)) by = wide;
        }
        // With all samples, in steps from a quarter of what is found: how far it is moved along its rays shows in few pixels.
        const double length = std::hypot(by[0], by[1], isDirection_ ? 0.0 : by[2]);
        by = patternSearch(by, std::max(length / 4, distance / 8192), std::max(length / 128, distance / 65536), [&](const std::vector<double>& to) { return costIn(evidence_, to); });
        add(by, distance, causes);
    }

private:
    static constexpr double kAlmostAll = 0.99, kEnough = 0.8; ///< explained: no other place is looked for nearby, far away

    [[nodiscard]] double sceneSize() const {
        scene::Bounds all;
        for (const scene::Bounds& one : scene::objectBounds(evidence_.tracer.scene()))
            all.include(one);
        return isDirection_ || all.isEmpty() ? 0 : glm::length(all.upperWorld - all.lowerWorld);
    }
    /// Metres along the way to the target and across it, since what explains about as much lies along that way; or of a direction radians about two
    /// axes.
    [[nodiscard]] scene::Light movedBy(const std::vector<double>& by) const {
        scene::Light moved = source_;
        if (isDirection_) {
            const dvec3 aside = perpendicularTo(source_.directionWorld), across = glm::cross(source_.directionWorld, aside);
            moved.directionWorld = glm::normalize(source_.directionWorld + by[0] * aside + by[1] * across);
        } else {
            const dvec3 way = evidence_.camera.targetWorld - source_.positionWorld;
            const dvec3 along = glm::length(way) > 0 ? glm::normalize(way) : dvec3(0, -1, 0), aside = perpendicularTo(along);
            moved.positionWorld += by[0] * along + by[1] * aside + by[2] * glm::cross(along, aside);
        }
        return moved;
    }
    [[nodiscard]] static bool isAllDark(const Predictions& predictions) {
        return std::ranges::none_of(predictions, [](Prediction one) { return one == Prediction::lit; });
    }
    [[nodiscard]] std::string share(const Predictions& predictions) const { return percentText(explained(evidence_, predictions)); }

    void add(const std::vector<double>& by, double distance, std::vector<Cause>& causes) const {
        Cause cause{"light-displaced", "", "", withLight(evidence_, movedBy(by), casts_)};
        if (isAllDark(cause.predictions)) return; // a light behind a wall makes all dark
        const dvec3 offset = isDirection_ ? dvec3(by[0], by[1], 0.0) : movedBy(by).positionWorld - source_.positionWorld;
        // A light far away from its place explains much by chance.
        constexpr double kPlausible = 0.1; // of the distance
        cause.likelihood = glm::length(offset) < kPlausible * distance ? 0.98 : 0.75;
        const std::string explains = ", it explains " + share(cause.predictions) + " of the wrong pixels, boundaries far from their casters moved most";
        if (isDirection_) {
            cause.what = "the light comes from the wrong direction: turned by " + fixed(glm::degrees(glm::length(offset)), 2) + " degrees, to " + vectorText(movedBy(by).directionWorld) + explains;
            cause.remedy = "check the light's direction and its normalisation";
        } else {
            cause.what = "the light stands in the wrong place: " + metresText(glm::length(offset)) + " away, moved by " + vectorText(offset) + " m" + explains;
            cause.remedy = "check the light's position, its units, and in which space it is given";
        }
        addIfExplains(evidence_, std::move(cause), causes);
    }

    const Evidence& evidence_;
    const scene::Light& source_;
    bool isDirection_;
    std::vector<std::uint8_t> casts_;
};

} // namespace

void addMovedLightCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const MovedLight light(evidence);
    light.addSlips(causes);
    light.addSearched(causes);
}

} // namespace shadowlab::foreign
