// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/outward_shells.h"

#include <algorithm>
#include <map>
#include <set>

#include "techniques/foundation/base/disjoint_sets.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::scene {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// The skin of each triangle, named by one of its triangles.
std::vector<std::uint32_t> skins(const Mesh& mesh, const std::set<Pair>& coinciding) {
    DisjointSets joined(mesh.triangles.size());
    const MeshTopology topology = buildTopology(mesh);
    for (const Edge& edge : topology.edges)
        for (std::uint32_t i = 0; i < edge.useCount; ++i)
            for (std::uint32_t j = i + 1; j < edge.useCount; ++j) {
                const EdgeUse &one = topology.uses[edge.firstUse + i], &other = topology.uses[edge.firstUse + j];
                if (one.direction != other.direction && !coinciding.contains(std::minmax(one.triangle, other.triangle)))
                    joined.join(one.triangle, other.triangle);
            }
    return joined.names();
}

/// Some triangles of a mesh, with the positions that they use.
Mesh partOfMesh(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Mesh part;
    std::map<std::uint32_t, std::uint32_t> known;
    for (const std::uint32_t t : triangles) {
        uvec3 corners;
        for (int i = 0; i < 3; ++i) {
            const auto [entry, isNew] = known.try_emplace(mesh.triangles[t][i], static_cast<std::uint32_t>(part.positionsMesh.size()));
            if (isNew) part.positionsMesh.push_back(mesh.positionsMesh[entry->first]);
            corners[i] = entry->second;
        }
        part.triangles.push_back(corners);
    }
    return part;
}

} // namespace

std::vector<bool> inOutwardShell(const Mesh& mesh, std::span<const Pair> coinciding) {
    std::set<Pair> sorted;
    for (const auto& [a, b] : coinciding)
        sorted.insert(std::minmax(a, b));
    const std::vector<std::uint32_t> skinOf = skins(mesh, sorted);
    std::map<std::uint32_t, std::vector<std::uint32_t>> trianglesOf; // of the skins that lie at the place of others
    for (const auto& [a, b] : sorted)
        for (const std::uint32_t t : {a, b})
            trianglesOf.try_emplace(skinOf[t]);
    for (std::uint32_t t = 0; t < skinOf.size(); ++t)
        if (const auto found = trianglesOf.find(skinOf[t]); found != trianglesOf.end()) found->second.push_back(t);
    std::vector<bool> result(mesh.triangles.size());
    for (const auto& [skin, triangles] : trianglesOf) {
        const Mesh alone = partOfMesh(mesh, triangles);
        const OutwardParts parts = outwardParts(alone, buildTopology(alone));
        for (std::size_t i = 0; i < triangles.size(); ++i)
            result[triangles[i]] = parts.partOfTriangle[i] != OutwardParts::kNone;
    }
    return result;
}

} // namespace shadowlab::scene
