// The triangles of a glTF mesh: its primitives' corners, whatever way they are strung together.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/foundation/scene/gltf/gltf_accessors.h"
#include "techniques/foundation/scene/gltf/gltf_materials.h"

namespace shadowlab::scene {

/// What a checked file is made of.
struct GltfParts {
    GltfSource& source;
    const tinygltf::Model& model;
    const GltfBuffers& buffers;
    const std::vector<GltfMaterial>& materials;
};

/// One primitive that has triangles, with the attributes that are read of it.
class GltfPrimitive {
public:
    /// Those of a mesh. Left out, and noted, are those without triangles: points, lines, and those that have no positions. Throws Error
    /// (badInput) where attributes are of another type than they should be, or fewer than the positions.
    static std::vector<GltfPrimitive> ofMesh(const GltfParts& parts, std::size_t mesh);

    [[nodiscard]] std::uint64_t triangleCount() const;
    /// Vertices of a triangle. Throws Error (badInput) for an index beyond the vertices.
    [[nodiscard]] std::array<std::size_t, 3> triangle(std::uint64_t index) const;

    [[nodiscard]] dvec3 position(std::size_t vertex) const; ///< throws Error (badInput) for what is no place
    [[nodiscard]] dvec3 normal(std::size_t vertex) const;   ///< zero: none
    [[nodiscard]] vec2 texcoord(std::size_t vertex) const;  ///< counted from the lower edge of the image
    [[nodiscard]] vec3 color(std::size_t vertex) const;     ///< white: none
    [[nodiscard]] bool hasTexcoords() const { return texcoords_.has_value(); }
    [[nodiscard]] bool hasColors() const { return colors_.has_value(); }
    [[nodiscard]] int material() const { return material_; } ///< -1: none

    /// Notes how many of the values that were asked for are not what they should be.
    void noteOddities() const;

private:
    GltfPrimitive(const GltfParts& parts, std::size_t mesh, std::size_t primitive);
    static bool hasTriangles(const GltfParts& parts, std::size_t mesh, std::size_t primitive);
    [[noreturn]] void fail(const std::string& message) const;
    [[nodiscard]] std::optional<GltfAccessor> attribute(const std::string& name, int fewest, int most) const;
    [[nodiscard]] std::size_t vertexAt(std::uint64_t corner) const;

    const GltfParts* parts_;
    std::size_t mesh_, primitive_;
    int mode_, material_;
    std::optional<GltfAccessor> positions_, normals_, texcoords_, colors_, indices_;
    mutable std::uint64_t badNormals_ = 0, badTexcoords_ = 0, transparentColors_ = 0;
};

} // namespace shadowlab::scene
