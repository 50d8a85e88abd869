// What planar shadows know about one pixel, and about a mesh.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/exact_judge.h"
#include "techniques/planar/technique.h"

namespace shadowlab::planar {

Probe Planar::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto hit = exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit) return probe;
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const Choice choice = choose(receivers_.inView(*snapshot, eye, scene::objectBounds(*snapshot)), params_.receivers,
                                 apartInPicture(view.size));
    for (const ChosenReceiver& one : choice.receivers) {
        if (one.receiver.object != hit->object || !contains(one.receiver.face->runs, hit->triangle)) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(snapshot->objects[hit->object]);
        probe.facts.push_back({"receiver plane", equation(planeOf(*one.receiver.face, worldFromMesh)), ""});
        probe.facts.push_back({"stencil number", std::to_string(one.tag), ""});
        return probe;
    }
    probe.facts.push_back({"receiver plane", "none: no shadow can fall here", ""});
    return probe;
}

namespace {

std::string percent(double share) {
    const double rounded = std::round(100 * share);
    if (share > 0 && rounded < 1) return "less than 1 %";
    if (share < 1 && rounded > 99) return "more than 99 %";
    return std::to_string(static_cast<int>(rounded)) + " %";
}

} // namespace

std::string Planar::remark(const scene::MeshReport& report, const scene::Mesh& mesh) const {
    const std::string holes = report.hasHoles ? "; casts the holes that an alpha map cuts as holes" : "";
    const FlatFaces found = flatFaces(mesh);
    const double rest = found.smoothArea + found.facetArea + found.leftOverArea;
    if (rest <= 0 || found.area <= 0)
        return "receives shadows on all of it: " + std::to_string(found.faces.size()) +
               (found.faces.size() == 1 ? " flat face" : " flat faces") + holes;
    std::string why;
    const auto add = [&](double area, const std::string& reason) {
        if (area > 0) why += (why.empty() ? "" : ", ") + percent(area / found.area) + " " + reason;
    };
    add(found.smoothArea, "is shaded as curved");
    add(found.facetArea, "are facets that meet at less than 30 degrees");
    add(found.leftOverArea, "are faces beyond the 2048 largest");
    if (found.faces.empty())
        return "casts, but receives no shadows, not even its own, for there is no plane: " + why + holes;
    return "receives shadows on " + std::to_string(found.faces.size()) +
           (found.faces.size() == 1 ? " flat face, " : " flat faces, ") + percent((found.area - rest) / found.area) +
           " of its area; on the rest there are none: " + why + holes;
}

} // namespace shadowlab::planar
