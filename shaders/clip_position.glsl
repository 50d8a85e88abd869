// The one expression for the clip position of every vertex. `invariant`: two programs that use it put a vertex at exactly
// the same place, so that depths of one surface drawn twice are equal and a volume's cap coincides with it.
invariant gl_Position;
uniform mat4 clipFromMesh;

vec4 clipPosition(vec4 homogeneousMesh) { return clipFromMesh * homogeneousMesh; }
