// The tree of this program (bvh.h) as one of the structures.
// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/structures/engine.h"

namespace shadowlab::trace {

namespace {

class BvhEngine final : public Engine {
public:
    explicit BvhEngine(const Bvh& bvh) : bvh_(&bvh) {}
    explicit BvhEngine(const EngineInput& input) : builder_(BvhBuilder::over(input.triangles)) {}

    bool advance(Deadline deadline) override {
        if (!builder_) return true;
        if (!builder_->advance(deadline)) return false;
        own_ = builder_->take();
        builder_.reset();
        return true;
    }
    [[nodiscard]] double done() const override { return builder_ ? builder_->done() : 1.0; }

    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit) const override {
        return bvh_->closest(ray, mayHit, HoleOf{mayHit});
    }
    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit, RayTests& tests) const override {
        return bvh_->closest(ray, mayHit, HoleOf{mayHit}, CountTests{tests});
    }
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit) const override {
        return bvh_->any(ray, mayHit, HoleOf{mayHit});
    }
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit, RayTests& tests) const override {
        return bvh_->any(ray, mayHit, HoleOf{mayHit}, CountTests{tests});
    }

    [[nodiscard]] std::size_t bytes() const override {
        return bvh_->nodes.size() * sizeof(BvhNode) + bvh_->leaves.size() * sizeof(BvhLeaf);
    }
    [[nodiscard]] std::vector<StructurePart> parts(std::size_t most) const override;

private:
    struct HoleOf {
        const MayHit& mayHit;
        bool operator()(std::uint32_t primitive, const dvec3& barycentric) const {
            return mayHit.inHole(primitive, barycentric);
        }
    };
    Bvh own_;
    const Bvh* bvh_ = &own_;
    std::optional<BvhBuilder> builder_;
};

/// The boxes of the children, level by level; the box of the root is that of its children.
std::vector<StructurePart> BvhEngine::parts(std::size_t most) const {
    std::vector<StructurePart> parts;
    struct Open {
        std::uint32_t node;
        int parent;
    };
    std::vector<Open> level;
    if (!bvh_->nodes.empty()) level.push_back({0, -1});
    for (int depth = 0; !level.empty(); ++depth) {
        std::vector<Open> below;
        std::vector<StructurePart> boxes;
        for (const auto& [index, parent] : level) {
            const BvhNode& node = bvh_->nodes[index];
            for (int i = 0; i < node.count; ++i) {
                StructurePart box{.level = depth, .parent = parent};
                for (int axis = 0; axis < 3; ++axis) {
                    box.lowerCentred[axis] = node.planes[axis][0][i];
                    box.upperCentred[axis] = node.planes[axis][1][i];
                }
                const int place = static_cast<int>(parts.size() + boxes.size());
                boxes.push_back(box);
                if (const BvhChild child(node.children[i]); !child.isLeaf()) below.push_back({child.index(), place});
            }
        }
        if (boxes.size() > most) break;
        parts.insert(parts.end(), boxes.begin(), boxes.end());
        level = std::move(below);
    }
    return parts;
}

} // namespace

std::unique_ptr<Engine> makeBvhEngine(const Bvh& bvh) { return std::make_unique<BvhEngine>(bvh); }
std::unique_ptr<Engine> makeBvhEngine(const EngineInput& input) { return std::make_unique<BvhEngine>(input); }

} // namespace shadowlab::trace
