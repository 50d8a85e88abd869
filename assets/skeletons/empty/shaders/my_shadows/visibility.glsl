// The share of the light that this pixel sees. Called by shade_light.frag, which has decided already that the surface faces the
// light. What there is to work with: positionView, normalView, and of light.glsl lightPositionView and towardLight().
uniform float darkness;

float shadowVisibility() { return 1.0 - darkness; }
