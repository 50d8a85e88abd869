// What was decided for this pixel: by the map where that is certain, by a ray elsewhere.
uniform sampler2D decided;

float shadowVisibility() { return texelFetch(decided, ivec2(gl_FragCoord.xy), 0).r; }
