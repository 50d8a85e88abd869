// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/object_pieces.h"

namespace shadowlab::scene {

ObjectRange piecesOf(const Scene& scene, std::size_t object) {
    ObjectRange range{object, object + 1};
    while (range.first > 0 && scene.objects[range.first].isFurtherPiece)
        --range.first;
    while (range.end < scene.objects.size() && scene.objects[range.end].isFurtherPiece)
        ++range.end;
    return range;
}

} // namespace shadowlab::scene
