// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_nodes.h"

#include <cmath>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/gltf/unique_names.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

constexpr std::size_t kNoParent = ~std::size_t{0};

std::size_t nodeIndex(int index) { return static_cast<std::size_t>(index); }

/// The parent of each node; checks that no node has two, and that none is its own ancestor.
std::vector<std::size_t> parentsOf(const GltfSource& source, const tinygltf::Model& model) {
    std::vector<std::size_t> parents(model.nodes.size(), kNoParent);
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        for (const int child : model.nodes[i].children) {
            std::size_t& parent = parents[nodeIndex(child)];
            if (parent != kNoParent)
                source.fail("nodes", nodeIndex(child),
                            "is a child of nodes[" + std::to_string(parent) + "] and of nodes[" + std::to_string(i) +
                                "]; a node has one parent: take it out of one of them");
            parent = i;
        }
    // With one parent each, a node that no root leads to is part of a circle, or hangs below one.
    std::vector<bool> isReached(model.nodes.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == kNoParent) open.push_back(i);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        isReached[node] = true;
        for (const int child : model.nodes[node].children)
            open.push_back(nodeIndex(child));
    }
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (!isReached[i])
            source.fail("nodes", i, "is its own ancestor, or a child of one that is; nodes must be a tree: export the model again");
    return parents;
}

/// Roots of the scene that is shown: the file's choice, else its first; all there are where it has no scene.
std::vector<std::size_t> shownRoots(GltfSource& source, const tinygltf::Model& model, const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> roots;
    if (model.scenes.empty()) {
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] == kNoParent) roots.push_back(i);
        return roots;
    }
    const std::size_t shown = model.defaultScene < 0 ? 0 : nodeIndex(model.defaultScene);
    for (std::size_t i = 0; i < model.scenes.size(); ++i)
        if (i != shown) source.note("scenes", i, "is left out; scenes[" + std::to_string(shown) + "] is shown");
    std::set<int> known;
    for (const int root : model.scenes[shown].nodes) {
        if (!known.insert(root).second) source.fail("scenes", shown, "names nodes[" + std::to_string(root) + "] twice; take it out once");
        if (parents[nodeIndex(root)] != kNoParent)
            source.fail("scenes", shown,
                        "names nodes[" + std::to_string(root) + "], which is a child of nodes[" +
                            std::to_string(parents[nodeIndex(root)]) + "]; a scene names roots alone: export the model again");
        roots.push_back(nodeIndex(root));
    }
    return roots;
}

dmat4 matrixOf(GltfSource& source, const tinygltf::Model& model, std::size_t index) {
    const tinygltf::Node& node = model.nodes[index];
    dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
        const JsonValue& keys = source.elements("nodes")[index];
        if (gltfMember(keys, "translation") || gltfMember(keys, "rotation") || gltfMember(keys, "scale"))
            source.note("nodes", index, "has a matrix beside translation, rotation or scale; the matrix counts");
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[column][row] = node.matrix[static_cast<std::size_t>(4 * column + row)];
        constexpr double kRounding = 1e-6; // of numbers that were floats
        const dvec4 lastRow(matrix[0].w, matrix[1].w, matrix[2].w, matrix[3].w - 1);
        for (int column = 0; column < 4; ++column)
            matrix[column].w = column < 3 ? 0 : 1;
        if (!(glm::length(lastRow) <= kRounding))
            source.fail("nodes", index,
                        "has a matrix whose last row is not 0 0 0 1 (column by column: numbers 4, 8, 12 and 16); "
                        "projections do not place things: correct the matrix");
        return matrix;
    }
    if (!node.rotation.empty()) {
        const dvec4 q(node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]);
        const double length = glm::length(q);
        if (!(length > 0) || !std::isfinite(length))
            source.fail("nodes", index,
                        "has a rotation without a direction (a quaternion of length " + numberText(length) +
                            "); write [0, 0, 0, 1] for none");
        const auto [x, y, z, w] = std::array{q.x / length, q.y / length, q.z / length, q.w / length};
        matrix[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
        matrix[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
        matrix[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!node.scale.empty()) matrix[axis] *= node.scale[static_cast<std::size_t>(axis)];
        if (!node.translation.empty()) matrix[3][axis] = node.translation[static_cast<std::size_t>(axis)];
    }
    return matrix;
}

/// What a node is called. Objects, lights and cameras are named after it.
std::string nameOfNode(const tinygltf::Model& model, std::size_t index) {
    const tinygltf::Node& node = model.nodes[index];
    if (!node.name.empty()) return node.name;
    if (node.mesh >= 0 && !model.meshes[nodeIndex(node.mesh)].name.empty()) return model.meshes[nodeIndex(node.mesh)].name;
    if (node.camera >= 0 && !model.cameras[nodeIndex(node.camera)].name.empty()) return model.cameras[nodeIndex(node.camera)].name;
    return "node " + std::to_string(index);
}

bool isFiniteMatrix(const dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

} // namespace

std::vector<GltfNode> gltfNodes(GltfSource& source, const tinygltf::Model& model) {
    const std::vector<std::size_t> parents = parentsOf(source, model);
    const std::vector<std::size_t> roots = shownRoots(source, model, parents);
    std::vector<GltfNode> nodes;
    UniqueNames names;
    std::vector<std::pair<std::size_t, dmat4>> open; // a node and the matrix of its parent, the next one last
    for (std::size_t i = roots.size(); i-- > 0;)
        open.emplace_back(roots[i], dmat4(1.0));
    while (!open.empty()) {
        const auto [index, worldFromParent] = open.back();
        open.pop_back();
        const dmat4 worldFromNode = worldFromParent * matrixOf(source, model, index);
        if (!isFiniteMatrix(worldFromNode))
            source.fail("nodes", index,
                        "stands, with its parents, where no numbers are left (beyond 1e308); reduce its scale or translation");
        nodes.push_back({index, names.unique(nameOfNode(model, index)), worldFromNode});
        const std::vector<int>& children = model.nodes[index].children;
        for (std::size_t i = children.size(); i-- > 0;)
            open.emplace_back(nodeIndex(children[i]), worldFromNode);
    }
    return nodes;
}

} // namespace shadowlab::scene
