// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/light_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

// Points on a border are moved toward the patch's centre by this share of the way, so that a wall on the border is beside them.
constexpr double kInward = 1e-4;

// The most points along one side of a patch: their total must stay exact as a float.
constexpr double kMostAlong = 255;

// Points in one piece of work of a thread.
constexpr std::size_t kBlock = 64;

/// The place itself, or the nearest point of the convex polygon.
dvec2 nearestIn(std::span<const dvec2> corners, const dvec2& place) {
    dvec2 nearest = place;
    double best = std::numeric_limits<double>::infinity();
    bool isInside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 &a = corners[i], way = corners[(i + 1) % corners.size()] - a, offset = place - a;
        if (way.x * offset.y - way.y * offset.x < 0) isInside = false;
        const double square = glm::dot(way, way);
        const dvec2 onEdge = a + (square > 0 ? glm::clamp(glm::dot(offset, way) / square, 0.0, 1.0) : 0.0) * way;
        if (const double distance = glm::length(onEdge - place); distance < best) {
            best = distance;
            nearest = onEdge;
        }
    }
    return isInside ? place : nearest;
}

} // namespace

bool LightMap::advance(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points, Deadline deadline) {
    if (!tracer_.advance(snapshot, deadline)) return false;
    if (room_ != cache.version() || wanted_ != points) begin(snapshot, cache, points);
    lights_.resize(snapshot->lights.size());
    const std::size_t blocks = (points_.size() + kBlock - 1) / kBlock;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        OfLight& map = lights_[i];
        if (map.arriving.empty() || map.light != snapshot->lights[i])
            map = {snapshot->lights[i], std::vector<vec4>(points_.size(), vec4(0.0f)), 0};
        if (map.next == blocks) continue;
        const LightSource source(map.light, tracer_.world().originWorld, cache.room().sides().faces);
        map.next = trace::parallelUntil(deadline, map.next, blocks,
                                        [&](std::size_t block) { fill(map, static_cast<int>(i), source, block); });
        if (map.next < blocks) return false;
        ++version_;
    }
    return true;
}

void LightMap::begin(const scene::Snapshot& snapshot, const RoomCache& cache, std::size_t points) {
    room_ = cache.version();
    wanted_ = points;
    lights_.clear();
    lattices_.clear();
    points_.clear();
    const Room& room = cache.room();
    double area = 0;
    for (const Patch& patch : room.allPatches())
        area += patch.area;
    const double spacing = std::sqrt(area / static_cast<double>(points));
    for (std::uint32_t p = 0; p < room.allPatches().size(); ++p) {
        const Patch& patch = room.allPatches()[p];
        addLattice(patch, cache.cells().frames[p], spacing, {{}, patch.normal, p, room.objectOf(patch).receivesShadow});
    }
    firstVertex_ = points_.size();
    for (const SurfaceCells::Vertex& vertex : cache.cells().vertices)
        points_.push_back({vertex.positionCentred, vertex.normal, 0, snapshot->objects[vertex.object].receivesShadow});
    const dvec3 tracerFromRoom = room.world().originWorld - tracer_.world().originWorld;
    for (Point& point : points_)
        point.positionCentred += tracerFromRoom;
    nearest_ = kTouching * tracer_.largestCentred();
    const double offPlane = 2 * kOffPlane * room.simple().cellMetres;
    for (std::size_t i = 0; i < firstVertex_; ++i)
        if (const std::uint32_t object = room.faceOf(room.allPatches()[points_[i].patch]).object;
            room.isSimplified(object))
            bringToSurface(points_[i], object, offPlane);
}

void LightMap::addLattice(const Patch& patch, const FaceFrame& frame, double spacing, Point point) {
    std::vector<dvec2> corners;
    dvec2 lower(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const dvec3& corner : patch.polygon.corners()) {
        corners.push_back(frame.place(corner));
        lower = glm::min(lower, corners.back());
        upper = glm::max(upper, corners.back());
    }
    if (glm::dot(glm::cross(frame.u, frame.v), patch.normal) < 0) std::ranges::reverse(corners); // a back side
    const dvec2 size = upper - lower;
    const ivec2 count = 1 + ivec2(glm::clamp(glm::ceil(size / spacing), 1.0, kMostAlong));
    lattices_.emplace_back(vec2(lower), vec2(size));
    lattices_.emplace_back(static_cast<float>(points_.size()), vec2(count), 0.0f);
    const dvec2 centre = frame.place(patch.centre);
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x) {
            const dvec2 at = glm::mix(lower, upper, dvec2(x, y) / dvec2(count - 1));
            const dvec2 place = glm::mix(nearestIn(corners, at), centre, kInward);
            point.positionCentred = frame.originCentred + place.x * frame.u + place.y * frame.v;
            points_.push_back(point);
        }
}

void LightMap::bringToSurface(Point& point, std::uint32_t object, double within) const {
    const trace::Ray ray{point.positionCentred + within * point.normal, -point.normal, 0, 2 * within};
    const trace::SurfacePoint hit = tracer_.met(ray, trace::kNoPrimitive);
    if (hit && tracer_.world().objects[hit.primitive] == object) point.positionCentred = tracer_.positionCentred(hit);
}

void LightMap::fill(OfLight& map, int light, const LightSource& source, std::size_t block) const {
    for (std::size_t i = block * kBlock; i < std::min((block + 1) * kBlock, points_.size()); ++i) {
        const Point& point = points_[i];
        const auto isBlocked = [&](const dvec3& fromCentred, const dvec3& toCentred) {
            if (!point.receivesShadow) return false;
            const dvec3 way = toCentred - fromCentred;
            return tracer_.isBlocked({fromCentred, way, nearest_ / glm::length(way), 1 - trace::kContact},
                                     trace::kNoPrimitive, light); // a light may touch a face
        };
        const Arriving arriving = radiosity::arrivingAt(point.positionCentred, point.normal, source, isBlocked);
        map.arriving[i] = vec4(vec3(arriving.irradiance), static_cast<float>(arriving.seenArea));
    }
}

dvec3 LightMap::arrivingAt(std::size_t point) const {
    dvec3 sum(0);
    for (const OfLight& map : lights_)
        sum += dvec3(map.arriving[point]);
    return sum;
}

LightMap::Values LightMap::irradiance(const SurfaceCells& cells) const {
    Values values;
    for (std::size_t i = 0; i < firstVertex_; ++i)
        values.atPoints.emplace_back(vec3(arrivingAt(i)), 1.0f);
    for (const SurfaceCells::Blend& blend : cells.blends)
        values.atBlends.push_back(arrivingAt(firstVertex_ + blend.vertex));
    return values;
}

LightMap::Values LightMap::seenArea(const SurfaceCells& cells, int light) const {
    const std::vector<vec4>& arriving = lights_[static_cast<std::size_t>(light)].arriving;
    Values values;
    for (std::size_t i = 0; i < firstVertex_; ++i)
        values.atPoints.emplace_back(arriving[i].a, 0.0f, 0.0f, 1.0f);
    for (const SurfaceCells::Blend& blend : cells.blends)
        values.atBlends.emplace_back(static_cast<double>(arriving[firstVertex_ + blend.vertex].a));
    return values;
}

} // namespace shadowlab::radiosity
