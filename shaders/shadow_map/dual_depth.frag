#version 330 core
// The depth that dual-depth maps store: the middle between the first surface and the next, but at most as far behind the
// first as its slope asks for. Behind a lit floor there is nothing, and the middle would be nowhere.
// Woo, "The Shadow Depth Map Revisited", Graphics Gems III, 1992 (the middle); Weiskopf and Ertl, "Shadow Mapping Based on
// Dual Depth Layers", Eurographics 2003 (the limit).
uniform sampler2DArray firstDepth, secondDepth, pushedDepth;

void main() {
    ivec3 texel = ivec3(gl_FragCoord.xy, 0);
    float first = texelFetch(firstDepth, texel, 0).r;
    float middle = 0.5 * (first + texelFetch(secondDepth, texel, 0).r);
    gl_FragDepth = min(middle, texelFetch(pushedDepth, texel, 0).r);
}
