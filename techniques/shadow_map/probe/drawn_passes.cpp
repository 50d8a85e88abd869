// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/shadow_map/probe/probe.h"

namespace shadowlab::shadow_map {

std::vector<Probe::DrawnPass> drawnPasses(const ProbedMap& of, const scene::Scene& scene, const View& view) {
    if (of.rays) return {};
    for (const scene::Light& light : scene.lights)
        if (of.averagesOver(light)) return {};
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    const auto triangles = [&](std::size_t object) {
        return static_cast<std::uint64_t>(scene.objects[object].mesh->triangles.size());
    };
    const auto isSeen = [&](std::size_t object) {
        return !of.params.cull || scene::mayTouch(of.fitter.bounds()[object], clipFromWorld, scene::PicturePart{});
    };
    std::uint64_t seen = 0;
    for (std::size_t object = 0; object < scene.objects.size(); ++object)
        if (isSeen(object)) seen += triangles(object);

    std::vector<Probe::DrawnPass> passes{{"lights-off", kNoLight, seen, "from the eye"}};
    const std::vector<scene::Bounds> receivers = of.fitter.receiversInView(scene, view);
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const MapQuery query = of.fitter.query(scene, light);
        const LightMaps maps = of.fitter.fit(scene, view, query, receivers);
        std::uint64_t drawn = 0;
        for (int layer = 0; layer < maps.layers(); ++layer)
            for (const std::size_t caster : of.fitter.castersOf(scene, maps, query, layer))
                drawn += triangles(caster);
        passes.push_back(
            {"depth", light, drawn,
             maps.layers() == 1 ? "from the light" : "from the light, " + std::to_string(maps.layers()) + " maps"});
        // As Receivers::drawWhereNeeded() does: an object is drawn where the map may shadow it, and again where it certainly does not.
        const bool splits = of.params.cull && maps.layers() > 0 && of.params.border == ShadowMapParams::Border::lit &&
                            of.params.rejectBehind;
        std::uint64_t lit = 0;
        for (std::size_t object = 0; object < scene.objects.size(); ++object) {
            if (!isSeen(object)) continue;
            const ReceiverLookup how =
                splits ? receiverLookup(maps, of.fitter.bounds()[object], clipFromWorld) : ReceiverLookup{};
            lit += triangles(object) * (static_cast<std::uint64_t>(how.looksUp) + static_cast<std::uint64_t>(how.rest));
        }
        passes.push_back({"light", light, lit, "from the eye, with the map"});
    }
    return passes;
}

} // namespace shadowlab::shadow_map
