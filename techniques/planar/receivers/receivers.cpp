// SPDX-License-Identifier: MIT
#include "techniques/planar/receivers/receivers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/planar/params.h"

namespace shadowlab::planar {

namespace {

/// The part of a polygon in clip coordinates on the inner side of a border (Sutherland and Hodgman, 1974).
std::vector<dvec4> cut(const std::vector<dvec4>& polygonClip, const dvec4& border) {
    std::vector<dvec4> inside;
    for (std::size_t i = 0; i < polygonClip.size(); ++i) {
        const dvec4 &here = polygonClip[i], &next = polygonClip[(i + 1) % polygonClip.size()];
        const double dHere = glm::dot(border, here), dNext = glm::dot(border, next);
        if (dHere >= 0) inside.push_back(here);
        if ((dHere >= 0) != (dNext >= 0)) inside.push_back(glm::mix(here, next, dHere / (dHere - dNext)));
    }
    return inside;
}

/// What of a polygon lies in the picture, in normalised device coordinates.
std::vector<dvec2> inPicture(std::vector<dvec4> polygonClip) {
    for (const dvec4& border :
         {dvec4(0, 0, 1, 1), dvec4(1, 0, 0, 1), dvec4(-1, 0, 0, 1), dvec4(0, 1, 0, 1), dvec4(0, -1, 0, 1)})
        polygonClip = cut(polygonClip, border);
    std::vector<dvec2> polygon;
    for (const dvec4& corner : polygonClip)
        polygon.push_back(dvec2(corner) / corner.w);
    return polygon;
}

/// The share of the picture that a polygon in it covers.
double areaOf(const std::vector<dvec2>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        twice += here.x * next.y - here.y * next.x;
    }
    return std::abs(twice) / 8; // half of it; and the picture measures 2 x 2
}

scene::PicturePart partAround(const std::vector<dvec2>& polygon) {
    scene::PicturePart part{dvec2(1.0), dvec2(-1.0)};
    for (const dvec2& corner : polygon) {
        part.lower = glm::min(part.lower, corner);
        part.upper = glm::max(part.upper, corner);
    }
    return part;
}

/// True if the eye is behind a face of a closed object: then front faces hide it.
bool isBackOfClosed(const scene::Scene& scene, std::size_t object, const scene::Bounds& bounds,
                    const gl::EyeMatrices& eye, const dvec4& planeView) {
    return planeView.w <= 0 && scene.objects[object].mesh->outward && !scene::hasHoles(scene, scene.objects[object]) &&
           scene::isBeyondNearPlane(bounds, eye.clipFromView * eye.viewFromWorld);
}

/// True if the centre of a light shines on the side of the plane that the eye sees.
bool isLit(const scene::Scene& scene, const gl::EyeMatrices& eye, const ChosenReceiver& one) {
    return std::ranges::any_of(scene.lights, [&](const scene::Light& light) {
        const dvec4 lightView = eye.viewFromWorld * scene::homogeneousPositionWorld(light);
        const auto projection = projectOnto(one.planeView, lightView, reachOf(lightView, one.frameView));
        return projection && projection->planeView.w > 0;
    });
}

/// Gives tags to the drawn planes: counting down in drawing order, which is the order of the scene, and starting again at
/// the top where a plane overlaps none before it. False if there are not enough tags.
bool numbered(std::vector<ChosenReceiver>& planes, std::vector<std::size_t> drawn, const dvec2& apart) {
    std::ranges::sort(drawn);
    const auto mayOverlap = [&](const scene::PicturePart& a, const scene::PicturePart& b) {
        return glm::all(glm::lessThanEqual(a.lower, b.upper + apart)) &&
               glm::all(glm::lessThanEqual(b.lower, a.upper + apart));
    };
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        ChosenReceiver& plane = planes[drawn[i]];
        plane.tag = kNumbers;
        for (std::size_t before = 0; before < i; ++before)
            if (mayOverlap(planes[drawn[before]].part, plane.part))
                plane.tag = std::min(plane.tag, planes[drawn[before]].tag - 1);
        if (plane.tag < 1) return false;
    }
    return true;
}

} // namespace

bool Receivers::findNext(const scene::Snapshot& snapshot) {
    if (listedGeometry_ == snapshot->revisions.geometry) return true;
    if (findingGeometry_ != snapshot->revisions.geometry) {
        findingGeometry_ = snapshot->revisions.geometry;
        next_ = 0;
    }
    for (; next_ < snapshot->objects.size(); ++next_) {
        const scene::Object& object = snapshot->objects[next_];
        if (!object.receivesShadow || meshes_.contains(object.mesh.get())) continue;
        meshes_[object.mesh.get()] = {object.mesh, flatFaces(*object.mesh).faces};
        return false;
    }
    // All meshes have been looked at; meshes that no object has any more are dropped.
    std::set<const scene::Mesh*> present;
    for (const scene::Object& object : snapshot->objects)
        present.insert(object.mesh.get());
    std::erase_if(meshes_, [&](const auto& known) { return !present.contains(known.first); });
    list(*snapshot);
    listedGeometry_ = snapshot->revisions.geometry;
    return true;
}

void Receivers::list(const scene::Scene& scene) {
    all_.clear();
    std::vector<double> areas; // of the rectangles around them, in square metres
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        if (!scene.objects[o].receivesShadow) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[o]);
        for (const FlatFace& face : meshes_.at(scene.objects[o].mesh.get()).faces) {
            std::array<dvec3, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = transformPoint(worldFromMesh, face.frameMesh[i]);
            areas.push_back(glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
            all_.push_back({o, &face, 0});
        }
    }
    std::vector<std::size_t> order(all_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return areas[i]; });
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        all_[order[rank]].rank = rank;
}

std::vector<ChosenReceiver> Receivers::inView(const scene::Scene& scene, const gl::EyeMatrices& eye,
                                              std::span<const scene::Bounds> bounds) const {
    std::vector<ChosenReceiver> inView;
    for (const Receiver& receiver : all_) {
        const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[receiver.object]);
        const dmat4 viewFromMesh = eye.viewFromWorld * worldFromMesh;
        ChosenReceiver one;
        one.receiver = receiver;
        std::vector<dvec4> frameClip;
        for (std::size_t i = 0; i < 4; ++i) {
            one.frameWorld[i] = transformPoint(worldFromMesh, receiver.face->frameMesh[i]);
            one.frameView[i] = transformPoint(viewFromMesh, receiver.face->frameMesh[i]);
            frameClip.push_back(eye.clipFromView * dvec4(one.frameView[i], 1.0));
        }
        const std::vector<dvec2> polygon = inPicture(std::move(frameClip));
        one.pictureArea = areaOf(polygon);
        if (one.pictureArea <= 0) continue;
        one.part = partAround(polygon);
        one.planeView = planeOf(*receiver.face, viewFromMesh);
        if (isBackOfClosed(scene, receiver.object, bounds[receiver.object], eye, one.planeView)) continue;
        one.unevenness = receiver.face->unevenness * glm::length(dvec3(one.planeView * viewFromMesh));
        one.lit = isLit(scene, eye, one);
        inView.push_back(one);
    }
    return inView;
}

Choice choose(const std::vector<ChosenReceiver>& inView, int limit, const dvec2& apart, const HiddenFaces& hidden) {
    std::vector<ChosenReceiver> seen;
    for (const ChosenReceiver& one : inView)
        if (!hidden.contains({one.receiver.object, one.receiver.face})) seen.push_back(one);
    std::vector<std::size_t> order(seen.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        if (seen[a].lit != seen[b].lit) return seen[a].lit;
        return seen[a].pictureArea > seen[b].pictureArea;
    });
    order.resize(std::min(order.size(), static_cast<std::size_t>(limit)));
    // Too many planes overlap, so the smallest are left out.
    while (!numbered(seen, order, apart))
        order.resize(order.size() - std::max<std::size_t>(1, order.size() / 8));
    Choice choice{{}, order.size() < seen.size()};
    for (const std::size_t i : order)
        choice.receivers.push_back(seen[i]);
    return choice;
}

} // namespace shadowlab::planar
