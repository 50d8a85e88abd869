// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/id_buffer.h"

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::gl {

void IdBuffer::draw(const scene::Scene& scene, const SceneBuffers& buffers, const EyeMatrices& eye, ivec2 size) {
    if (!framebuffer_ || framebuffer_.size() != size) {
        ids_ = Texture2D(GL_R32UI, size, "triangle ids");
        depthStencil_ = Texture2D(GL_DEPTH24_STENCIL8, size, "depth of triangle ids"); // the depth of Target
        framebuffer_ = Framebuffer(&ids_, &depthStencil_, "triangle ids");
    }
    setBaselineState();
    framebuffer_.bind();
    const GLuint none[4] = {kNone, kNone, kNone, kNone};
    glClearBufferuiv(GL_COLOR, 0, none);
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    program_.use();
    drawSurfacesWithHoles(program_, scene, buffers, eye);
    check("triangle ids");
}

std::vector<std::uint32_t> IdBuffer::read() const {
    const ivec2 size = framebuffer_.size();
    std::vector<std::uint32_t> ids(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
    check("reading triangle ids");
    turnRowsOver(ids, size);
    return ids;
}

} // namespace shadowlab::gl
