// Radiance with all lights off: the surface's own emission and the ambient light it reflects. Needs material.glsl.
uniform vec3 ambient;
uniform int emitsFromFrontOnly; // a rect light's surface is dark on its back

// [anchor: lights-off]
vec3 lightsOffRadiance() {
    bool emits = emitsFromFrontOnly == 0 || gl_FrontFacing;
    return (emits ? emission : vec3(0.0)) + ambient * surfaceDiffuse();
}
