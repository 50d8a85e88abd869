// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/probe/probe.h"

#include <algorithm>
#include <optional>

#include "techniques/exact_judge.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/probe_decision.h"
#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/probe/filter_facts.h"
#include "techniques/shadow_map/probe/triangle_decision.h"

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

/// As shaders/shadow_map/layers/layer_cascades.glsl has it.
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
        SceneShape texel{"the texel on the surface", look::kMapTexel, SceneShape::Kind::faces, {}};
        SceneShape rim{"the texel on the surface", look::kMapTexel, SceneShape::Kind::lines, {}};
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
        shapes.push_back({"to what the texel holds",
                          look::kOccluded,
                          SceneShape::Kind::lines,
                          {from, *map.blockerWorld}});
    }
    return shapes;
}

/// The probe of one pixel for one light: its steps, in the order of the facts that they add.
class PixelProbe {
public:
    PixelProbe(Probe& probe, const ProbedMap& of, const scene::Snapshot& snapshot, const View& view, ivec2 pixel,
               int light, const trace::EyeHit& hit)
        : probe_(probe), of_(of), snapshot_(snapshot), view_(view), pixel_(pixel), light_(light), hit_(hit),
          query_(of.fitter.query(*snapshot, light)), maps_(of.fitter.fitToView(*snapshot, view, query_)),
          eyeDepth_(-transformPoint(scene::viewFromWorld(view.camera), hit.positionWorld).z),
          truth_(exactJudge(snapshot)->visibility(hit, view.camera, light)) {}

    void tell() {
        const std::optional<int> layer = layerOf(maps_, hit_.positionWorld - maps_.originWorld, eyeDepth_);
        if (!layer) {
            add("map", "none: nothing in view can be in this light's shadow");
            decideWithoutMap();
            return;
        }
        layer_ = *layer;
        if (!tellPlaceInMap()) return;
        const TexelDepths depths = depthsOf(layer_);
        const ComparedPoint point = comparedPoint(layer_, depths);
        const std::optional<MapProbe> lookup = probeMap(point);
        if (!lookup) return; // behind the light's camera: tellPlaceInMap() has said so
        MapProbe& map = probe_.add(*lookup);
        map.layerName = layerName(maps_, layer_);
        const TexelDepth texel = depths.at(map.texel);
        tellTexel(texel);
        if (probe_.section) addCells(map, point, *probe_.section);
        for (SceneShape& shape : texelShapes(map, maps_))
            probe_.visited.push_back(std::move(shape));
        if (of_.rays)
            addTriangleDecision(probe_, decideExactly(*of_.rays, view_, pixel_, light_, texel), truth_);
        else if (of_.averagesOver(snapshot_->light(light_)))
            addDecider(probe_, "the mean of maps from many points of the light; this is the one of its centre");
        else
            decideByFilter(point, texel);
    }

private:
    void add(const char* label, std::string value, const char* unit = "") {
        probe_.facts.push_back({label, std::move(value), unit});
    }
    template <typename Vector>
    void addVector(const char* label, const Vector& vector, const char* unit = "") {
        probe_.facts.push_back(vectorFact(label, vector, unit));
    }

    /// The chain of matrices, from the world to (s, t, r). False where the projection has no place for the point.
    bool tellPlaceInMap() {
        add("map", layerName(maps_, layer_));
        const auto index = static_cast<std::size_t>(layer_);
        const dvec3 pointLightRelative = hit_.positionWorld - maps_.originWorld;
        addVector("point in the world", hit_.positionWorld, "m");
        addVector("lightRelativeFromWorld: less the light's origin", maps_.originWorld, "m");
        addVector("point, light-relative", pointLightRelative, "m");
        probe_.facts.push_back(matrixFact("lightViewFromLightRelative", maps_.lightViewFromLightRelative[index]));
        addVector("point in the light's view",
                  transformPoint(maps_.lightViewFromLightRelative[index], pointLightRelative), "m");
        probe_.facts.push_back(matrixFact("lightClipFromLightView", maps_.lightClipFromLightView[index]));
        const dvec4 clip = maps_.lightClipFromLightRelative(layer_) * dvec4(pointLightRelative, 1.0);
        addVector("point in the light's clip space", clip);
        if (clip.w <= 0) {
            add("(s, t, r)", "none: behind the light's camera, where the projection would mirror it");
            if (of_.params.rejectBehind) decideWithoutMap();
            return false;
        }
        const dvec3 str = dvec3(clip) / clip.w * 0.5 + 0.5;
        addVector("(s, t, r) = clip / w / 2 + 1/2", str);
        if (glm::any(glm::lessThan(dvec2(str), dvec2(0))) || glm::any(glm::greaterThanEqual(dvec2(str), dvec2(1))))
            add("place", of_.params.border == ShadowMapParams::Border::lit
                             ? "outside the map, so lit"
                             : "outside the map: its outermost texels go on");
        return true;
    }

    [[nodiscard]] TexelDepths depthsOf(int layer) const {
        return TexelDepths(
            {*snapshot_, maps_, layer, of_.fitter.castersOf(*snapshot_, maps_, query_, layer), of_.fitter.bounds(),
             of_.params, of_.rays ? DepthRules{} : depthRules(of_.params, query_.filter)}); // the exact map has no bias
    }

    [[nodiscard]] ComparedPoint comparedPoint(int layer, const TexelDepths& depths) const {
        dvec3 pointWorld = hit_.positionWorld;
        if (of_.params.looksUpInWorld()) // as point_world.glsl has it
            pointWorld = maps_.originWorld + dvec3(vec3(pointWorld)) - dvec3(vec3(maps_.originWorld));
        return {*snapshot_,
                maps_,
                layer,
                of_.params,
                query_.filter,
                depths,
                query_.light,
                pointWorld,
                cornersOfHit(*snapshot_, hit_),
                {pixel_.x, view_.size.y - 1 - pixel_.y},
                minReferenceDepth(maps_, of_.fitter.bounds()[hit_.object])};
    }

    /// What the texel holds, what the point compares with it, and how that ends.
    void tellTexel(const TexelDepth& texel) {
        const MapProbe& map = *probe_.find<MapProbe>();
        const std::string blocker = nameOf(texel);
        probe_.facts.push_back({"texel (column, row)",
                                std::to_string(map.texel.x) + ", " + std::to_string(map.texel.y),
                                "",
                                {static_cast<double>(map.texel.x), static_cast<double>(map.texel.y)}});
        probe_.facts.push_back(probeFact("width of a texel at the point", map.texelMetres, "m"));
        probe_.facts.push_back({"d(u,v): depth at the texel's centre, before any bias",
                                texel.isEmpty() ? "1 (nothing there)" : probeText(map.first),
                                "",
                                {texel.isEmpty() ? 1.0 : map.first}});
        if (!texel.isEmpty()) add("of", blocker + ", triangle " + std::to_string(texel.triangle));
        probe_.facts.push_back(
            {"d(u,v) as it is compared",
             texel.isEmpty() ? "1 (nothing there)"
                             : probeText(map.stored) + (map.stored != map.first ? ", pushed back by its slope" : ""),
             "",
             {texel.isEmpty() ? 1.0 : map.stored}});
        probe_.facts.push_back(probeFact("z(u,v): depth of the point itself", map.str.z));
        probe_.facts.push_back(probeFact("z(u,v) as it is compared, the bias taken off", map.compared));
        if (!texel.isEmpty()) probe_.facts.push_back(probeFact("d(u,v) in metres", map.firstMetres, "m"));
        if (map.stored != map.first)
            probe_.facts.push_back(probeFact("d(u,v) as it is stored in metres", map.storedMetres, "m"));
        probe_.facts.push_back(probeFact("z(u,v) in metres", map.pointMetres, "m"));
        probe_.facts.push_back(probeFact("bias of the point in metres", map.pointMetres - map.comparedMetres, "m"));
        add("if d(u,v) < z(u,v) then pixel is shadowed",
            texel.isEmpty()             ? "no: nothing is in the way"
            : map.stored < map.compared ? "yes, by " + probeText(map.compared - map.stored) + " of the map's range"
                                        : "no: d is not less, by " + probeText(map.stored - map.compared));
    }

    [[nodiscard]] std::string nameOf(const TexelDepth& texel) const {
        return texel.isEmpty() ? "" : snapshot_->objects[texel.object].name;
    }

    void decideWithoutMap() {
        addDecision(probe_, truth_ == trace::Visibility::turnedAway ? 0 : 1, truth_, "no map is asked there");
    }

    void decideByFilter(const ComparedPoint& point, const TexelDepth& texel) {
        const FilterInfo& filter = filterInfo(query_.filter.kind);
        if (!filter.answer) {
            addDecider(probe_, "filter " + std::string(filter.name) + ", which the probe cannot follow");
            return;
        }
        const FilterAnswer answer = filter.answer(point);
        MapProbe& map = *probe_.find<MapProbe>();
        map.taps = answer.taps;
        map.search = answer.search;
        map.moments = answer.moments;
        tellFilter(probe_, answer);
        if (query_.filter.usesMoments() && query_.filter.mipmaps && !averagesLogarithms(query_.filter)) {
            addDecider(probe_, "coarser moments, over as many texels as the pixel covers; told are the finest");
            return;
        }
        if (map.moments && !map.moments->isFinite) {
            addDecider(probe_, "numbers that the format does not hold: what a graphics card makes of them is its own");
            return;
        }
        const double visibility = fadedIntoNextCascade(answer.visibility, filter);
        const bool isLit = visibility > 0.5;
        const std::string why =
            map.search || map.moments ? whyWrongFiltered(map, isLit) : whyWrong(map, texel, hit_, isLit, nameOf(texel));
        const bool facesLight = truth_ != trace::Visibility::turnedAway;
        const bool receives = snapshot_->objects[hit_.object].receivesShadow;
        const double decided = !facesLight ? 0 : receives ? visibility : 1;
        if (of_.samplesArea && facesLight) {
            const double seen = seenShare(snapshot_, view_, pixel_, light_);
            probe_.facts.push_back(probeFact("truth: share of the light that is seen", seen));
            addDecision(probe_, decided, seen > 0.5 ? trace::Visibility::lit : trace::Visibility::shadowed, why);
        } else {
            addDecision(probe_, decided, truth_, why);
        }
        tellTaps(probe_, answer);
        for (SceneShape& shape : tapShapes(answer, map.texelMetres))
            probe_.visited.push_back(std::move(shape));
    }

    double fadedIntoNextCascade(double visibility, const FilterInfo& filter) {
        const double fade = fadeToNext(maps_, layer_, eyeDepth_);
        if (!(fade > 0)) return visibility;
        add("share of the next cascade in the answer", probeText(fade));
        const TexelDepths depths = depthsOf(layer_ + 1);
        return glm::mix(visibility, filter.answer(comparedPoint(layer_ + 1, depths)).visibility, fade);
    }

    Probe& probe_;
    const ProbedMap& of_;
    const scene::Snapshot& snapshot_;
    const View& view_;
    ivec2 pixel_;
    int light_;
    const trace::EyeHit& hit_;
    MapQuery query_;
    LightMaps maps_;
    double eyeDepth_; ///< metres along the eye's axis
    trace::Visibility truth_;
    int layer_ = 0;
};

} // namespace

void probeShadowMap(Probe& probe, const ProbedMap& of, const scene::Snapshot& snapshot, const View& view, ivec2 pixel,
                    int light) {
    const auto hit = exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit) return;
    probe.passes = drawnPasses(of, *snapshot, view);
    PixelProbe(probe, of, snapshot, view, pixel, light, *hit).tell();
}

} // namespace shadowlab::shadow_map
