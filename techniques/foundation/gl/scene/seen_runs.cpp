// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/seen_runs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace shadowlab::gl {

namespace {

// What the rounding of two planes in float makes, in units of the depth buffer, is four at most; twice that.
constexpr double kLayerUnits = 8;

// Of two triangles with the same corners the depths are rounded apart by two units at most; twice that.
constexpr float kTwinUnits = 4;

// Bits of the depth buffer (IdBuffer, Target), and how much farther apart than their gap two layers are to be for certain.
constexpr int kDepthBits = 24;
constexpr double kGaps = 2;

// A software renderer compiles a program of its own for each pair of offsets. A step that followed the camera exactly would make it do so for
// every object in every frame, half of the frame. So steps are rounded up to the next of a few.
constexpr double kStepsPerOctave = 2;

float roundedUp(double step) { return static_cast<float>(std::exp2(std::ceil(kStepsPerOctave * std::log2(step)) / kStepsPerOctave)); }

bool isOrdinary(const scene::SeenSide& side) { return side == scene::SeenSide{}; }

/// The sides of one triangle; ordinary ones where it is not among them.
scene::SeenSides sidesOf(const std::vector<scene::SeenSides>& sides, std::uint32_t triangle) {
    const auto found = std::ranges::lower_bound(sides, triangle, {}, &scene::SeenSides::triangle);
    if (found != sides.end() && found->triangle == triangle) return *found;
    scene::SeenSides ordinary;
    ordinary.triangle = triangle;
    return ordinary;
}

} // namespace

LayerStep layerStep(double gap, double nearest, const dmat4& clipFromView) {
    // The rasteriser moves corners to a grid within pixels, those of two faces by up to half of its step each: one step. Twice that is
    // with the usual 256 steps half of what counts as a tie (docs/conventions.md).
    GLint subpixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    double slopes = 2.0 / (1 << subpixelBits), units = kLayerUnits;
    if (gap > 0) {
        // The depth is clipFromView[3][2] / (2 z) and a constant; a plane that goes away from the eye has gained in depth, after as many
        // pixels as its gap is wide at z, what the gap makes of it.
        GLint viewport[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        slopes += kGaps * gap / nearest * clipFromView[1][1] * viewport[3] / 2;
        units += kGaps * gap * std::abs(clipFromView[3][2]) / (2 * nearest * nearest) * (1 << kDepthBits);
    }
    return {roundedUp(slopes), roundedUp(units)};
}

SeenRuns seenRuns(const scene::Mesh& mesh, std::vector<scene::SeenSides> sides) {
    SeenRuns result;
    result.sides = std::move(sides);
    for (const scene::SeenSides& both : result.sides)
        result.gap = std::max(result.gap, both.gap);
    const auto look = [&](std::uint32_t triangle) {
        const scene::SeenSides both = sidesOf(result.sides, triangle);
        return std::tuple(!isOrdinary(both.front), both.front.isHidden, both.front.isWithin, both.front.layer, both.front.isTwin, both.back.isHidden,
                          both.back.layer, both.back.isTwin);
    };
    for (const scene::MeshPart& part : mesh.parts) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < part.triangleCount; ++i)
            order.push_back(part.firstTriangle + i);
        std::ranges::stable_sort(order, {}, look);
        std::vector<SeenRun>& runs = result.ofPart.emplace_back();
        for (const std::uint32_t triangle : order) {
            const scene::SeenSides both = sidesOf(result.sides, triangle);
            if (runs.empty() || runs.back().front != both.front || runs.back().back != both.back)
                runs.push_back({static_cast<std::uint32_t>(result.order.size()), 0, both.front, both.back});
            ++runs.back().count;
            result.order.push_back(triangle);
        }
    }
    return result;
}

void drawInLayers(std::span<const SeenRun> runs, const SeenObject& object,
                  const std::function<void(std::uint32_t, std::uint32_t)>& draw) {
    const bool culls = glIsEnabled(GL_CULL_FACE);
    // Those that are drawn as all others are stand together, where backs are culled with those whose back alone is out of the ordinary.
    std::size_t together = 0;
    std::uint32_t count = 0;
    for (; together < runs.size() && isOrdinary(runs[together].front) && (culls || isOrdinary(runs[together].back)); ++together)
        count += runs[together].count;
    if (count > 0) draw(runs.front().first, count);
    for (const SeenRun& run : runs.subspan(together))
        for (const bool isFront : {true, false}) {
            const scene::SeenSide& side = isFront ? run.front : run.back;
            if (side.isHidden || (culls && !isFront) || (side.isWithin && object.eyeIsOutside)) continue;
            glEnable(GL_CULL_FACE);
            glCullFace(isFront != object.mirrored ? GL_BACK : GL_FRONT); // of a mirrored object the rasteriser takes the back for the front
            if (side.layer != 0 || side.isTwin) {
                glEnable(GL_POLYGON_OFFSET_FILL);
                if (side.layer != 0)
                    glPolygonOffset(-side.layer * object.step.slopes, -side.layer * object.step.units);
                else
                    glPolygonOffset(0, -kTwinUnits);
            }
            draw(run.first, run.count);
            glDisable(GL_POLYGON_OFFSET_FILL);
        }
    if (!culls) glDisable(GL_CULL_FACE);
}

void drawInLayers(const SeenRuns& runs, std::uint32_t first, std::uint32_t count, const SeenObject& object,
                  const std::function<void(std::uint32_t, std::uint32_t)>& draw) {
    for (std::uint32_t triangle = first; triangle < first + count;) {
        const scene::SeenSides both = sidesOf(runs.sides, triangle);
        SeenRun run{triangle, 0, both.front, both.back};
        for (; triangle < first + count; ++triangle, ++run.count) {
            const scene::SeenSides next = sidesOf(runs.sides, triangle);
            if (next.front != run.front || next.back != run.back) break;
        }
        drawInLayers(std::span(&run, 1), object, draw);
    }
}

} // namespace shadowlab::gl
