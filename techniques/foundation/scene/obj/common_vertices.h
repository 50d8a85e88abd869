// The vertices of a thing, in one mesh or in pieces, that lie where most of them do: what a picture of it has to show.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/obj/outliers.h"

namespace shadowlab::scene {

class CommonVertices {
public:
    using Pieces = std::vector<std::shared_ptr<const Mesh>>;
    /// Of a file without outliers all are common.
    explicit CommonVertices(Pieces pieces) : pieces_(std::move(pieces)) {
        if (pieces_.front()->outlierCount == 0) return;
        std::vector<dvec3> all;
        for (const auto& piece : pieces_)
            for (const vec3& positionMesh : piece->positionsMesh)
                all.push_back(piece->originObject + dvec3(positionMesh));
        place_.emplace(all.size(), [&](std::size_t i) { return all[i]; });
    }
    /// `take(position in object space, position in mesh space)` for each.
    template <typename Take>
    void each(const Take& take) const {
        for (const auto& piece : pieces_)
            for (const vec3& positionMesh : piece->positionsMesh)
                if (const dvec3 positionObject = piece->originObject + dvec3(positionMesh); !place_ || !place_->isFar(positionObject))
                    take(positionObject, positionMesh);
    }
    /// The box around them.
    [[nodiscard]] Bounds bounds(const dmat4& worldFromObject) const {
        Bounds bounds;
        each([&](const dvec3& positionObject, const vec3&) { bounds.include(transformPoint(worldFromObject, positionObject)); });
        return bounds;
    }

private:
    Pieces pieces_;
    std::optional<CommonPlace> place_;
};

} // namespace shadowlab::scene
