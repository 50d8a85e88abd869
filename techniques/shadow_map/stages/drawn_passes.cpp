// How many polygons the passes of a frame draw: "every polygon is rendered N + 1 times".
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

/// Of a frame in which all maps are drawn anew. Only of maps from one point of each light, and without rays.
std::vector<Probe::DrawnPass> ShadowMap::drawnPasses(const scene::Scene& scene, const View& view) const {
    if (params_.aliasFree || params_.exact) return {};
    for (const scene::Light& light : scene.lights)
        if (averagesOver(light)) return {};
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    const auto triangles = [&](std::size_t object) {
        return static_cast<std::uint64_t>(scene.objects[object].mesh->triangles.size());
    };
    const auto isSeen = [&](std::size_t object) {
        return !params_.cull || scene::mayTouch(bounds_[object], clipFromWorld, scene::PicturePart{});
    };
    std::uint64_t seen = 0;
    for (std::size_t object = 0; object < scene.objects.size(); ++object)
        if (isSeen(object)) seen += triangles(object);

    std::vector<Probe::DrawnPass> passes{{"lights-off", kNoLight, seen, "from the eye"}};
    const std::vector<scene::Bounds> receivers = receiversInView(scene, view);
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const AskedLight asked = this->asked(scene, light);
        const LightMaps maps = fit(scene, view, asked, receivers, FitRequest::Cover::needed);
        std::uint64_t drawn = 0;
        for (int layer = 0; layer < maps.layers(); ++layer)
            for (const std::size_t caster : castersOf(scene, maps, asked, layer))
                drawn += triangles(caster);
        passes.push_back(
            {"depth", light, drawn,
             maps.layers() == 1 ? "from the light" : "from the light, " + std::to_string(maps.layers()) + " maps"});
        // As in drawAsked(): what the map may shadow, and what it certainly does not, of an object one after the other.
        const bool splits =
            params_.cull && maps.layers() > 0 && params_.border == ShadowMapParams::Border::lit && params_.rejectBehind;
        std::uint64_t lit = 0;
        for (std::size_t object = 0; object < scene.objects.size(); ++object) {
            if (!isSeen(object)) continue;
            const Asking how = splits ? askingOf(maps, bounds_[object], clipFromWorld) : Asking{};
            lit += triangles(object) * (static_cast<std::uint64_t>(how.asks) + static_cast<std::uint64_t>(how.rest));
        }
        passes.push_back({"light", light, lit, "from the eye, with the map"});
    }
    return passes;
}

} // namespace shadowlab::shadow_map
