// Mistakes of sides. A program that leaves out back faces, or takes windings the wrong way round, loses triangles by the side that they
// turn: to the light, where they cast shadows, or to the eye, where they are seen. And a surface faces the light by its winding
// only if nothing turns its normal to the viewer.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <map>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"
#include "techniques/foundation/scene/query/shading.h"

namespace shadowlab::foreign {

namespace {

enum class Gate {
    viewer,   ///< normals are turned to the viewer: as it should be
    none,     ///< surfaces that are turned away are lit, too
    winding,  ///< the counter-clockwise side alone is ever lit
    inverted, ///< the clockwise side alone is
};

/// Which triangles cast shadows and are seen, and how surfaces face the light.
struct Rules {
    std::vector<std::uint8_t> casts;
    std::vector<std::uint8_t> seen; ///< empty: all
    Gate gate = Gate::viewer;
    std::int64_t gateOfObject = -1; ///< the gate is that of one object; -1: of all
};

class Sides {
public:
    explicit Sides(const Evidence& evidence)
        : evidence_(evidence), ofLight_(sidesOfLight(evidence.tracer, evidence.source())), casts_(castingTriangles(evidence)) {}

    [[nodiscard]] const std::vector<std::uint8_t>& allCast() const { return casts_; }
    /// Casters that turn that side to the light.
    [[nodiscard]] std::vector<std::uint8_t> castersWithSide(int side) const {
        return castersWhere([&](std::size_t i) { return ofLight_[i] == side; });
    }
    [[nodiscard]] std::vector<std::uint8_t> castersWithout(std::uint32_t object) const {
        return castersWhere([&](std::size_t i) { return objectOf(i) != object; });
    }
    [[nodiscard]] std::vector<std::uint8_t> castersOf(std::uint32_t object) const {
        return castersWhere([&](std::size_t i) { return objectOf(i) == object; });
    }
    /// Triangles that turn that side to the eye.
    [[nodiscard]] std::vector<std::uint8_t> seenWithSide(int side) const {
        scene::Light eye;
        eye.positionWorld = evidence_.camera.positionWorld;
        const std::vector<std::int8_t> ofEye = sidesOfLight(evidence_.tracer, eye);
        std::vector<std::uint8_t> flags(ofEye.size());
        for (std::size_t i = 0; i < flags.size(); ++i)
            flags[i] = ofEye[i] == side ? 1 : 0;
        return flags;
    }

    [[nodiscard]] Predictions predictions(const Rules& rules) const {
        const trace::SceneTracer& tracer = evidence_.tracer;
        const trace::EyeRays rays = tracer.eyeRays(evidence_.camera, evidence_.size());
        const scene::Light& light = evidence_.source();
        return predictAll(evidence_, [&](const Sample& sample) {
            trace::SurfacePoint point = sample.point;
            if (!rules.seen.empty()) {
                const trace::Ray ray = rays.through(dvec2(sample.pixel) + 0.5);
                trace::MayHit mayHit = tracer.mayMeet(trace::kNoPrimitive);
                mayHit.flags = rules.seen.data();
                point = tracer.surfacePoint(ray.directionCentred, closestOf(tracer, ray, mayHit));
            }
            if (!point) return ofBackground(evidence_, sample);
            if (!faces(rules, point)) return Prediction::dark;
            if (!tracer.objectOf(point).receivesShadow) return Prediction::lit;
            return predicted(!isBlockedBy(tracer, rayToLight(tracer, point, light), point.primitive, rules.casts));
        });
    }

    /// The objects that stand before the most wrong pixels, or that show them.
    [[nodiscard]] std::vector<std::uint32_t> suspects(bool casters) const {
        constexpr std::size_t kMost = 6; // of which each is asked for all samples
        return heaviest(kMost, [&](const Sample& sample) {
            if (!sample.isWrong() || sample.isLit != casters) return trace::kNoPrimitive;
            return casters ? evidence_.tracer.blocker(sample.point, evidence_.light) : sample.point.primitive;
        });
    }

    /// The objects in front of samples that are rightly dark.
    [[nodiscard]] std::vector<std::uint32_t> castersSeen() const {
        constexpr std::size_t kMost = 4;
        return heaviest(kMost, [&](const Sample& sample) {
            if (sample.isWrong() || sample.isLit || evidence_.truth.visibility[sample.index] != trace::Visibility::shadowed) return trace::kNoPrimitive;
            return evidence_.tracer.blocker(sample.point, evidence_.light);
        });
    }

private:
    [[nodiscard]] std::uint32_t objectOf(std::size_t primitive) const { return evidence_.tracer.world().objects[primitive]; }
    [[nodiscard]] std::vector<std::uint8_t> castersWhere(const std::function<bool(std::size_t primitive)>& stays) const {
        std::vector<std::uint8_t> flags = casts_;
        for (std::size_t i = 0; i < flags.size(); ++i)
            if (!stays(i)) flags[i] = 0;
        return flags;
    }
    /// The objects of the triangles that `primitiveOf` names for most samples; kNoPrimitive: none.
    [[nodiscard]] std::vector<std::uint32_t> heaviest(std::size_t most, const std::function<std::uint32_t(const Sample&)>& primitiveOf) const {
        std::map<std::uint32_t, double> weights;
        for (const Sample& sample : evidence_.samples)
            if (const std::uint32_t primitive = primitiveOf(sample); primitive != trace::kNoPrimitive) weights[objectOf(primitive)] += sample.weight;
        std::vector<std::uint32_t> objects;
        for (const auto& [object, weight] : weights)
            objects.push_back(object);
        std::ranges::stable_sort(objects, std::greater{}, [&](std::uint32_t object) { return weights.at(object); });
        if (objects.size() > most) objects.resize(most);
        return objects;
    }
    [[nodiscard]] bool faces(const Rules& rules, const trace::SurfacePoint& point) const {
        const scene::Light& light = evidence_.source();
        if (!scene::shinesEverywhere(light) && !scene::lightShinesTo(light, evidence_.tracer.positionWorld(point))) return false;
        const int side = ofLight_[point.primitive];
        const bool own = rules.gateOfObject < 0 || rules.gateOfObject == evidence_.tracer.world().objects[point.primitive];
        switch (own ? rules.gate : Gate::viewer) {
        case Gate::viewer: return point.eyeOnFront ? side > 0 : side < 0;
        case Gate::none: return true;
        case Gate::winding: return side > 0;
        case Gate::inverted: return side < 0;
        }
        return true;
    }

    const Evidence& evidence_;
    std::vector<std::int8_t> ofLight_; ///< of each triangle, which side it turns to the light
    std::vector<std::uint8_t> casts_;
};

struct Tried {
    const char* id;
    const char* what; ///< before its share
    const char* remedy;
    Rules rules;
    double likelihood = 1;
};

void tryOut(const Evidence& evidence, const Sides& sides, Tried tried, const std::string& name, std::vector<Cause>& causes) {
    Cause cause{tried.id, "", tried.remedy, sides.predictions(tried.rules)};
    cause.likelihood = tried.likelihood;
    cause.what = tried.what + name + ": this explains " + percentText(explained(evidence, cause.predictions)) + " of the wrong pixels";
    addIfExplains(evidence, std::move(cause), causes);
}

void addForAll(const Evidence& evidence, const Sides& sides, std::vector<Cause>& causes) {
    constexpr const char* kDrawBoth = "draw both sides into shadow map and picture (no culling), and let every triangle block light from both sides";
    constexpr const char* kTurn = "order the corners counter-clockwise as seen from outside, or exchange front and back (glFrontFace, side), and draw both sides";
    const std::vector<std::uint8_t>& all = sides.allCast();
    const std::vector<std::uint8_t> fronts = sides.castersWithSide(1), backs = sides.castersWithSide(-1);
    const std::vector<std::uint8_t> seenFronts = sides.seenWithSide(1), seenBacks = sides.seenWithSide(-1);
    for (const Tried& tried : {
             Tried{"back-faces-missing", "triangles that turn their back to the light cast no shadow", kDrawBoth, {fronts, {}}},
             Tried{"back-faces-missing", "back faces are missing in the picture", kDrawBoth, {all, seenFronts}},
             Tried{"back-faces-missing", "back faces are missing in the picture and cast no shadow", kDrawBoth, {fronts, seenFronts}},
             Tried{"back-faces-missing", "surfaces that show their back are never lit", "turn normals to the viewer where the back is seen", {all, {}, Gate::winding}},
             Tried{"back-faces-missing", "surfaces that show their back are never lit, and triangles that turn it to the light cast no shadow", kDrawBoth, {fronts, {}, Gate::winding}},
             Tried{"wrong-winding", "windings are reversed: triangles that turn their front to the light cast no shadow", kTurn, {backs, {}}, 0.98},
             Tried{"wrong-winding", "windings are reversed: front faces are missing in the picture", kTurn, {all, seenBacks}},
             Tried{"wrong-winding", "windings are reversed: front faces are missing in the picture and cast no shadow", kTurn, {backs, seenBacks}},
             Tried{"wrong-winding", "windings are reversed: surfaces are lit on their back alone", kTurn, {all, {}, Gate::inverted}},
             Tried{"wrong-winding", "windings are reversed: surfaces are lit on their back alone, and fronts cast no shadow", kTurn, {backs, {}, Gate::inverted}},
             Tried{"wrong-winding", "windings are reversed: front faces are missing in the picture, and surfaces are lit on their back alone", kTurn, {all, seenBacks, Gate::inverted}},
             Tried{"no-facing-test", "surfaces that are turned away from the light are lit where nothing else shades them", "surfaces with N.L <= 0 get no light", {all, {}, Gate::none}},
         })
        tryOut(evidence, sides, tried, "", causes);
}

void addForObjects(const Evidence& evidence, const Sides& sides, std::vector<Cause>& causes) {
    const scene::Scene& scene = evidence.tracer.scene();
    for (const std::uint32_t object : sides.suspects(true))
        tryOut(evidence, sides, {"caster-missing", "a caster is missing, ", "draw this object into the shadow map or count its volume; where windings decide, its own may be reversed", {sides.castersWithout(object), {}}, 0.95}, // a rule of sides that explains as much needs no single object
               "'" + scene.objects[object].name + "'", causes);
    for (const std::uint32_t object : sides.castersSeen())
        tryOut(evidence, sides, {"caster-missing", "only one object casts a shadow, ", "draw all objects into the shadow map, or count the volumes of all", {sides.castersOf(object), {}}},
               "'" + scene.objects[object].name + "'", causes);
    for (const std::uint32_t object : sides.suspects(false))
        tryOut(evidence, sides, {"wrong-winding", "one object has its winding reversed, ", "order its corners counter-clockwise as seen from outside",
                                 {sides.allCast(), {}, Gate::inverted, object}},
               "'" + scene.objects[object].name + "'", causes);
}

} // namespace

void addWindingCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const Sides sides(evidence);
    addForAll(evidence, sides, causes);
    addForObjects(evidence, sides, causes);
}

} // namespace shadowlab::foreign
