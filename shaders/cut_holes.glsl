// Leaves out the fragments that lie in a hole of an alpha mask, so that they leave no depth. Only the variant of a program
// that draws surfaces with holes does so (Program::alphaTested): a fragment shader with `discard` disables the early depth
// test. The C++ twin is techniques/foundation/scene/model/holes.h.
#include "image_place.glsl"
#ifdef CUT_HOLES
uniform sampler2D alphaMask;  // 1 where there is surface, rows from the bottom
uniform vec4 alphaPlacement;  // scale, offset
uniform int alphaClamped;

void cutHoles() {
    ivec2 size = textureSize(alphaMask, 0);
    vec2 place = imagePlace(alphaPlacement);
    vec2 within = alphaClamped == 1 ? clamp(place, 0.0, 1.0) : fract(place);
    // Just below a whole number fract() rounds up to 1; that is the last texel, not the first.
    ivec2 texel = min(ivec2(within * vec2(size)), size - 1);
    if (texelFetch(alphaMask, texel, 0).r < 0.5) discard;
}
#else
void cutHoles() {}
#endif
