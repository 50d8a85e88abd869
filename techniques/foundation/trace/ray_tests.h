// What a ray had to try. Counting is a template's argument, so that a ray nobody counts does not pay for it.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace shadowlab::trace {

struct RayTests {
    std::uint64_t volumes = 0;   ///< bounding volumes
    std::uint64_t triangles = 0; ///< a triangle tried twice counts twice
    std::uint64_t steps = 0;     ///< nodes or cells looked into
    [[nodiscard]] std::uint64_t all() const { return volumes + triangles; }
};

struct CountNothing {
    void volumes(std::uint64_t) const {}
    void triangles(std::uint64_t) const {}
    void steps(std::uint64_t) const {}
    void step() const {}
};

struct CountTests {
    RayTests& tests;
    void volumes(std::uint64_t count) const { tests.volumes += count; }
    void triangles(std::uint64_t count) const { tests.triangles += count; }
    void steps(std::uint64_t count) const { tests.steps += count; }
    void step() const { ++tests.steps; }
};

} // namespace shadowlab::trace
