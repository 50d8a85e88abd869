// From a texture coordinate to a place in an image that is laid on the surface. The C++ twin is
// techniques/foundation/scene/model/image_placement.h.
#if defined(CUT_HOLES) || defined(COLORED)
in vec2 texcoord;

// `placement`: scale, offset.
vec2 imagePlace(vec4 placement) { return texcoord * placement.xy + placement.zw; }
#endif
