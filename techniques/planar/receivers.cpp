// SPDX-License-Identifier: MIT
#include "techniques/planar/receivers.h"

#include <algorithm>
#include <cmath>
#include <set>

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

/// The share of the picture that a polygon covers.
double pictureArea(std::vector<dvec4> polygonClip) {
    for (const dvec4& border :
         {dvec4(0, 0, 1, 1), dvec4(1, 0, 0, 1), dvec4(-1, 0, 0, 1), dvec4(0, 1, 0, 1), dvec4(0, -1, 0, 1)})
        polygonClip = cut(polygonClip, border);
    double twice = 0;
    for (std::size_t i = 0; i < polygonClip.size(); ++i) {
        const dvec4 &here = polygonClip[i], &next = polygonClip[(i + 1) % polygonClip.size()];
        twice += (here.x * next.y - here.y * next.x) / (here.w * next.w);
    }
    return std::abs(twice) / 8; // half of it; and the picture measures 2 x 2
}

} // namespace

bool Receivers::findNext(const scene::Snapshot& snapshot) {
    if (listedGeometry_ == snapshot->revisions.geometry) return true;
    for (const scene::Object& object : snapshot->objects) {
        if (!object.receivesShadow || meshes_.contains(object.mesh.get())) continue;
        meshes_[object.mesh.get()] = {object.mesh, flatFaces(*object.mesh)};
        return false;
    }
    // All meshes are known; those of no object any more are forgotten.
    std::set<const scene::Mesh*> present;
    for (const scene::Object& object : snapshot->objects)
        present.insert(object.mesh.get());
    std::erase_if(meshes_, [&](const auto& known) { return !present.contains(known.first); });
    all_.clear();
    for (std::size_t o = 0; o < snapshot->objects.size(); ++o)
        if (snapshot->objects[o].receivesShadow)
            for (const FlatFace& face : meshes_.at(snapshot->objects[o].mesh.get()).faces)
                all_.push_back({o, &face});
    listedGeometry_ = snapshot->revisions.geometry;
    return true;
}

std::vector<ChosenReceiver> Receivers::choose(const scene::Scene& scene, const gl::EyeMatrices& eye, int limit) const {
    std::vector<ChosenReceiver> chosen;
    for (const Receiver& receiver : all_) {
        const scene::Object& object = scene.objects[receiver.object];
        ChosenReceiver one{receiver, 0, 0, 0, eye.viewFromWorld * scene::worldFromMesh(object), dvec4(0.0), 0, {}};
        std::vector<dvec4> frameClip;
        for (std::size_t i = 0; i < 4; ++i) {
            one.frameView[i] = transformPoint(one.viewFromMesh, receiver.face->frameMesh[i]);
            frameClip.push_back(eye.clipFromView * dvec4(one.frameView[i], 1.0));
        }
        one.pictureArea = pictureArea(std::move(frameClip));
        if (one.pictureArea <= 0) continue;
        one.planeView = planeOf(*receiver.face, one.viewFromMesh);
        one.unevenness = receiver.face->unevenness * glm::length(dvec3(one.planeView * one.viewFromMesh));
        chosen.push_back(one);
    }
    // Tags count down in the order of drawing; who is chosen depends on the area alone.
    const auto larger = [](const ChosenReceiver& a, const ChosenReceiver& b) { return a.pictureArea > b.pictureArea; };
    std::vector<std::size_t> order(chosen.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return larger(chosen[a], chosen[b]); });
    order.resize(std::min(order.size(), static_cast<std::size_t>(limit)));
    std::vector<std::size_t> drawn = order;
    std::ranges::sort(drawn);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        chosen[drawn[i]].tag = static_cast<int>(drawn.size() - i);
    std::vector<ChosenReceiver> result;
    for (const std::size_t i : order)
        result.push_back(chosen[i]);
    return result;
}

} // namespace shadowlab::planar
