// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/engine.h"

#if defined(SHADOWLAB_EMBREE)

#include <embree3/rtcore.h>

#include <stdexcept>

namespace shadowlab::trace {

namespace {

/// What a shadow ray may be blocked by, handed through Embree to the filter below.
struct ShadowQuery : RTCIntersectContext {
    std::uint32_t except;
    std::span<const std::uint8_t> mayBlock;
};

/// Takes back a hit that does not count: the ray goes on.
void forgive(const RTCFilterFunctionNArguments* arguments) {
    const auto& query = *static_cast<const ShadowQuery*>(arguments->context);
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    if (primitive == query.except || !query.mayBlock[primitive]) arguments->valid[0] = 0;
}

template <typename EmbreeRay>
void fill(EmbreeRay& to, const Ray& ray) {
    to.org_x = static_cast<float>(ray.originCentred.x);
    to.org_y = static_cast<float>(ray.originCentred.y);
    to.org_z = static_cast<float>(ray.originCentred.z);
    to.dir_x = static_cast<float>(ray.directionCentred.x);
    to.dir_y = static_cast<float>(ray.directionCentred.y);
    to.dir_z = static_cast<float>(ray.directionCentred.z);
    to.tnear = static_cast<float>(ray.nearest);
    to.tfar = static_cast<float>(ray.farthest);
    to.mask = ~0u;
}

class EmbreeEngine final : public Engine {
public:
    explicit EmbreeEngine(const std::vector<Triangle>& triangles)
        : device_(rtcNewDevice(nullptr), rtcReleaseDevice), scene_(nullptr, rtcReleaseScene) {
        if (!device_) throw std::runtime_error("Embree makes no device");
        scene_.reset(rtcNewScene(device_.get()));
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST); // its watertight mode
        if (!triangles.empty()) attach(triangles);
        rtcCommitScene(scene_.get());
    }

    [[nodiscard]] RayHit closest(const Ray& ray) const override {
        if (!isUsable(ray)) return {};
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        fill(query.ray, ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_.get(), &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const double u = query.hit.u, v = query.hit.v;
        return {query.ray.tfar, query.hit.primID, {1 - u - v, u, v}};
    }

    [[nodiscard]] bool blocked(const Ray& ray, std::uint32_t except,
                               std::span<const std::uint8_t> mayBlock) const override {
        if (!isUsable(ray)) return false;
        ShadowQuery context{};
        rtcInitIntersectContext(&context);
        context.except = except;
        context.mayBlock = mayBlock;
        RTCRay query{};
        fill(query, ray);
        rtcOccluded1(scene_.get(), &context, &query);
        return query.tfar < 0; // how Embree says so
    }

private:
    void attach(const std::vector<Triangle>& triangles) {
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
        auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
        std::uint32_t vertex = 0;
        for (const Triangle& t : triangles)
            for (const dvec3* corner : {&t.a, &t.b, &t.c}) {
                for (int axis = 0; axis < 3; ++axis)
                    *positions++ = static_cast<float>((*corner)[axis]);
                *corners++ = vertex++;
            }
        rtcSetGeometryOccludedFilterFunction(geometry, forgive);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
    }

    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

} // namespace

std::unique_ptr<Engine> makeEmbreeEngine(const std::vector<Triangle>& triangles) {
    return std::make_unique<EmbreeEngine>(triangles);
}

} // namespace shadowlab::trace

#else

namespace shadowlab::trace {
std::unique_ptr<Engine> makeEmbreeEngine(const std::vector<Triangle>&) { return nullptr; }
} // namespace shadowlab::trace

#endif
