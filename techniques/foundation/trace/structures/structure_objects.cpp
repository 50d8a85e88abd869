// A bounding volume around each object: a ray that misses the volume misses all that is in it (Whitted, 1980, who took
// spheres, "because of the simplicity of representation and the ease of performing an intersection calculation").
//
// A sphere is quicker to test, a box most often tighter. Either way a ray that touches the volume still tries every
// triangle of the object: it helps with many small objects, not with one large one.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/ray_query.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::trace {

namespace {

void bound(Ball& ball, std::span<const Triangle> triangles, std::span<const std::uint32_t> primitives) {
    ball = ballAround(triangles, primitives);
}
void bound(Box& box, std::span<const Triangle> triangles, std::span<const std::uint32_t> primitives) {
    for (const std::uint32_t p : primitives)
        box.include(triangles[p]);
}

StructurePart partOf(const Ball& ball) { return {true, 0, {}, {}, ball.centreCentred, ball.radius}; }
StructurePart partOf(const Box& box) { return {false, 0, box.lowerCentred, box.upperCentred, {}, 0}; }

template <typename Volume>
class ObjectVolumes final : public WalkingEngine<ObjectVolumes<Volume>> {
public:
    explicit ObjectVolumes(const EngineInput& input) : WalkingEngine<ObjectVolumes>(input) {
        for (std::size_t i = 0; i < input.firstOfObject.size(); ++i) {
            const bool isLast = i + 1 == input.firstOfObject.size();
            const std::size_t end = isLast ? input.triangles.size() : input.firstOfObject[i + 1];
            Bounded object{{}, finiteTriangles(input.triangles, input.firstOfObject[i], end)};
            if (object.triangles.empty()) continue;
            bound(object.volume, input.triangles, object.triangles);
            objects_.push_back(std::move(object));
        }
    }

    template <typename Query, typename Count>
    void visit(const Ray&, Query& query, Count count) const {
        const VolumeRay ray(query.sheared);
        for (const Bounded& object : objects_) {
            count.volumes(1);
            if (ray.enter(object.volume, query.farthest()) == kNowhere) continue;
            count.step();
            for (const std::uint32_t primitive : object.triangles) {
                count.triangles(1);
                query.tryTriangle(primitive);
                if (query.isAnswered()) return;
            }
        }
    }

    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Bounded& object : objects_)
            sum += sizeof(object) + object.triangles.size() * sizeof(object.triangles[0]);
        return sum;
    }
    [[nodiscard]] std::vector<StructurePart> parts(std::size_t most) const override {
        std::vector<StructurePart> parts;
        for (std::size_t i = 0; i < std::min(most, objects_.size()); ++i) {
            parts.push_back(partOf(objects_[i].volume));
            parts.back().primitives = {objects_[i].triangles.front()};
        }
        return parts;
    }

private:
    struct Bounded {
        Volume volume;
        std::vector<std::uint32_t> triangles;
    };
    std::vector<Bounded> objects_;
};

} // namespace

std::unique_ptr<Engine> makeObjectSpheres(const EngineInput& input) {
    return std::make_unique<ObjectVolumes<Ball>>(input);
}
std::unique_ptr<Engine> makeObjectBoxes(const EngineInput& input) {
    return std::make_unique<ObjectVolumes<Box>>(input);
}

} // namespace shadowlab::trace
