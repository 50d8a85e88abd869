// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/structures/engine.h"

#if defined(SHADOWLAB_EMBREE)

#include <atomic>
#include <stdexcept>

#include "techniques/foundation/trace/structures/embree.h"

namespace shadowlab::trace {

namespace {

/// What a ray may hit, handed through Embree to the filter below.
struct FilteredQuery : embree::Query {
    explicit FilteredQuery(const MayHit& which);
    const MayHit* mayHit;
};

/// Rejects a hit that does not count, so that the ray goes on.
void forgive(const RTCFilterFunctionNArguments* arguments) {
    const MayHit& mayHit = *static_cast<const FilteredQuery*>(arguments->context)->mayHit;
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const double u = RTCHitN_u(arguments->hit, arguments->N, 0), v = RTCHitN_v(arguments->hit, arguments->N, 0);
    if (!mayHit(primitive) || mayHit.inHole(primitive, {1 - u - v, u, v})) arguments->valid[0] = 0;
}

FilteredQuery::FilteredQuery(const MayHit& which) : mayHit(&which) {
    const bool any = which.except == kNoPrimitive && which.only == nullptr && which.flags == nullptr && which.holes == nullptr;
    if (!any) askFilter(forgive);
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
    EmbreeEngine(std::span<const Triangle> triangles, bool exact)
        : triangles_(triangles), exact_(exact), device_(rtcNewDevice(nullptr), rtcReleaseDevice),
          scene_(nullptr, rtcReleaseScene) {
        if (!device_) throw std::runtime_error("Embree makes no device");
        rtcSetDeviceMemoryMonitorFunction(device_.get(), countBytes, &bytes_);
    }

    bool advance(Deadline) override {
        if (scene_) return true;
        scene_.reset(rtcNewScene(device_.get()));
        // Its watertight mode, and filters.
        rtcSetSceneFlags(scene_.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | embree::kFiltersOfRays));
        if (!triangles_.empty()) embree::attach(device_.get(), scene_.get(), triangles_);
        rtcCommitScene(scene_.get());
        return true;
    }

    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit) const override {
        if (!isUsable(ray)) return {};
        FilteredQuery how(mayHit);
        RTCRayHit query{};
        fill(query.ray, ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        embree::closest(scene_.get(), how, query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const double u = query.hit.u, v = query.hit.v;
        const RayHit hit{query.ray.tfar, query.hit.primID, {1 - u - v, u, v}};
        return exact_ ? inDouble(ray, hit) : hit;
    }

    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit) const override {
        if (!isUsable(ray)) return kNoPrimitive;
        FilteredQuery how(mayHit);
        RTCRay query{};
        fill(query, ray);
        embree::any(scene_.get(), how, query);
        return query.tfar < 0 ? 0 : kNoPrimitive; // Embree reports that there is a hit, but not which
    }

    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit, RayTests&) const override {
        return closest(ray, mayHit);
    }
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit, RayTests&) const override {
        return any(ray, mayHit);
    }
    [[nodiscard]] bool counts() const override { return false; }
    [[nodiscard]] std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

private:
    /// Embree calls this, from any thread, whenever it allocates or frees memory.
    static bool countBytes(void* sum, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::int64_t>*>(sum) += bytes;
        return true;
    }

    /// The same hit in double; at the edge of the triangle there may be none, then it stays as it is.
    [[nodiscard]] RayHit inDouble(const Ray& ray, const RayHit& hit) const {
        const ShearedRay sheared(ray);
        const auto found = intersect(sheared, triangles_[hit.primitive], sheared.farthest);
        return found ? RayHit{found->reach / sheared.reachPerT, hit.primitive, found->barycentric} : hit;
    }

    std::span<const Triangle> triangles_;
    bool exact_;
    std::atomic<std::int64_t> bytes_ = 0; ///< of the device: its own copy of the triangles, too
    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

} // namespace

std::unique_ptr<Engine> makeEmbreeEngine(std::span<const Triangle> triangles, bool exact) {
    return std::make_unique<EmbreeEngine>(triangles, exact);
}

} // namespace shadowlab::trace

#else

namespace shadowlab::trace {
std::unique_ptr<Engine> makeEmbreeEngine(std::span<const Triangle>, bool) { return nullptr; }
} // namespace shadowlab::trace

#endif
