// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/baseline.h"

#include <glad/gl.h>

#include <initializer_list>

namespace shadowlab::gl {

void setBaselineState() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthRange(0, 1);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(0xff);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (const GLenum capability : {GL_BLEND, GL_STENCIL_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL,
                                    GL_DEPTH_CLAMP, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1, GL_DITHER, GL_MULTISAMPLE})
        glDisable(capability);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0, 0);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClearStencil(0);
    // NVIDIA's driver 580.159 checks the program in use at every clear, too, and warns of a shadow sampler whose texture is about to be
    // read as depths.
    glUseProgram(0);
}

} // namespace shadowlab::gl
