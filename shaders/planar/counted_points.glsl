// The share of the light that a pixel sees: of the sampled points, those whose shadows do not fall there.
uniform sampler2D shadowsOfPoints; // number of shadows per pixel
uniform float lightPoints;

// [anchor: share-of-points]
float shadowVisibility() {
    return 1.0 - texelFetch(shadowsOfPoints, ivec2(gl_FragCoord.xy), 0).r / lightPoints;
}
