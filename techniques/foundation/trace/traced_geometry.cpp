// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/traced_geometry.h"

#include <mutex>
#include <utility>

namespace shadowlab::trace {

namespace {

/// A weak reference to the last shared geometry: it does not keep it alive.
struct Shelf {
    std::mutex mutex;
    std::weak_ptr<const TracedGeometry> last;
};

Shelf& shelf() {
    static Shelf shelf;
    return shelf;
}

} // namespace

TracedGeometry::Revisions revisionsOf(const scene::Scene& scene) {
    return {scene.revisions.geometry, scene.revisions.transforms};
}

std::shared_ptr<const TracedGeometry> sharedGeometry(const scene::Scene& scene) {
    const std::scoped_lock lock(shelf().mutex);
    std::shared_ptr<const TracedGeometry> last = shelf().last.lock();
    return last && last->revisions == revisionsOf(scene) ? last : nullptr;
}

std::shared_ptr<const TracedGeometry> share(std::shared_ptr<const TracedGeometry> geometry) {
    const std::scoped_lock lock(shelf().mutex);
    shelf().last = geometry;
    return geometry;
}

} // namespace shadowlab::trace
