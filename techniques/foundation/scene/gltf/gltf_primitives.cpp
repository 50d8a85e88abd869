// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_primitives.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

const tinygltf::Primitive& given(const GltfParts& parts, std::size_t mesh, std::size_t primitive) {
    return parts.model.meshes[mesh].primitives[primitive];
}

std::string typeName(int components) { return components == 1 ? "SCALAR" : "VEC" + std::to_string(components); }

} // namespace

bool GltfPrimitive::hasTriangles(const GltfParts& parts, std::size_t mesh, std::size_t primitive) {
    const tinygltf::Primitive& from = given(parts, mesh, primitive);
    const auto leftOut = [&](const std::string& why) {
        parts.source.note("meshes", mesh, why);
        return false;
    };
    if (from.mode == TINYGLTF_MODE_POINTS) return leftOut("points have no surface; they are left out");
    if (from.mode < TINYGLTF_MODE_TRIANGLES) return leftOut("lines have no surface; they are left out");
    if (!from.attributes.contains("POSITION")) return leftOut("a primitive has no POSITION; it is left out");
    const GltfMaterial* material = from.material < 0 ? nullptr : &parts.materials[static_cast<std::size_t>(from.material)];
    const std::string used = "TEXCOORD_" + std::to_string(material ? material->texcoordSet : 0);
    for (const auto& [name, accessor] : from.attributes) // TEXCOORD_0 is there more often than an image; no word about that
        if ((name.starts_with("COLOR_") && name != "COLOR_0") || (name.starts_with("TEXCOORD_") && name != used && name != "TEXCOORD_0"))
            parts.source.note("meshes", mesh, "further colours or texture coordinates (" + shown(name) + ") are left out");
    return !material || !material->isInvisible; // which was noted
}

std::vector<GltfPrimitive> GltfPrimitive::ofMesh(const GltfParts& parts, std::size_t mesh) {
    std::vector<GltfPrimitive> primitives;
    for (std::size_t i = 0; i < parts.model.meshes[mesh].primitives.size(); ++i) {
        if (!hasTriangles(parts, mesh, i)) continue;
        GltfPrimitive primitive(parts, mesh, i);
        if (primitive.triangleCount() > 0)
            primitives.push_back(std::move(primitive));
        else
            parts.source.note("meshes", mesh, "a primitive has fewer corners than a triangle; it is left out");
    }
    return primitives;
}

GltfPrimitive::GltfPrimitive(const GltfParts& parts, std::size_t mesh, std::size_t primitive)
    : parts_(&parts), mesh_(mesh), primitive_(primitive), mode_(given(parts, mesh, primitive).mode),
      material_(given(parts, mesh, primitive).material) {
    positions_ = attribute("POSITION", 3, 3);
    normals_ = attribute("NORMAL", 3, 3);
    colors_ = attribute("COLOR_0", 3, 4);
    if (material_ >= 0) {
        const GltfMaterial& material = parts.materials[static_cast<std::size_t>(material_)];
        texcoords_ = attribute("TEXCOORD_" + std::to_string(material.texcoordSet), 2, 2);
        if (!texcoords_ && (material.material.colorImage || material.material.alphaMask))
            parts.source.note("meshes", mesh,
                              "a primitive has no texture coordinates for the image of its material, which is not laid on it");
    }
    const int indices = given(parts, mesh, primitive).indices;
    if (indices < 0) return;
    indices_.emplace(parts.model, parts.buffers, indices);
    if (indices_->components() != 1 || (indices_->componentType() != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                        indices_->componentType() != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                        indices_->componentType() != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT))
        fail("has indices that are no unsigned whole numbers (accessors[" + std::to_string(indices) +
             "]); they must be SCALAR of component type 5121, 5123 or 5125");
}

void GltfPrimitive::fail(const std::string& message) const {
    const JsonValue& place = gltfMember(parts_->source.elements("meshes")[mesh_], "primitives")->items[primitive_];
    parts_->source.document().fail(place.offset,
                                   gltfElementName("meshes", mesh_) + "." + gltfElementName("primitives", primitive_) + " " + message);
}

std::optional<GltfAccessor> GltfPrimitive::attribute(const std::string& name, int fewest, int most) const {
    const auto& attributes = given(*parts_, mesh_, primitive_).attributes;
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::nullopt;
    const GltfAccessor accessor(parts_->model, parts_->buffers, found->second);
    const std::string named = "has a " + name + " (accessors[" + std::to_string(found->second) + "]) ";
    const int type = parts_->model.accessors[static_cast<std::size_t>(found->second)].type;
    if (type < fewest || type > most) // VEC2 to VEC4 are 2 to 4; matrices and scalars are larger
        fail(named + "that is no " + typeName(fewest) + (most > fewest ? " or " + typeName(most) : "") + "; export the model again");
    if (positions_ && accessor.count() < positions_->count())
        fail(named + "with fewer elements, " + std::to_string(accessor.count()) + ", than the " + std::to_string(positions_->count()) +
             " positions; export the model again");
    return accessor;
}

std::uint64_t GltfPrimitive::triangleCount() const {
    const std::uint64_t corners = indices_ ? indices_->count() : positions_->count();
    return mode_ == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

std::size_t GltfPrimitive::vertexAt(std::uint64_t corner) const {
    if (!indices_) return corner;
    const auto vertex = static_cast<std::size_t>(indices_->at(corner, 0));
    if (vertex >= positions_->count())
        fail("has the index " + std::to_string(vertex) + " (number " + std::to_string(corner) + " of accessors[" +
             std::to_string(given(*parts_, mesh_, primitive_).indices) + "]), but its POSITION has only " +
             std::to_string(positions_->count()) + ", counted from 0; export the model again");
    return vertex;
}

std::array<std::size_t, 3> GltfPrimitive::triangle(std::uint64_t index) const {
    if (mode_ == TINYGLTF_MODE_TRIANGLES) return {vertexAt(3 * index), vertexAt(3 * index + 1), vertexAt(3 * index + 2)};
    if (mode_ == TINYGLTF_MODE_TRIANGLE_FAN) return {vertexAt(index + 1), vertexAt(index + 2), vertexAt(0)};
    // Every second triangle of a strip runs the other way round.
    const std::uint64_t odd = index % 2;
    return {vertexAt(index), vertexAt(index + 1 + odd), vertexAt(index + 2 - odd)};
}

dvec3 GltfPrimitive::position(std::size_t vertex) const {
    const dvec3 position(positions_->at(vertex, 0), positions_->at(vertex, 1), positions_->at(vertex, 2));
    const dvec3 size = glm::abs(position);
    const double limit = Limits{}.coordinate;
    if (!(size.x <= limit && size.y <= limit && size.z <= limit))
        fail("has the position " + numberText(position.x) + " " + numberText(position.y) + " " + numberText(position.z) + " (number " +
             std::to_string(vertex) + " of its POSITION); coordinates must be numbers up to " + numberText(limit) +
             ": export the model again");
    return position;
}

dvec3 GltfPrimitive::normal(std::size_t vertex) const {
    if (!normals_) return dvec3(0.0);
    const dvec3 normal(normals_->at(vertex, 0), normals_->at(vertex, 1), normals_->at(vertex, 2));
    const double length = glm::length(normal);
    if (length > 0 && std::isfinite(length)) return normal / length;
    ++badNormals_;
    return dvec3(0.0);
}

vec2 GltfPrimitive::texcoord(std::size_t vertex) const {
    if (!texcoords_) return vec2(0.0f);
    const dvec2 place(texcoords_->at(vertex, 0), 1.0 - texcoords_->at(vertex, 1));
    if (std::isfinite(place.x) && std::isfinite(place.y)) return vec2(place) + vec2(0.0f);
    ++badTexcoords_;
    return vec2(0.0f);
}

vec3 GltfPrimitive::color(std::size_t vertex) const {
    if (!colors_) return vec3(1.0f);
    vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) {
        const double share = colors_->at(vertex, i, true);
        color[i] = std::isfinite(share) ? static_cast<float>(std::clamp(share, 0.0, 1.0)) : 1.0f;
    }
    if (colors_->components() == 4 && colors_->at(vertex, 3, true) < 1) ++transparentColors_;
    return color + vec3(0.0f);
}

void GltfPrimitive::noteOddities() const {
    const auto note = [&](const char* what, std::uint64_t times) {
        if (times > 0) parts_->source.note("meshes", mesh_, what, times);
    };
    note("a normal without a direction: the flat one of its triangle is used", badNormals_);
    note("a texture coordinate that is no number: 0 is taken", badTexcoords_);
    note("the alpha of a vertex's colour is left out", transparentColors_);
}

} // namespace shadowlab::scene
