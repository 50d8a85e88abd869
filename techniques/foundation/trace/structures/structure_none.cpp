// No structure: every ray tests every triangle, so the time grows with the number of triangles. But there is nothing to
// build and little that can be wrong, so all other structures are compared with it.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/ray_query.h"

namespace shadowlab::trace {

namespace {

class Unstructured final : public WalkingEngine<Unstructured> {
public:
    explicit Unstructured(const EngineInput& input)
        : WalkingEngine(input), all_(finiteTriangles(input.triangles, 0, input.triangles.size())) {}

    template <typename Query, typename Count>
    void visit(const Ray&, Query& query, Count count) const {
        for (const std::uint32_t primitive : all_) {
            count.triangles(1);
            query.tryTriangle(primitive);
            if (query.isAnswered()) return;
        }
    }

    [[nodiscard]] std::size_t bytes() const override { return all_.size() * sizeof(all_[0]); }

private:
    std::vector<std::uint32_t> all_;
};

} // namespace

std::vector<std::uint32_t> finiteTriangles(std::span<const Triangle> triangles, std::size_t first, std::size_t end) {
    const auto isFinite = [](const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
    std::vector<std::uint32_t> finite;
    finite.reserve(end - first);
    for (std::size_t i = first; i < end; ++i)
        if (isFinite(triangles[i].a) && isFinite(triangles[i].b) && isFinite(triangles[i].c))
            finite.push_back(static_cast<std::uint32_t>(i));
    return finite;
}

std::unique_ptr<Engine> makeUnstructured(const EngineInput& input) { return std::make_unique<Unstructured>(input); }

} // namespace shadowlab::trace
