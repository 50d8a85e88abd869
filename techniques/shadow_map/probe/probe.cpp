// What the shadow map knows of one pixel: the way from the point to its texel, what the texel holds, and the comparison.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "techniques/exact_judge.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/probe_decision.h"
#include "techniques/shadow_map/exact/exact_probe.h"
#include "techniques/shadow_map/filters/filter_tell.h"
#include "techniques/shadow_map/fit/near_plane.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

template <typename Vector>
Probe::Fact vectorFact(const char* label, const Vector& v, const char* unit = "") {
    Probe::Fact fact{label, "(", unit};
    for (int i = 0; i < v.length(); ++i) {
        fact.value += (i ? ", " : "") + probeText(v[i]);
        fact.numbers.push_back(v[i]);
    }
    fact.value += ")";
    return fact;
}

/// Row by row, as it is written on a board.
Probe::Fact matrixFact(const char* label, const dmat4& m) {
    Probe::Fact fact{label, "", ""};
    for (int r = 0; r < 4; ++r) {
        const Probe::Fact row = vectorFact("", dvec4(m[0][r], m[1][r], m[2][r], m[3][r]));
        fact.value += (r ? "; " : "") + row.value;
        fact.numbers.insert(fact.numbers.end(), row.numbers.begin(), row.numbers.end());
    }
    return fact;
}

/// "cascade 2 of 3", "face -x"
std::string layerName(const LightMaps& maps, int layer) {
    static constexpr const char* faces[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    if (maps.layout == Layout::cube) return std::string("face ") + faces[layer];
    const std::string number = std::to_string(layer + 1) + " of " + std::to_string(maps.layers());
    return maps.layout == Layout::cascades ? "cascade " + number : number;
}

std::array<dvec3, 3> cornersOfHit(const scene::Scene& scene, const trace::EyeHit& hit) {
    const scene::Object& object = scene.objects[hit.object];
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    std::array<dvec3, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = transformPoint(
            worldFromMesh,
            dvec3(object.mesh->positionsMesh[object.mesh->triangles[hit.triangle][static_cast<int>(i)]]));
    return corners;
}

/// Why a comparison came out wrong, as far as its numbers prove it.
std::string whyWrong(const MapProbe& map, const TexelDepth& texel, const trace::EyeHit& hit, bool isLit,
                     const std::string& blocker) {
    const double biasMetres = map.pointMetres - map.comparedMetres + map.storedMetres - map.firstMetres;
    if (!isLit && !texel.isEmpty() && texel.object == hit.object && texel.triangle == hit.triangle)
        return "acne: the texel holds the depth of this very triangle at its centre, " +
               probeText(map.pointMetres - map.firstMetres) + " m nearer to the light than the point; the bias is " +
               probeText(biasMetres) + " m";
    if (!isLit && texel.isEmpty())
        return "aliasing: other texels of the filter hold something nearer; that of the point does not";
    if (!isLit && texel.object == hit.object && map.pointMetres - map.firstMetres < 2 * map.texelMetres)
        return "acne: the texel holds the depth of a neighbouring triangle of " + blocker + ", " +
               probeText(map.pointMetres - map.firstMetres) + " m nearer to the light than the point; the bias is " +
               probeText(biasMetres) + " m";
    if (!isLit)
        return "aliasing: at the texel's centre " + blocker + " is in the way, at the point it is not; a texel is " +
               probeText(map.texelMetres) + " m wide";
    if (texel.isEmpty() || map.first >= map.str.z)
        return "aliasing: at the texel's centre nothing is in the way, at the point there is; a texel is " +
               probeText(map.texelMetres) + " m wide";
    if (map.compared <= map.stored)
        return "peter-panning: " + blocker + " is " + probeText(map.pointMetres - map.firstMetres) +
               " m before the point, and the bias is " + probeText(biasMetres) + " m";
    return "aliasing: most texels of the filter hold nothing nearer, though that of the point does";
}

/// The same of filters that do not compare texel by texel: what each takes for granted.
std::string whyWrongFiltered(const MapProbe& map, bool isLit) {
    if (map.search && map.search->found == 0) return "the search found no blocker where it looked";
    if (map.search)
        return "all blockers are taken for one surface at their mean distance of " +
               probeText(map.search->blockerMetres) + " m, parallel to the light";
    const std::string share = probeText(map.moments->unreduced);
    return isLit ? "light bleeding: the moments of the depths around allow that as much as " + share +
                       " of them are not before the point"
                 : "aliasing: of the depths around at most " + share + " are not before the point";
}

/// As shaders/shadow_map/layer_cascades.glsl has it.
double fadeToNext(const LightMaps& maps, int layer, double eyeDepth) {
    if (maps.layout != Layout::cascades || layer + 1 >= maps.layers()) return 0;
    const auto i = static_cast<std::size_t>(layer);
    const double width = std::max(maps.cascadeEnds[i] - maps.fadeStarts[i], 1e-9);
    return glm::clamp((eyeDepth - maps.fadeStarts[i]) / width, 0.0, 1.0);
}

/// What the point sees of a light with an area, 0..1.
double seenShare(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    trace::SceneTracer tracer;
    tracer.advance(snapshot, Deadline::max());
    const trace::SurfacePoint point = tracer.eyePoint(tracer.eyeRays(view.camera, view.size), dvec2(pixel) + 0.5);
    return trace::AreaVisibility(tracer, light).share(point);
}

/// The part of the light's view that the texel sees, its image on the point's surface, and the light's ray through its centre.
std::vector<SceneShape> texelShapes(const MapProbe& map, const LightMaps& maps) {
    std::vector<SceneShape> shapes;
    if (map.texelIsOnReceiver) {
        SceneShape texel{"the texel on the surface", look::kLightFrustum, SceneShape::Kind::faces, {}};
        SceneShape rim{"the texel on the surface", look::kLightFrustum, SceneShape::Kind::lines, {}};
        const auto& c = map.texelOnReceiverWorld;
        texel.pointsWorld = {c[0], c[1], c[2], c[0], c[2], c[3]};
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec3 from = maps.parallel ? c[i] + maps.towardLight * map.pointMetres : maps.originWorld;
            rim.pointsWorld.insert(rim.pointsWorld.end(), {c[i], c[(i + 1) % 4], from, c[i]});
        }
        shapes.push_back(std::move(texel));
        shapes.push_back(std::move(rim));
    }
    if (map.blockerWorld) {
        const dvec3 from = maps.parallel ? *map.blockerWorld + maps.towardLight * map.pointMetres : maps.originWorld;
        shapes.push_back({"the light's ray to what the texel holds",
                          look::kOccluded,
                          SceneShape::Kind::lines,
                          {from, *map.blockerWorld}});
    }
    return shapes;
}

} // namespace

Probe ShadowMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto hit = exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit || light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    probe.passes = drawnPasses(*snapshot, view);
    const LightMaps maps =
        fit(*snapshot, view, asked(*snapshot, light), receiversInView(*snapshot, view), FitRequest::Cover::needed);
    const dvec3 pointLightRelative = hit->positionWorld - maps.originWorld;
    const double eyeDepth = -transformPoint(scene::viewFromWorld(view.camera), hit->positionWorld).z;
    const std::optional<int> layer = layerOf(maps, pointLightRelative, eyeDepth);
    const auto add = [&](const char* label, std::string value, const char* unit = "") {
        probe.facts.push_back({label, std::move(value), unit});
    };
    const auto truthOf = [&] { return exactJudge(snapshot)->visibility(*hit, view.camera, light); };
    const auto decideByTriangles = [&](const ExactDecision& own) {
        add("who decides", own.who);
        addDecision(probe, own.visibility == trace::Visibility::lit ? 1 : 0, truthOf(),
                    "the technique's own rays disagree with the judge's");
        if (own.blocker) {
            add("blocked by", "triangle " + std::to_string(own.blocker->triangle) + " of " + own.blocker->object);
            const auto& c = own.blocker->cornersWorld;
            probe.visited.push_back(
                {"the face that blocks the light", look::kOccluded, SceneShape::Kind::faces, {c[0], c[1], c[2]}});
        }
        probe.decision->blocker = own.blocker;
    };
    const auto decideLit = [&] {
        if (params_.aliasFree)
            decideByTriangles(decideAliasFree(aliasFree_.tracer(), view, pixel, light));
        else
            addDecision(probe, truthOf() == trace::Visibility::turnedAway ? 0 : 1, truthOf(), "no map is asked there");
    };
    const bool isAveraged = averagesOver(snapshot->light(light));
    if (!layer) {
        add("map", "none: nothing in view can be in this light's shadow");
        decideLit();
        return probe;
    }
    add("map", layerName(maps, *layer));
    // The chain of matrices, from the world to (s, t, r).
    const auto index = static_cast<std::size_t>(*layer);
    const auto addVector = [&](const char* label, const auto& vector, const char* unit = "") {
        probe.facts.push_back(vectorFact(label, vector, unit));
    };
    addVector("point in the world", hit->positionWorld, "m");
    addVector("lightRelativeFromWorld: less the light's origin", maps.originWorld, "m");
    addVector("point, light-relative", pointLightRelative, "m");
    probe.facts.push_back(matrixFact("lightViewFromLightRelative", maps.lightViewFromLightRelative[index]));
    addVector("point in the light's view", transformPoint(maps.lightViewFromLightRelative[index], pointLightRelative),
              "m");
    probe.facts.push_back(matrixFact("lightClipFromLightView", maps.lightClipFromLightView[index]));
    const dvec4 clip = maps.lightClipFromLightRelative(*layer) * dvec4(pointLightRelative, 1.0);
    addVector("point in the light's clip space", clip);
    if (clip.w <= 0) {
        add("(s, t, r)", "none: behind the light's camera, where the projection would mirror it");
        if (params_.rejectBehind) decideLit();
        return probe;
    }
    const dvec3 str = dvec3(clip) / clip.w * 0.5 + 0.5;
    addVector("(s, t, r) = clip / w / 2 + 1/2", str);
    if (glm::any(glm::lessThan(dvec2(str), dvec2(0))) || glm::any(glm::greaterThanEqual(dvec2(str), dvec2(1))))
        add("place", params_.border == ShadowMapParams::Border::lit ? "outside the map, so lit"
                                                                    : "outside the map: its outermost texels go on");
    const AskedLight asked = this->asked(*snapshot, light);
    const TexelDepths depths({*snapshot, maps, *layer, castersOf(*snapshot, maps, asked, *layer), bounds_, params_,
                              depthRules(params_, asked.filter)});
    dvec3 pointWorld = hit->positionWorld;
    if (params_.looksUpInWorld()) // as point_world.glsl has it
        pointWorld = maps.originWorld + dvec3(vec3(pointWorld)) - dvec3(vec3(maps.originWorld));
    const ComparedPoint point{*snapshot,
                              maps,
                              *layer,
                              params_,
                              asked.filter,
                              depths,
                              asked.light,
                              pointWorld,
                              cornersOfHit(*snapshot, *hit),
                              {pixel.x, view.size.y - 1 - pixel.y},
                              leastReference(maps, bounds_[hit->object])};
    probe.map = probeMap(point);
    MapProbe& map = *probe.map;
    map.layerName = layerName(maps, *layer);
    const TexelDepth texel = depths.at(map.texel);
    const std::string blocker = texel.isEmpty() ? "" : snapshot->objects[texel.object].name;
    probe.facts.push_back({"texel (column, row)",
                           std::to_string(map.texel.x) + ", " + std::to_string(map.texel.y),
                           "",
                           {static_cast<double>(map.texel.x), static_cast<double>(map.texel.y)}});
    probe.facts.push_back(probeFact("width of a texel at the point", map.texelMetres, "m"));
    probe.facts.push_back({"d(u,v): depth at the texel's centre, before any bias",
                           texel.isEmpty() ? "1 (nothing there)" : probeText(map.first),
                           "",
                           {texel.isEmpty() ? 1.0 : map.first}});
    if (!texel.isEmpty()) add("of", blocker + ", triangle " + std::to_string(texel.triangle));
    probe.facts.push_back({"d(u,v) as it is compared",
                           texel.isEmpty()
                               ? "1 (nothing there)"
                               : probeText(map.stored) + (map.stored != map.first ? ", pushed back by its slope" : ""),
                           "",
                           {texel.isEmpty() ? 1.0 : map.stored}});
    probe.facts.push_back(probeFact("z(u,v): depth of the point itself", map.str.z));
    probe.facts.push_back(probeFact("z(u,v) as it is compared, the bias taken off", map.compared));
    if (!texel.isEmpty()) probe.facts.push_back(probeFact("d(u,v) in metres", map.firstMetres, "m"));
    if (map.stored != map.first)
        probe.facts.push_back(probeFact("d(u,v) as it is stored in metres", map.storedMetres, "m"));
    probe.facts.push_back(probeFact("z(u,v) in metres", map.pointMetres, "m"));
    probe.facts.push_back(probeFact("bias of the point in metres", map.pointMetres - map.comparedMetres, "m"));
    add("if d(u,v) < z(u,v) then pixel is shadowed",
        texel.isEmpty()             ? "no: nothing is in the way"
        : map.stored < map.compared ? "yes, by " + probeText(map.compared - map.stored) + " of the map's range"
                                    : "no: d is not less, by " + probeText(map.stored - map.compared));
    if (probe.section) addCells(map, point, *probe.section);
    for (SceneShape& shape : texelShapes(map, maps))
        probe.visited.push_back(std::move(shape));

    const auto truth = truthOf();
    const bool gate = truth != trace::Visibility::turnedAway;
    const auto decide = [&](double visibility, const std::string& why, trace::Visibility truth) {
        const bool receives = snapshot->objects[hit->object].receivesShadow;
        addDecision(probe, !gate ? 0 : receives ? visibility : 1, truth, why);
    };
    if (params_.aliasFree) {
        decideByTriangles(decideAliasFree(aliasFree_.tracer(), view, pixel, light));
        return probe;
    }
    if (params_.exact) {
        decideByTriangles(decideExactly(exact_.tracer(), view, pixel, light, texel));
        return probe;
    }
    if (isAveraged) {
        add("who decides", "the mean of maps from many points of the light; this is the one of its centre");
        return probe;
    }
    const FilterAnswer answer = answerOf(point);
    map.taps = answer.taps;
    map.search = answer.search;
    map.moments = answer.moments;
    tellFilter(probe, answer);
    if (asked.filter.usesMoments() && asked.filter.mipmaps && !averagesLogarithms(asked.filter)) {
        add("who decides", "coarser moments, over as many texels as the pixel covers; told are the finest");
        return probe;
    }
    if (map.moments && !map.moments->isFinite) {
        add("who decides", "numbers that the format does not hold: what a graphics card makes of them is its own");
        return probe;
    }
    double visibility = answer.visibility;
    if (const double fade = fadeToNext(maps, *layer, eyeDepth); fade > 0) {
        const TexelDepths nextDepths({*snapshot, maps, *layer + 1, castersOf(*snapshot, maps, asked, *layer + 1),
                                      bounds_, params_, depthRules(params_, asked.filter)});
        const ComparedPoint next{*snapshot,          maps,           *layer + 1,          params_,
                                 asked.filter,       nextDepths,     asked.light,         point.pointWorld,
                                 point.cornersWorld, point.fragment, point.leastReference};
        add("share of the next cascade in the answer", probeText(fade));
        visibility = glm::mix(visibility, answerOf(next).visibility, fade);
    }
    const bool isLit = visibility > 0.5;
    const std::string why =
        map.search || map.moments ? whyWrongFiltered(map, isLit) : whyWrong(map, texel, *hit, isLit, blocker);
    if (samplesArea(*snapshot, light) && gate) {
        const double seen = seenShare(snapshot, view, pixel, light);
        probe.facts.push_back(probeFact("truth: share of the light that is seen", seen));
        decide(visibility, why, seen > 0.5 ? trace::Visibility::lit : trace::Visibility::shadowed);
    } else {
        decide(visibility, why, truth);
    }
    tellTaps(probe, answer);
    for (SceneShape& shape : tapShapes(answer, map.texelMetres))
        probe.visited.push_back(std::move(shape));
    return probe;
}

} // namespace shadowlab::shadow_map
