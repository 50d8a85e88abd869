// Radiance with all lights off: the surface's own emission and the ambient light it reflects. Needs material.glsl.
uniform vec3 ambient;
uniform int emittingSides; // 1: the front of the drawn triangle shines, 2: its back, 3: both

// [anchor: lights-off]
vec3 lightsOffRadiance() {
    bool emits = (emittingSides & (gl_FrontFacing ? 1 : 2)) != 0;
    return (emits ? emission : vec3(0.0)) + ambient * surfaceDiffuse();
}
