// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/outward_shells.h"

#include <map>
#include <numeric>

#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::scene {

namespace {

/// The skin of each triangle, named by one of its triangles.
std::vector<std::uint32_t> skins(const Mesh& mesh, const std::function<bool(std::uint32_t, std::uint32_t)>& areTogether) {
    std::vector<std::uint32_t> parent(mesh.triangles.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t t) {
        while (parent[t] != t)
            t = parent[t] = parent[parent[t]];
        return t;
    };
    const MeshTopology topology = buildTopology(mesh);
    for (const Edge& edge : topology.edges)
        for (std::uint32_t i = 0; i < edge.useCount; ++i)
            for (std::uint32_t j = i + 1; j < edge.useCount; ++j) {
                const EdgeUse &one = topology.uses[edge.firstUse + i], &other = topology.uses[edge.firstUse + j];
                if (one.direction != other.direction && !areTogether(one.triangle, other.triangle))
                    parent[root(one.triangle)] = root(other.triangle);
            }
    for (std::uint32_t t = 0; t < parent.size(); ++t)
        parent[t] = root(t);
    return parent;
}

} // namespace

std::vector<bool> inOutwardShell(const Mesh& mesh, const std::function<bool(std::uint32_t, std::uint32_t)>& areTogether) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> trianglesOf;
    const std::vector<std::uint32_t> skinOf = skins(mesh, areTogether);
    for (std::uint32_t t = 0; t < skinOf.size(); ++t)
        trianglesOf[skinOf[t]].push_back(t);
    std::vector<bool> result(mesh.triangles.size());
    for (const auto& [skin, triangles] : trianglesOf) {
        Mesh alone;
        alone.positionsMesh = mesh.positionsMesh;
        for (const std::uint32_t t : triangles)
            alone.triangles.push_back(mesh.triangles[t]);
        const OutwardParts parts = outwardParts(alone, buildTopology(alone));
        for (std::size_t i = 0; i < triangles.size(); ++i)
            result[triangles[i]] = parts.partOfTriangle[i] != OutwardParts::kNone;
    }
    return result;
}

} // namespace shadowlab::scene
