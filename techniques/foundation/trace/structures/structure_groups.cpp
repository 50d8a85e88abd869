// Bounding volumes of groups of objects, of which the objects have their own: a ray that misses a group misses all its
// objects. Two levels, and the square root of the number of objects in each: with n objects a ray tests about 2 sqrt(n)
// boxes in place of n. Do the same with the groups, and with groups of groups, and it is a tree (Rubin and Whitted, "A
// 3-Dimensional Representation for Fast Rendering of Complex Scenes", SIGGRAPH 1980).
//
// Grouping: the set of objects is halved across its longest side, again and again, until the parts are small enough.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/ray_query.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::trace {

namespace {

int longestAxis(const Box& box) {
    const dvec3 extent = box.upperCentred - box.lowerCentred;
    return extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
}

class Groups final : public WalkingEngine<Groups> {
public:
    explicit Groups(const EngineInput& input) : WalkingEngine(input) {
        for (std::size_t i = 0; i < input.firstOfObject.size(); ++i) {
            const bool isLast = i + 1 == input.firstOfObject.size();
            const std::size_t end = isLast ? input.triangles.size() : input.firstOfObject[i + 1];
            Bounded object{{}, finiteTriangles(input.triangles, input.firstOfObject[i], end)};
            for (const std::uint32_t p : object.triangles)
                object.box.include(input.triangles[p]);
            if (!object.box.isEmpty()) objects_.push_back(std::move(object));
        }
        const auto most = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(objects_.size()))));
        std::vector<Group> open;
        if (!objects_.empty()) open.push_back({{}, 0, objects_.size()});
        while (!open.empty()) {
            const Group group = open.back();
            open.pop_back();
            if (group.count <= most) {
                groups_.push_back(boxed(group));
                continue;
            }
            const std::size_t half = halve(group);
            open.push_back({{}, group.first, half});
            open.push_back({{}, group.first + half, group.count - half});
        }
    }

    template <typename Query, typename Count>
    void visit(const Ray&, Query& query, Count count) const {
        const VolumeRay ray(query.sheared);
        for (const Group& group : groups_) {
            count.volumes(1);
            if (ray.enter(group.box, query.farthest()) == kNowhere) continue;
            count.step();
            for (std::size_t i = group.first; i < group.first + group.count; ++i) {
                count.volumes(1);
                if (ray.enter(objects_[i].box, query.farthest()) == kNowhere) continue;
                count.step();
                for (const std::uint32_t primitive : objects_[i].triangles) {
                    count.triangles(1);
                    query.tryTriangle(primitive);
                    if (query.isAnswered()) return;
                }
            }
        }
    }

    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = groups_.size() * sizeof(Group);
        for (const Bounded& object : objects_)
            sum += sizeof(object) + object.triangles.size() * sizeof(object.triangles[0]);
        return sum;
    }
    [[nodiscard]] std::vector<StructurePart> parts(std::size_t most) const override {
        std::vector<StructurePart> parts;
        for (const Group& group : groups_)
            parts.push_back({false, 0, group.box.lowerCentred, group.box.upperCentred, {}, 0});
        for (std::size_t g = 0; g < groups_.size() && objects_.size() <= most; ++g)
            for (std::size_t i = groups_[g].first; i < groups_[g].first + groups_[g].count; ++i)
                parts.push_back({.level = 1,
                                 .lowerCentred = objects_[i].box.lowerCentred,
                                 .upperCentred = objects_[i].box.upperCentred,
                                 .parent = static_cast<int>(g),
                                 .primitives = {objects_[i].triangles.front()}});
        return parts;
    }

private:
    struct Bounded {
        Box box;
        std::vector<std::uint32_t> triangles;
    };
    struct Group {
        Box box;
        std::size_t first, count; ///< of the objects
    };

    [[nodiscard]] Group boxed(Group group) const {
        for (std::size_t i = group.first; i < group.first + group.count; ++i)
            group.box.include(objects_[i].box);
        return group;
    }

    /// Sorts the group's objects so that the first half of them lies on one side; returns how many that are.
    std::size_t halve(const Group& group) {
        Box centres;
        const auto begin = objects_.begin() + static_cast<std::ptrdiff_t>(group.first);
        const auto end = begin + static_cast<std::ptrdiff_t>(group.count), middle = begin + (end - begin) / 2;
        for (auto object = begin; object != end; ++object)
            centres.include(object->box.centre());
        const int axis = longestAxis(centres);
        std::nth_element(begin, middle, end, [axis](const Bounded& a, const Bounded& b) {
            return std::pair(a.box.centre()[axis], a.triangles[0]) < std::pair(b.box.centre()[axis], b.triangles[0]);
        });
        return group.count / 2;
    }

    std::vector<Bounded> objects_; ///< those of a group one after the other
    std::vector<Group> groups_;
};

} // namespace

std::unique_ptr<Engine> makeGroups(const EngineInput& input) { return std::make_unique<Groups>(input); }

} // namespace shadowlab::trace
