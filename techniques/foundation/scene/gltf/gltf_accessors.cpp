// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_accessors.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

static_assert(std::endian::native == std::endian::little, "glTF stores numbers little-endian; elsewhere bytes would have to be swapped");

namespace {

template <typename Number>
double numberAt(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number); // it may lie at any address
    return static_cast<double>(number);
}

double componentAt(const char* bytes, int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return numberAt<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return numberAt<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return numberAt<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return numberAt<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return numberAt<std::uint32_t>(bytes);
    default: return numberAt<float>(bytes);
    }
}

/// What stands for 1; 0 for floats.
double largestOf(int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 65535;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return 4294967295.0;
    default: return 0;
    }
}

std::size_t componentsOf(const tinygltf::Accessor& accessor) {
    return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

/// The part of the buffers that a view is.
std::string_view bytesOfView(const tinygltf::Model& model, const GltfBuffers& buffers, int view) {
    const tinygltf::BufferView& found = model.bufferViews[static_cast<std::size_t>(view)];
    return buffers.bytes(static_cast<std::size_t>(found.buffer)).substr(found.byteOffset, found.byteLength);
}

/// Do `count` elements fit, `stride` apart, from `offset` on? All numbers are at most 2^53, so that double holds them.
bool fits(std::size_t offset, std::size_t count, std::size_t stride, std::size_t elementBytes, std::size_t available) {
    const double last = static_cast<double>(offset) + static_cast<double>(count - 1) * static_cast<double>(stride);
    return last + static_cast<double>(elementBytes) <= static_cast<double>(available);
}

std::string doesNotFit(const char* what, std::size_t count, std::size_t elementBytes, std::size_t offset, int view,
                       std::size_t available) {
    return std::string("has ") + what + "s that reach beyond their buffer view: " + counted(count, what) + " of " +
           counted(elementBytes, "byte") + " from byte " + std::to_string(offset) + " of bufferViews[" + std::to_string(view) +
           "], which has " + std::to_string(available) + "; export the model again";
}

void checkSparse(const GltfSource& source, const tinygltf::Model& model, const GltfBuffers& buffers, std::size_t index,
                 std::size_t elementBytes) {
    const tinygltf::Accessor& accessor = model.accessors[index];
    // Here as the JSON has them; tinygltf keeps them in int.
    const JsonValue& sparse = *gltfMember(source.elements("accessors")[index], "sparse");
    const auto offsetIn = [&](const char* key) {
        const JsonValue* offset = gltfMember(*gltfMember(sparse, key), "byteOffset");
        return offset ? offset->number : 0;
    };
    const double count = gltfMember(sparse, "count")->number;
    if (count > static_cast<double>(accessor.count))
        source.fail("accessors", index,
                    "has " + numberText(count) + " sparse elements, more than the " + std::to_string(accessor.count) +
                        " it has in all; export the model again");
    const std::size_t indexBytes = bytesOfComponent(accessor.sparse.indices.componentType);
    const auto check = [&](int view, double offset, std::size_t bytes, const char* what) {
        const std::size_t available = bytesOfView(model, buffers, view).size();
        if (offset > std::min(static_cast<double>(available), 2147483647.0) || // tinygltf keeps it in an int
            !fits(static_cast<std::size_t>(offset), static_cast<std::size_t>(count), bytes, bytes, available))
            source.fail("accessors", index,
                        doesNotFit(what, static_cast<std::size_t>(count), bytes, static_cast<std::size_t>(offset), view, available));
    };
    check(accessor.sparse.indices.bufferView, offsetIn("indices"), indexBytes, "sparse index");
    check(accessor.sparse.values.bufferView, offsetIn("values"), elementBytes, "sparse value");
    const std::string_view indices =
        bytesOfView(model, buffers, accessor.sparse.indices.bufferView).substr(static_cast<std::size_t>(offsetIn("indices")));
    double before = -1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double at = componentAt(indices.data() + i * indexBytes, accessor.sparse.indices.componentType);
        if (at <= before || at >= static_cast<double>(accessor.count))
            source.fail("accessors", index,
                        "has the sparse index " + numberText(at) + (i > 0 ? " after " + numberText(before) : "") +
                            "; they must rise and be less than its count, " + std::to_string(accessor.count) +
                            "; export the model again");
        before = at;
    }
}

} // namespace

std::size_t bytesOfComponent(int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    default: return 4;
    }
}

void checkGltfAccessors(const GltfSource& source, const tinygltf::Model& model, const GltfBuffers& buffers) {
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = model.bufferViews[i];
        const std::size_t available = buffers.bytes(static_cast<std::size_t>(view.buffer)).size();
        if (view.byteOffset > available || view.byteLength > available - view.byteOffset)
            source.fail("bufferViews", i,
                        "reaches beyond its buffer: " + counted(view.byteLength, "byte") + " from byte " +
                            std::to_string(view.byteOffset) + " of buffers[" + std::to_string(view.buffer) + "], which has " +
                            std::to_string(available) + "; export the model again");
    }
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const tinygltf::Accessor& accessor = model.accessors[i];
        const std::size_t elementBytes = componentsOf(accessor) * bytesOfComponent(accessor.componentType);
        if (accessor.bufferView >= 0) {
            const std::size_t available = bytesOfView(model, buffers, accessor.bufferView).size();
            const std::size_t given = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
            if (given > 0 && given < elementBytes)
                source.fail("accessors", i,
                            "has elements of " + counted(elementBytes, "byte") + ", but they lie only " + std::to_string(given) +
                                " apart (byteStride of bufferViews[" + std::to_string(accessor.bufferView) +
                                "]); export the model again");
            if (!fits(accessor.byteOffset, accessor.count, given > 0 ? given : elementBytes, elementBytes, available))
                source.fail("accessors", i,
                            doesNotFit("element", accessor.count, elementBytes, accessor.byteOffset, accessor.bufferView, available));
        }
        if (accessor.sparse.isSparse) checkSparse(source, model, buffers, i, elementBytes);
    }
}

GltfAccessor::GltfAccessor(const tinygltf::Model& model, const GltfBuffers& buffers, int accessor)
    : accessor_(&model.accessors[static_cast<std::size_t>(accessor)]), components_(static_cast<int>(componentsOf(*accessor_))),
      componentBytes_(bytesOfComponent(accessor_->componentType)), stride_(componentsOf(*accessor_) * componentBytes_) {
    const auto from = [&](int view, std::size_t offset) { return bytesOfView(model, buffers, view).substr(offset); };
    if (accessor_->sparse.isSparse) {
        sparseIndices_ = from(accessor_->sparse.indices.bufferView, static_cast<std::size_t>(accessor_->sparse.indices.byteOffset));
        sparseValues_ = from(accessor_->sparse.values.bufferView, static_cast<std::size_t>(accessor_->sparse.values.byteOffset));
    }
    if (accessor_->bufferView < 0) return;
    bytes_ = from(accessor_->bufferView, accessor_->byteOffset);
    if (const std::size_t given = model.bufferViews[static_cast<std::size_t>(accessor_->bufferView)].byteStride; given > 0)
        stride_ = given;
}

const char* GltfAccessor::elementAt(std::size_t element) const {
    if (accessor_->sparse.isSparse) {
        const int type = accessor_->sparse.indices.componentType;
        const std::size_t indexBytes = bytesOfComponent(type);
        std::size_t low = 0, high = static_cast<std::size_t>(accessor_->sparse.count);
        while (low < high) { // the first that is not less
            const std::size_t middle = (low + high) / 2;
            if (componentAt(sparseIndices_.data() + middle * indexBytes, type) < static_cast<double>(element))
                low = middle + 1;
            else
                high = middle;
        }
        if (low < static_cast<std::size_t>(accessor_->sparse.count) &&
            componentAt(sparseIndices_.data() + low * indexBytes, type) == static_cast<double>(element))
            return sparseValues_.data() + low * static_cast<std::size_t>(components_) * componentBytes_;
    }
    return bytes_.empty() ? nullptr : bytes_.data() + element * stride_;
}

double GltfAccessor::at(std::size_t element, int component, bool asShares) const {
    const char* bytes = elementAt(element);
    if (!bytes) return 0;
    const double value = componentAt(bytes + static_cast<std::size_t>(component) * componentBytes_, accessor_->componentType);
    const double largest = accessor_->normalized || asShares ? largestOf(accessor_->componentType) : 0;
    return largest > 0 ? std::max(value / largest, -1.0) : value;
}

} // namespace shadowlab::scene
