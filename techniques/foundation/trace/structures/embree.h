// Embree 3 (Debian 12) and Embree 4 (Debian 13 and later) by the same calls. Included where SHADOWLAB_EMBREE is defined: the
// number of the one that is installed.
// SPDX-License-Identifier: MIT
#pragma once

#if SHADOWLAB_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <cstdint>
#include <span>

#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace::embree {

#if SHADOWLAB_EMBREE == 3

/// The context of a query, which Embree passes on to the filter: derive from it to give the filter its data.
struct Query : RTCIntersectContext {
    Query() { rtcInitIntersectContext(this); }
    void askFilter(RTCFilterFunctionN function) { filter = function; }
    void beCoherent() { flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT; }
};

/// Filters come with a ray, and cost nothing where there are none.
inline constexpr RTCSceneFlags kFiltersOfRays = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void closest(RTCScene scene, Query& query, RTCRayHit& ray) { rtcIntersect1(scene, &query, &ray); }
inline void any(RTCScene scene, Query& query, RTCRay& ray) { rtcOccluded1(scene, &query, &ray); }
inline void closest(const int* valid, RTCScene scene, Query& query, RTCRayHit8& rays) {
    rtcIntersect8(valid, scene, &query, &rays);
}
inline void any(const int* valid, RTCScene scene, Query& query, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &query, &rays);
}

#else

struct Query : RTCRayQueryContext {
    Query() { rtcInitRayQueryContext(this); }
    void askFilter(RTCFilterFunctionN function) {
        filter_ = function;
        flags_ |= RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    }
    void beCoherent() { flags_ |= RTC_RAY_QUERY_FLAG_COHERENT; }

    [[nodiscard]] RTCIntersectArguments forClosest() {
        RTCIntersectArguments arguments;
        rtcInitIntersectArguments(&arguments);
        fill(arguments);
        return arguments;
    }
    [[nodiscard]] RTCOccludedArguments forAny() {
        RTCOccludedArguments arguments;
        rtcInitOccludedArguments(&arguments);
        fill(arguments);
        return arguments;
    }

private:
    template <typename Arguments>
    void fill(Arguments& arguments) {
        arguments.flags = static_cast<RTCRayQueryFlags>(flags_);
        arguments.context = this;
        arguments.filter = filter_;
    }

    RTCFilterFunctionN filter_ = nullptr;
    int flags_ = RTC_RAY_QUERY_FLAG_INCOHERENT;
};

inline constexpr RTCSceneFlags kFiltersOfRays = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

inline void closest(RTCScene scene, Query& query, RTCRayHit& ray) {
    RTCIntersectArguments arguments = query.forClosest();
    rtcIntersect1(scene, &ray, &arguments);
}
inline void any(RTCScene scene, Query& query, RTCRay& ray) {
    RTCOccludedArguments arguments = query.forAny();
    rtcOccluded1(scene, &ray, &arguments);
}
inline void closest(const int* valid, RTCScene scene, Query& query, RTCRayHit8& rays) {
    RTCIntersectArguments arguments = query.forClosest();
    rtcIntersect8(valid, scene, &rays, &arguments);
}
inline void any(const int* valid, RTCScene scene, Query& query, RTCRay8& rays) {
    RTCOccludedArguments arguments = query.forAny();
    rtcOccluded8(valid, scene, &rays, &arguments);
}

#endif

/// Copies the triangles, rounded to floats, into a geometry of the scene: three vertices of its own for each.
inline void attach(RTCDevice device, RTCScene scene, std::span<const Triangle> triangles) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                  3 * sizeof(float), 3 * triangles.size()));
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    std::uint32_t vertex = 0;
    for (const Triangle& t : triangles)
        for (const dvec3* corner : {&t.a, &t.b, &t.c}) {
            for (int axis = 0; axis < 3; ++axis)
                *positions++ = static_cast<float>((*corner)[axis]);
            *corners++ = vertex++;
        }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

} // namespace shadowlab::trace::embree
