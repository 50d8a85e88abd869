// SPDX-License-Identifier: MIT
#include "app/foreign/expected_light.h"

#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/shading_normals.h"

namespace shadowlab::foreign {

dvec3 flatNormalWorld(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const trace::Triangle& triangle = tracer.world().triangles[point.primitive];
    const dvec3 normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
    return point.eyeOnFront ? normal : -normal;
}

ExpectedLight expectedLight(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light) {
    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    const trace::ShadingNormals normals(tracer);
    const scene::Scene& scene = tracer.scene();
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const std::vector<vec3> none(pixels, vec3(0.0f));
    ExpectedLight expected{none, none, none, std::vector<std::uint8_t>(pixels, 0), none};
    trace::parallelFor(static_cast<std::size_t>(size.y), [&](std::size_t row) {
        for (int x = 0; x < size.x; ++x) {
            const trace::SurfacePoint point = tracer.eyePoint(rays, dvec2(x, row) + 0.5);
            if (!point) continue;
            const scene::Object& object = tracer.objectOf(point);
            const std::uint32_t triangle = tracer.world().triangleInMesh(point.primitive);
            const scene::Material& material = scene::materialOfTriangle(scene, object, triangle);
            const dvec3 diffuse(scene::diffuseAt(scene, object, triangle, point.barycentric()));
            const dvec3 positionWorld = tracer.positionWorld(point);
            const dvec3 toEyeWorld = glm::normalize(camera.positionWorld - positionWorld);
            const dvec3 normalWorld = normals.towardWorld(toEyeWorld, point);
            dvec3 remaining = dvec3(scene.ambient) * diffuse;
            if (scene::shinesFrom(material, point.eyeOnFront != scene::isMirrored(object))) remaining += dvec3(material.emission);
            const std::size_t pixel = row * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
            expected.isDull[pixel] = material.specular == vec3(0.0f) ? 1 : 0;
            for (int l = 0; l < static_cast<int>(scene.lights.size()); ++l) {
                if (!tracer.facesLight(point, l)) continue;
                const scene::Light& source = scene.light(l);
                const auto added = [&](const dvec3& normal) {
                    return scene::irradiance(source, positionWorld, normal) *
                           scene::reflectance(material, diffuse, normal, scene::towardLightWorld(source, positionWorld), toEyeWorld);
                };
                if (l == light) {
                    expected.ofLight[pixel] = vec3(added(normalWorld));
                    expected.ofLightFlat[pixel] = vec3(added(flatNormalWorld(tracer, point)));
                } else {
                    const dvec3 ofOther = added(normalWorld);
                    remaining += ofOther;
                    expected.ofOthers[pixel] += vec3(ofOther);
                }
            }
            expected.remaining[pixel] = vec3(remaining);
        }
    });
    return expected;
}

} // namespace shadowlab::foreign
