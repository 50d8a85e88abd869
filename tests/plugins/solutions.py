"""The blanks of the skeletons (assets/skeletons), filled in: rightly, and with one mistake each that students make.

`SOLUTIONS[skeleton][blank]` is a Blank. The right ones together get full marks; each mistake, in place of the right one, costs some.
"""
# SPDX-License-Identifier: MIT
from dataclasses import dataclass


@dataclass
class Blank:
    right: str
    mistake: str  # in a few words
    wrong: str


PLANAR = {
    1: Blank("return glm::dot(planeView, lightView) * dmat4(1.0) - glm::outerProduct(lightView, planeView);",
             "the transposed matrix",
             "return glm::dot(planeView, lightView) * dmat4(1.0) - glm::outerProduct(planeView, lightView);"),
    2: Blank("glStencilFunc(GL_EQUAL, kTagBit | kMarkBit, kTagBit);",
             "the stencil is not asked",
             "glStencilFunc(GL_ALWAYS, kTagBit | kMarkBit, kTagBit);"),
    3: Blank("abovePlane = planeView;",
             "nothing is clipped at the plane",
             ""),
}

SHADOW_MAP = {
    1: Blank("return glm::ortho(-ball.radius, ball.radius, -ball.radius, ball.radius, ball.radius, 3 * ball.radius) *\n"
             "       glm::lookAt(ball.centerWorld + 2.0 * ball.radius * toLightWorld, ball.centerWorld, upWorld);",
             "it looks the other way",
             "return glm::ortho(-ball.radius, ball.radius, -ball.radius, ball.radius, ball.radius, 3 * ball.radius) *\n"
             "       glm::lookAt(ball.centerWorld - 2.0 * ball.radius * toLightWorld, ball.centerWorld, upWorld);"),
    2: Blank("const double away = glm::length(light.positionWorld - ball.centerWorld);\n"
             "const double near = std::max(away - ball.radius, 0.01 * ball.radius);\n"
             "return glm::perspective(2 * std::asin(std::min(ball.radius / away, 0.99)), 1.0, near, away + ball.radius) *\n"
             "       glm::lookAt(light.positionWorld, ball.centerWorld, upWorld);",
             "a fixed near and far plane",
             "const double away = glm::length(light.positionWorld - ball.centerWorld);\n"
             "return glm::perspective(2 * std::asin(std::min(ball.radius / away, 0.99)), 1.0, 0.01, 1000.0) *\n"
             "       glm::lookAt(light.positionWorld, ball.centerWorld, upWorld);"),
    3: Blank("glEnable(GL_POLYGON_OFFSET_FILL);\nglPolygonOffset(1.5f, 4.0f);",
             "none at all",
             ""),
    4: Blank("if (positionLightClip.w <= 0.0) return 1.0;\n"
             "vec3 str = 0.5 * positionLightClip.xyz / positionLightClip.w + 0.5;",
             "what is behind the lamp is not left out",
             "vec3 str = 0.5 * positionLightClip.xyz / positionLightClip.w + 0.5;"),
    5: Blank("return z <= d ? 1.0 : 0.0;",
             "the comparison is the wrong way around",
             "return z >= d ? 1.0 : 0.0;"),
}

Z_FAIL = {
    1: Blank("return glm::dot(glm::cross(b - a, c - a), dvec3(light) - light.w * a) > 0;",
             "the sun is taken for a place",
             "return glm::dot(glm::cross(b - a, c - a), dvec3(light) - a) > 0;"),
    2: Blank("if (isFacing[use.triangle]) side += use.direction;",
             "every edge of a facing triangle is extruded, once",
             "if (isFacing[use.triangle]) side = use.direction;"),
    3: Blank("glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);\n"
             "glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);",
             "the depth test's other outcome: z-pass",
             "glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);\n"
             "glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);"),
    4: Blank("buffers.draw(volume.bottomCap);",
             "no bottom cap",
             ""),
    5: Blank("vec4 farMesh = vec4(positionMesh * lightMesh.w - lightMesh.xyz, 0.0);",
             "twenty metres are taken for enough",
             "vec4 farMesh = vec4(positionMesh + 20.0 * normalize(positionMesh * lightMesh.w - lightMesh.xyz), 1.0);"),
}

SOLUTIONS = {"planar": PLANAR, "shadow-map": SHADOW_MAP, "z-fail": Z_FAIL}
