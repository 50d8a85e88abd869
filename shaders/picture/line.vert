#version 330 core
// One segment as a rectangle around it, made from the vertex number: GL promises lines of one pixel only.
layout(location = 0) in vec3 fromScreen; // pixels from the lower left corner, and depth -1..1
layout(location = 1) in vec3 toScreen;
uniform vec2 pictureSize;
uniform float reach; // pixels from the segment to the rectangle's border, at the ends too: they are round
flat out vec2 from, to;

void main() {
    from = fromScreen.xy;
    to = toScreen.xy;
    vec2 along = to - from;
    along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    bool atEnd = gl_VertexID >= 2;
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    vec2 pixel = (atEnd ? to : from) + reach * (side * across + (atEnd ? along : -along));
    // Depth goes on beyond the ends as it does between them, but for segments that are hardly more than a point.
    float beyond = distance(from, to) > reach ? reach / distance(from, to) : 0.0;
    float depth = mix(fromScreen.z, toScreen.z, atEnd ? 1.0 + beyond : -beyond);
    gl_Position = vec4(2.0 * pixel / pictureSize - 1.0, depth, 1.0);
}
