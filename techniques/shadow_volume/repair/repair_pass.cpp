// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/repair/repair_pass.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::shadow_volume {

namespace {

/// The part of the picture that is drawn, without what is in it.
CountedPart countedPartOf(const View& view) {
    const auto [corner, size] = drawnRegion(view);
    CountedPart part;
    part.pictureSize = view.size;
    part.corner = corner;
    part.size = size;
    return part;
}

CountedPart readCount(const Frame& frame, const StencilRule& stencil) {
    // Depth and stencil of a pixel come as one word: 24 bits of depth, then the count.
    CountedPart part = countedPartOf(frame.view());
    const auto width = static_cast<std::size_t>(part.size.x), height = static_cast<std::size_t>(part.size.y);
    std::vector<std::uint32_t> words(width * height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glReadPixels(part.corner.x, part.pictureSize.y - part.corner.y - part.size.y, part.size.x, part.size.y,
                 GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
    gl::check("reading the stencil");
    part.counted.resize(words.size());
    part.depth.resize(words.size());
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint32_t* from = &words[(height - 1 - y) * width]; // GL counts rows from below
        std::uint8_t* counted = &part.counted[y * width];
        float* depth = &part.depth[y * width];
        for (std::size_t x = 0; x < width; ++x) {
            counted[x] = (from[x] & stencil.mask()) != 0 ? 1 : 0;
            depth[x] = static_cast<float>(from[x] >> 8) / 0xffffff;
        }
    }
    return part;
}

} // namespace

void RepairPass::apply(Frame& frame, int light, std::span<const CountedVolume> volumes, const StencilRule& stencil) {
    const Repair& repair = decided(frame, light, volumes, stencil);
    if (told_.insert(light).second) {
        frame.count("repaired-pixels", static_cast<double>(repair.lookedAt), static_cast<double>(repair.pixels.size()),
                    "pixels");
        frame.count("pixels-changed", static_cast<double>(repair.changed), static_cast<double>(repair.lookedAt),
                    "pixels");
    }
    writeBits(frame, repair, stencil);
}

const Repair& RepairPass::decided(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                                  const StencilRule& stencil) {
    if (const auto known = decided_.find(light); known != decided_.end()) return known->second;
    tracer_.advance(frame.snapshot(), Deadline::max()); // nothing is left to do, unless only the stage is asked for
    const CountedPart part = readCount(frame, stencil);
    PixelMask marked(part.counted.size(), 0);
    markDiffering(part, marked);
    for (const CountedVolume& volume : volumes) {
        const scene::Object& object = frame.scene().objects[volume.seen.caster->object];
        markEdges(part, *object.mesh, volume.seen.caster->silhouette, frame.eye().clipFromMesh(object), marked);
    }
    return decided_.emplace(light, decide(part, marked, tracer_, frame.view().camera, light)).first->second;
}

void RepairPass::writeBits(const Frame& frame, const Repair& repair, const StencilRule& stencil) const {
    if (!repair.anyFlipped) return;
    const CountedPart part = countedPartOf(frame.view());
    const gl::Texture2D flips(GL_R8, part.size, "bits to be turned over");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, part.size.x, part.size.y, GL_RED, GL_UNSIGNED_BYTE, repair.flips.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    frame.target().withoutColor.bind();
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, stencil.mask());
    glStencilOp(GL_ZERO, GL_KEEP, GL_INCR); // INCR for zero, ZERO for the rest: inverts the bit
    flip_.use();
    flip_.set("flips", 0);
    flip_.set("upperLeft", vec2(part.corner.x, part.pictureSize.y - part.corner.y));
    flips.bind(0);
    gl::drawFullscreenTriangle();
}

void RepairPass::publish(Frame& frame, int light, std::span<const CountedVolume> volumes, const StencilRule& stencil) {
    const Repair& repair = decided(frame, light, volumes, stencil);
    const CountedPart part = countedPartOf(frame.view());
    const vec3 notLookedAt = look::kShadowed, confirmed = look::kEqualDepth, changed = look::kOccluded;
    const auto width = static_cast<std::size_t>(part.pictureSize.x);
    std::vector<vec4> texels(width * static_cast<std::size_t>(part.pictureSize.y), vec4(notLookedAt, 1.0f));
    const auto texelOf = [&](ivec2 inPart) -> vec4& { // GL counts rows from below
        const ivec2 inPicture = part.corner + inPart;
        return texels[static_cast<std::size_t>(part.pictureSize.y - 1 - inPicture.y) * width +
                      static_cast<std::size_t>(inPicture.x)];
    };
    const auto forEach = [&](Repaired wanted, const auto& visit) {
        for (int y = 0; y < part.size.y; ++y)
            for (int x = 0; x < part.size.x; ++x)
                if (repair.pixels[part.index({x, y})] == wanted) visit(ivec2(x, y));
    };
    forEach(Repaired::confirmed, [&](ivec2 pixel) { texelOf(pixel) = vec4(confirmed, 1.0f); });
    // One pixel among thousands would never be found: each is drawn as a disc.
    const int radius = 5 * look::lineRadius(part.pictureSize.y);
    forEach(Repaired::changed, [&](ivec2 pixel) {
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (const ivec2 near = pixel + ivec2(dx, dy); dx * dx + dy * dy <= radius * radius && part.holds(near))
                    texelOf(near) = vec4(changed, 1.0f);
    });
    gl::Texture2D texture(GL_RGBA16F, part.pictureSize, "repair");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, part.pictureSize.x, part.pictureSize.y, GL_RGBA, GL_FLOAT, texels.data());
    frame.publish("repair", light, std::move(texture),
                  {.unit = "",
                   .key = {{notLookedAt, "not looked at"},
                           {confirmed, "asked with rays: the count is right"},
                           {changed, "the count was wrong: changed (drawn larger)"}}});
}

} // namespace shadowlab::shadow_volume
