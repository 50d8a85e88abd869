// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/alias_free_pass.h"

#include <algorithm>

#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/shadow_map/irregular/asked_samples.h"

namespace shadowlab::shadow_map {

namespace {

constexpr int kBlock = trace::SceneTracer::kBlock;

/// Six planes are shown as the six maps are: +x +y +z above -x -y -z.
struct PlaneSheet {
    ivec2 cells, cellSize; ///< square, as the light's own picture is
    PlaneSheet(std::size_t planes, ivec2 within)
        : cells(planes == 6 ? ivec2(3, 2) : ivec2(1)),
          cellSize(std::max(std::min(within.x / cells.x, within.y / cells.y), 1)) {}
    [[nodiscard]] ivec2 corner(int plane) const {
        return cells.x == 1 ? ivec2(0) : ivec2(plane / 2, plane % 2) * cellSize;
    }
};

/// The part of a plane in which all but the outermost samples lie: a horizon would make everything near tiny.
PlaneRect middleOf(std::vector<dvec2> places) {
    PlaneRect rect;
    if (places.empty()) return rect;
    const std::size_t cut = places.size() / 50;
    for (int axis = 0; axis < 2; ++axis) {
        const auto byAxis = [axis](const dvec2& place) { return place[axis]; };
        std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(cut), {}, byAxis);
        rect.lower[axis] = places[cut][axis];
        const std::size_t last = places.size() - 1 - cut;
        std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(last), {}, byAxis);
        rect.upper[axis] = std::max(places[last][axis], rect.lower[axis] + 1e-9);
    }
    return rect;
}

} // namespace

void AliasFreePass::beginFrame() {
    points_.clear();
    decided_.clear();
}

const std::vector<trace::SurfacePoint>& AliasFreePass::visiblePoints(Frame& frame) {
    if (!points_.empty()) return points_;
    const View& view = frame.view();
    const auto [corner, size] = drawnRegion(view);
    points_.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const trace::EyeRays rays = tracer_.eyeRays(view.camera, view.size);
    const auto rows = static_cast<std::size_t>((size.y + kBlock - 1) / kBlock);
    trace::parallelFor(rows, [&](std::size_t row) {
        trace::SurfacePoint block[kBlock * kBlock];
        const int y0 = static_cast<int>(row) * kBlock;
        for (int x0 = 0; x0 < size.x; x0 += kBlock) {
            const ivec2 blockSize = glm::min(ivec2(kBlock), size - ivec2(x0, y0));
            tracer_.eyePoints(rays, corner + ivec2(x0, y0), blockSize, dvec2(0.5), block);
            for (int y = 0; y < blockSize.y; ++y)
                std::copy_n(block + y * blockSize.x, blockSize.x,
                            points_.begin() + std::ptrdiff_t(y0 + y) * size.x + x0);
        }
    });
    return points_;
}

const gl::Texture2D& AliasFreePass::decide(Frame& frame, int light) {
    const auto [corner, size] = drawnRegion(frame.view());
    const std::vector<trace::SurfacePoint>& points = visiblePoints(frame);
    std::vector<trace::Visibility> answers(points.size());
    AliasFreeRecord record;
    aliasFreeVisibilities(tracer_, points, light, answers, &record);
    std::vector<std::uint8_t> bytes;
    for (const trace::Visibility answer : answers)
        bytes.push_back(answer == trace::Visibility::lit ? 255 : 0);
    gl::turnRowsOver(bytes, size);
    gl::Texture2D& texture = decided_[light] = gl::Texture2D(GL_R8, frame.view().size, "alias-free visibility");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, corner.x, frame.view().size.y - corner.y - size.y, size.x, size.y, GL_RED,
                    GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    frame.count("samples-asked", static_cast<double>(record.samples), static_cast<double>(points.size()), "points");
    frame.count("triangle-buckets", static_cast<double>(record.overlaps), 0, "pairs of triangle and bucket");
    return texture;
}

void AliasFreePass::publishSamples(Frame& frame, int light) {
    tracer_.advance(frame.snapshot(), Deadline::max()); // nothing is left to do, unless only the stage is asked for
    const std::vector<trace::SurfacePoint>& points = visiblePoints(frame);
    std::vector<trace::Visibility> answers(points.size());
    const Samples samples = findSamples({tracer_, points, light, answers, 0});
    std::vector<std::vector<dvec2>> places(samples.planes.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (samples.planeOf[i] != kNotAsked) places[samples.planeOf[i]].emplace_back(samples.places[i]);
    const PlaneSheet sheet(places.size(), frame.view().size);
    const ivec2 size = sheet.cells * sheet.cellSize;
    std::vector<vec4> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), vec4(0, 0, 0, 1));
    for (std::size_t p = 0; p < places.size(); ++p) {
        PlaneRect rect = middleOf(places[p]);
        const dvec2 extent = rect.upper - rect.lower, side(std::max(extent.x, extent.y));
        rect = {rect.lower - 0.5 * (side - extent), rect.upper + 0.5 * (side - extent)};
        for (const dvec2& place : places[p]) {
            const dvec2 share = (place - rect.lower) / (rect.upper - rect.lower);
            if (glm::any(glm::lessThan(share, dvec2(0))) || glm::any(glm::greaterThanEqual(share, dvec2(1)))) continue;
            const ivec2 pixel = sheet.corner(static_cast<int>(p)) + ivec2(share * dvec2(sheet.cellSize));
            vec4& texel = texels[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
                                 static_cast<std::size_t>(pixel.x)];
            texel.r += 1;
            texel.g = 1;
        }
    }
    std::vector<float> counts;
    for (const vec4& texel : texels)
        if (texel.g > 0) counts.push_back(texel.r);
    Display display{
        .minimum = 0, .maximum = 1, .unit = "visible points in each pixel of the light's picture", .key = {}};
    if (!counts.empty()) {
        const auto most = counts.end() - 1 - static_cast<std::ptrdiff_t>(counts.size() / 50);
        std::ranges::nth_element(counts, most);
        display.maximum = std::max(2.0f, *most);
    }
    gl::Texture2D texture(GL_RG32F, size, "eye-samples");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
    frame.publish("eye-samples", light, std::move(texture), display);
}

} // namespace shadowlab::shadow_map
