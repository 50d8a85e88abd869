// What accelerates rays, behind one small interface, so that one engine can be held against another.
//
// Our own tree answers exactly, in double. Embree (Wald and others, "Embree: A Kernel Framework for Efficient CPU Ray
// Tracing", SIGGRAPH 2014) answers in float and is built in only where it is installed: a second opinion that shares no
// line with ours, and a measure of speed.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Triangles are whole to an engine; holes (holes.h) are the SceneTracer's.
class Engine {
public:
    virtual ~Engine() = default;
    /// The nearest hit; t, primitive, and the weights of the corners.
    [[nodiscard]] virtual RayHit closest(const Ray& ray) const = 0;
    /// Is there a hit before ray.farthest, of a triangle that may block (one flag each) and is not `except`?
    [[nodiscard]] virtual bool blocked(const Ray& ray, std::uint32_t except,
                                       std::span<const std::uint8_t> mayBlock) const = 0;
};

/// Our own tree.
std::unique_ptr<Engine> makeBvhEngine(std::vector<Triangle> triangles);

/// Embree, or nothing where the program was built without it.
std::unique_ptr<Engine> makeEmbreeEngine(const std::vector<Triangle>& triangles);

} // namespace shadowlab::trace
