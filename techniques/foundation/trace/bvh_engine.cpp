// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/bvh_build.h"
#include "techniques/foundation/trace/bvh_traverse.h"
#include "techniques/foundation/trace/engine.h"

namespace shadowlab::trace {

namespace {

class BvhEngine final : public Engine {
public:
    explicit BvhEngine(std::vector<Triangle> triangles) : bvh_(buildBvh(std::move(triangles))) {}
    [[nodiscard]] RayHit closest(const Ray& ray) const override { return bvh_.closest(ray); }
    [[nodiscard]] bool blocked(const Ray& ray, std::uint32_t except,
                               std::span<const std::uint8_t> mayBlock) const override {
        return bvh_.any(ray, [&](std::uint32_t p) { return p != except && mayBlock[p]; }) != kNoPrimitive;
    }

private:
    Bvh bvh_;
};

} // namespace

std::unique_ptr<Engine> makeBvhEngine(std::vector<Triangle> triangles) {
    return std::make_unique<BvhEngine>(std::move(triangles));
}

} // namespace shadowlab::trace
