// Mistakes of counting. A shadow volume begins at the faces of a caster that are turned to the light (the front cap), goes on along the
// light's rays, and ends at infinity (the back cap). A pixel is in as many volumes as there are such faces between it and
// the light; what a count without caps, without some faces, or from an eye in shadow gives instead, follows from where the pixel's ray
// enters and leaves the volumes.
// Crow, "Shadow Algorithms for Computer Graphics", 1977; Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes", 2002.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"

namespace shadowlab::foreign {

namespace {

/// The numbers that counts are made of, for one pixel.
struct VolumeCounts {
    bool facesLight = false;
    int around = 0;      ///< volumes that the pixel's point is in
    int aroundEye = 0;   ///< those that the eye's ray begins in, at the near plane
    int entered = 0;     ///< front caps beyond the point through which the ray enters a volume
    int left = 0;        ///< and through which it leaves one
    int own = 0;         ///< +1: the point lies on a front cap, seen from the light's side
    int atInfinity = 0;  ///< volumes that the ray ends in
    int atEnd = 0;       ///< those that it is in where it leaves the scene: the volumes may end there
    std::array<bool, 4> sides{}; ///< does the ray enter, leave a volume before the point; enter, leave one beyond it?
};

class Volumes {
public:
    explicit Volumes(const Evidence& evidence)
        : evidence_(evidence), tracer_(evidence.tracer), light_(evidence.source()), sides_(sidesOfLight(tracer_, light_)),
          casts_(castingTriangles(evidence)), caps_(casts_) {
        const std::vector<std::uint8_t> closed = closedObjects(tracer_.scene());
        // Of a closed caster the faces turned to the light; of an open one every triangle.
        for (std::size_t i = 0; i < caps_.size(); ++i)
            if (closed[tracer_.world().objects[i]] && sides_[i] <= 0) caps_[i] = 0;
        for (const scene::Bounds& one : scene::objectBounds(tracer_.scene()))
            bounds_.include(one);
        far_ = bounds_.isEmpty() ? 1 : 2 * glm::length(bounds_.upperWorld - bounds_.lowerWorld);
    }

    [[nodiscard]] VolumeCounts at(const Sample& sample, const trace::EyeRays& rays) const {
        VolumeCounts counts;
        counts.facesLight = tracer_.facesLight(sample.point, evidence_.light);
        if (!counts.facesLight) return counts;
        const trace::Ray eye = rays.through(dvec2(sample.pixel) + 0.5);
        const dvec3 pointCentred = tracer_.positionCentred(sample.point);
        const dvec3 startCentred = eye.originCentred + eye.nearest * eye.directionCentred;
        counts.around = within(pointCentred, sample.point.primitive);
        counts.aroundEye = within(startCentred, trace::kNoPrimitive);

        trace::Ray beyond;
        beyond.originCentred = pointCentred;
        beyond.directionCentred = eye.directionCentred;
        beyond.nearest = trace::kContactPerMetre * (1 + glm::length(pointCentred));
        for (const Crossing& crossing : crossings(tracer_, beyond, sample.point.primitive, caps_))
            ++((sides_[crossing.primitive] > 0) == crossing.fromFront ? counts.entered : counts.left);
        if (caps_[sample.point.primitive]) counts.own = 1; // its lit side is what is seen
        if (light_.type != scene::LightType::directional) {
            trace::Ray fromLight;
            fromLight.originCentred = light_.positionWorld - tracer_.world().originWorld;
            fromLight.directionCentred = eye.directionCentred;
            counts.atInfinity = static_cast<int>(crossings(tracer_, fromLight, trace::kNoPrimitive, caps_).size());
        }
        counts.atEnd = within(leavesSceneAt(pointCentred, eye.directionCentred), trace::kNoPrimitive);
        lookForSides(counts, startCentred, pointCentred, glm::normalize(eye.directionCentred));
        return counts;
    }

private:
    /// Where a ray leaves the box around all objects.
    [[nodiscard]] dvec3 leavesSceneAt(const dvec3& fromCentred, const dvec3& way) const {
        double least = far_ / glm::length(way);
        for (int axis = 0; axis < 3; ++axis) {
            const double wall = (way[axis] > 0 ? bounds_.upperWorld : bounds_.lowerWorld)[axis] - tracer_.world().originWorld[axis];
            if (way[axis] != 0) least = std::min(least, std::max(0.0, (wall - fromCentred[axis]) / way[axis]));
        }
        constexpr double kBeyond = 1e-6; // of the scene's size: past what lies in the wall itself
        return fromCentred + least * way + (kBeyond * far_) * glm::normalize(way);
    }
    [[nodiscard]] int within(const dvec3& placeCentred, std::uint32_t leftOut) const {
        return static_cast<int>(crossings(tracer_, rayToLight(tracer_, placeCentred, light_), leftOut, caps_).size());
    }
    [[nodiscard]] bool isShaded(const dvec3& placeCentred) const {
        return isBlockedBy(tracer_, rayToLight(tracer_, placeCentred, light_), trace::kNoPrimitive, casts_);
    }
    /// Where the ray changes between light and shadow, it crosses a volume's side.
    void lookForSides(VolumeCounts& counts, const dvec3& startCentred, const dvec3& pointCentred, const dvec3& way) const {
        constexpr int kSteps = 24; // narrower volumes are missed: they explain few pixels
        bool before = isShaded(startCentred);
        for (int i = 1; i <= kSteps; ++i) {
            const bool now = i < kSteps ? isShaded(glm::mix(startCentred, pointCentred, static_cast<double>(i) / kSteps)) : counts.around > 0;
            if (now != before) counts.sides[now ? 0 : 1] = true;
            before = now;
        }
        for (int i = 1; i <= kSteps; ++i) {
            const bool now = isShaded(pointCentred + way * (far_ * std::pow(static_cast<double>(i) / kSteps, 2)));
            if (now != before) counts.sides[now ? 2 : 3] = true;
            before = now;
        }
        if (before) counts.sides[3] = true; // the back cap
    }

    const Evidence& evidence_;
    const trace::SceneTracer& tracer_;
    const scene::Light& light_;
    std::vector<std::int8_t> sides_;
    std::vector<std::uint8_t> casts_, caps_;
    scene::Bounds bounds_;
    double far_ = 1;
};

struct Rule {
    const char* id;
    const char* what;
    const char* remedy;
    bool (*isDark)(const VolumeCounts& counts);
    double likelihood = 1;
};

constexpr const char* kCaps = "z-fail needs both caps: the faces turned to the light where they are, and once more at infinity";
constexpr const char* kBothFaces = "draw front faces and back faces of the volume, without culling, and count the one up and the other down";

// Two ways to ask the stencil: is it another number than zero, or is it greater? And the cap that a lit surface is itself may pass its own
// depth test or not.
constexpr std::array kRules{
    Rule{"missing-front-cap", "the front cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left + c.own != 0; }},
    Rule{"missing-front-cap", "the front cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left + c.own > 0; }},
    Rule{"missing-front-cap", "the front cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left != 0; }},
    Rule{"missing-front-cap", "the front cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left > 0; }},
    Rule{"missing-back-cap", "the back cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around - c.atInfinity != 0; }},
    Rule{"missing-back-cap", "the back cap of the shadow volumes is missing", kCaps, [](const VolumeCounts& c) { return c.around - c.atInfinity > 0; }},
    Rule{"missing-back-cap", "the back cap of the shadow volumes is missing, where they end just behind the scene", kCaps, [](const VolumeCounts& c) { return c.around - c.atEnd != 0; }},
    Rule{"missing-back-cap", "the back cap of the shadow volumes is missing, where they end just behind the scene", kCaps, [](const VolumeCounts& c) { return c.around - c.atEnd > 0; }},
    Rule{"missing-caps", "both caps of the shadow volumes are missing, which end just behind the scene", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left + c.own - c.atEnd != 0; }, 0.98},
    Rule{"missing-caps", "both caps of the shadow volumes are missing, which end just behind the scene", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left - c.atEnd != 0; }, 0.98},
    Rule{"missing-caps", "both caps of the shadow volumes are missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left + c.own - c.atInfinity != 0; }, 0.98},
    Rule{"missing-caps", "both caps of the shadow volumes are missing", kCaps, [](const VolumeCounts& c) { return c.around + c.entered - c.left + c.own - c.atInfinity > 0; }, 0.98},
    Rule{"eye-in-shadow", "the eye stands in shadow, and the count does not know it: it is off by the volumes around the eye",
         "count with z-fail, or begin the count of z-pass with the volumes that the near plane is in", [](const VolumeCounts& c) { return c.around - c.aroundEye != 0; }},
    Rule{"eye-in-shadow", "the eye stands in shadow, and the count does not know it: it is off by the volumes around the eye",
         "count with z-fail, or begin the count of z-pass with the volumes that the near plane is in", [](const VolumeCounts& c) { return c.around - c.aroundEye > 0; }},
    Rule{"back-faces-missing", "back faces of the shadow volumes are missing: what lies behind a volume is dark like what lies in it", kBothFaces,
         [](const VolumeCounts& c) { return c.sides[0]; }},
    Rule{"back-faces-missing", "back faces of the shadow volumes are missing: what has a volume behind it is dark", kBothFaces,
         [](const VolumeCounts& c) { return c.sides[2] || c.entered > 0; }},
    Rule{"front-faces-missing", "front faces of the shadow volumes are missing: what has a volume behind it is dark like what lies in it", kBothFaces,
         [](const VolumeCounts& c) { return c.sides[3]; }},
    Rule{"front-faces-missing", "front faces of the shadow volumes are missing: what lies behind a volume is dark, what lies in it is lit", kBothFaces,
         [](const VolumeCounts& c) { return c.sides[1]; }},
};

} // namespace

void addVolumeCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const Volumes volumes(evidence);
    const trace::EyeRays rays = evidence.tracer.eyeRays(evidence.camera, evidence.size());
    std::vector<VolumeCounts> counts(evidence.samples.size());
    forSamples(evidence, [&](std::size_t i) { counts[i] = volumes.at(evidence.samples[i], rays); });
    for (const Rule& rule : kRules) {
        Cause cause{rule.id, "", rule.remedy, Predictions(counts.size(), Prediction::none)};
        cause.likelihood = rule.likelihood;
        for (std::size_t i = 0; i < counts.size(); ++i)
            if (counts[i].facesLight) cause.predictions[i] = predicted(!rule.isDark(counts[i]));
        cause.what = std::string(rule.what) + ": counted so, " + percentText(explained(evidence, cause.predictions)) + " of the wrong pixels come out as they are";
        addIfExplains(evidence, std::move(cause), causes);
    }
}

} // namespace shadowlab::foreign
