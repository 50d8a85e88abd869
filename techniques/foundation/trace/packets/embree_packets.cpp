// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/packets/embree_packets.h"

#if defined(SHADOWLAB_EMBREE)

#include <limits>
#include <stdexcept>

#include "techniques/foundation/trace/structures/embree.h"

namespace shadowlab::trace {

namespace {

constexpr float kOffset = 1e-4f; // share of the way to the light; less lets acne through at these distances

class Packets final : public EmbreePackets {
public:
    explicit Packets(const std::vector<Triangle>& triangles)
        : device_(rtcNewDevice(nullptr), rtcReleaseDevice), scene_(nullptr, rtcReleaseScene) {
        if (!device_) throw std::runtime_error("Embree makes no device");
        scene_.reset(rtcNewScene(device_.get()));
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST); // its watertight mode
        embree::attach(device_.get(), scene_.get(), triangles);
        rtcCommitScene(scene_.get());
    }

    void row(const PacketView& view, int y, std::uint8_t* mask) const override {
        embree::Query how;
        how.beCoherent();
        for (int x = 0; x < view.width; x += 8) {
            alignas(32) RTCRayHit8 eye;
            alignas(32) RTCRay8 shadow;
            alignas(32) int all[8], some[8];
            for (int i = 0; i < 8; ++i) {
                const vec3 d = view.corner + (static_cast<float>(x + i) + 0.5f) * view.perX +
                               (static_cast<float>(y) + 0.5f) * view.perY;
                all[i] = -1;
                set(eye.ray, i, view.eye, d, 0, std::numeric_limits<float>::infinity());
                eye.hit.geomID[i] = eye.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            }
            embree::closest(all, scene_.get(), how, eye);
            bool any = false;
            for (int i = 0; i < 8; ++i) {
                some[i] = eye.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? 0 : -1;
                any |= some[i] != 0;
                const float t = some[i] ? eye.ray.tfar[i] : 0.0f;
                const vec3 d(eye.ray.dir_x[i], eye.ray.dir_y[i], eye.ray.dir_z[i]);
                set(shadow, i, view.eye + t * d, view.light - (view.eye + t * d), kOffset, 1);
            }
            if (any) embree::any(some, scene_.get(), how, shadow);
            for (int i = 0; i < 8; ++i)
                mask[x + i] = static_cast<std::uint8_t>(!some[i] ? 0 : shadow.tfar[i] < 0 ? 1 : 2);
        }
    }

private:
    static void set(RTCRay8& ray, int i, const vec3& origin, const vec3& direction, float nearest, float farthest) {
        ray.org_x[i] = origin.x;
        ray.org_y[i] = origin.y;
        ray.org_z[i] = origin.z;
        ray.dir_x[i] = direction.x;
        ray.dir_y[i] = direction.y;
        ray.dir_z[i] = direction.z;
        ray.tnear[i] = nearest;
        ray.tfar[i] = farthest;
        ray.mask[i] = ~0u;
        ray.time[i] = 0;
        ray.flags[i] = 0;
    }

    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

} // namespace

std::unique_ptr<EmbreePackets> makeEmbreePackets(const std::vector<Triangle>& triangles) {
    return std::make_unique<Packets>(triangles);
}

} // namespace shadowlab::trace

#else

namespace shadowlab::trace {
std::unique_ptr<EmbreePackets> makeEmbreePackets(const std::vector<Triangle>&) { return nullptr; }
} // namespace shadowlab::trace

#endif
