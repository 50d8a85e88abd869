// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/repair/repair_pass.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::shadow_volume {

void RepairPass::readCount(const Frame& frame, const std::optional<scene::PicturePart>& counted, const StencilRule& stencil) {
    const Region drawn = drawnRegion(frame.view());
    part_.pictureSize = frame.view().size;
    part_.countMask = stencil.mask();
    part_.isAll = counted && drawn.size == part_.pictureSize;
    const auto [corner, size] = part_.isAll ? frame.pixelsOf(counted) : drawn;
    part_.corner = corner;
    part_.size = size;
    part_.words.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glReadPixels(corner.x, part_.pictureSize.y - corner.y - size.y, size.x, size.y, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                 part_.words.data());
    gl::check("reading the stencil");
}

void RepairPass::apply(Frame& frame, int light, std::span<const CountedVolume> volumes,
                       const std::optional<scene::PicturePart>& counted, const StencilRule& stencil) {
    const Repair& repair = decided(frame, light, volumes, counted, stencil);
    if (told_.insert(light).second) {
        const ivec2 drawn = drawnRegion(frame.view()).size;
        const auto lookedAt = static_cast<double>(repair.lookedAt.size());
        frame.count("repaired-pixels", lookedAt, static_cast<double>(drawn.x) * drawn.y, "pixels");
        frame.count("pixels-changed", static_cast<double>(repair.changed.size()), lookedAt, "pixels");
    }
    writeBits(frame, repair, stencil);
}

const Repair& RepairPass::decided(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                                  const std::optional<scene::PicturePart>& counted, const StencilRule& stencil) {
    if (const auto known = decided_.find(light); known != decided_.end()) return known->second;
    tracer_.advance(frame.snapshot(), Deadline::max()); // nothing is left to do, unless only the stage is asked for
    readCount(frame, counted, stencil);
    marked_.assign(part_.words.size(), 0);
    markDiffering(part_, marked_);
    for (const CountedVolume& volume : volumes) {
        const scene::Object& object = frame.scene().objects[volume.seen.caster->object];
        markEdges(part_, *object.mesh, volume.seen.caster->silhouette, frame.eye().clipFromMesh(object), marked_);
    }
    return decided_.emplace(light, decide(part_, marked_, tracer_, frame.view().camera, light, rays_)).first->second;
}

void RepairPass::writeBits(const Frame& frame, const Repair& repair, const StencilRule& stencil) const {
    if (repair.flips.empty()) return;
    const gl::VertexArrayHandle points = gl::VertexArrayHandle::create();
    glBindVertexArray(points.id());
    const gl::BufferHandle pixels = gl::uploadBuffer(GL_ARRAY_BUFFER, std::vector<vec2>(repair.flips.begin(), repair.flips.end()));
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    frame.target().withoutColor.bind();
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, stencil.mask());
    glStencilOp(GL_ZERO, GL_KEEP, GL_INCR); // INCR for zero, ZERO for the rest: inverts the bit
    flip_.use();
    flip_.set("pictureSize", vec2(frame.view().size));
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(repair.flips.size()));
    glBindVertexArray(0);
}

void RepairPass::publish(Frame& frame, int light, std::span<const CountedVolume> volumes,
                         const std::optional<scene::PicturePart>& counted, const StencilRule& stencil) {
    const Repair& repair = decided(frame, light, volumes, counted, stencil);
    const ivec2 size = frame.view().size;
    const auto [corner, drawn] = drawnRegion(frame.view());
    const vec3 notLookedAt = look::kShadowed, confirmed = look::kEqualDepth, changed = look::kOccluded;
    const auto width = static_cast<std::size_t>(size.x);
    std::vector<vec4> texels(width * static_cast<std::size_t>(size.y), vec4(notLookedAt, 1.0f));
    const auto texelOf = [&](ivec2 pixel) -> vec4& { // GL counts rows from below
        return texels[static_cast<std::size_t>(size.y - 1 - pixel.y) * width + static_cast<std::size_t>(pixel.x)];
    };
    for (const ivec2& pixel : repair.lookedAt)
        texelOf(pixel) = vec4(confirmed, 1.0f);
    // One pixel among thousands would never be found: each is drawn as a disc.
    const int radius = 5 * look::lineRadius(size.y);
    const ivec2 last = corner + drawn - 1;
    for (const ivec2& pixel : repair.changed)
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (const ivec2 near = pixel + ivec2(dx, dy);
                    dx * dx + dy * dy <= radius * radius && near == glm::clamp(near, corner, last))
                    texelOf(near) = vec4(changed, 1.0f);
    gl::Texture2D texture(GL_RGBA16F, size, "repair");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
    frame.publish("repair", light, std::move(texture),
                  {.unit = "",
                   .key = {{notLookedAt, "not looked at"},
                           {confirmed, "asked with rays: the count is right"},
                           {changed, "the count was wrong: changed (drawn larger)"}}});
}

} // namespace shadowlab::shadow_volume
