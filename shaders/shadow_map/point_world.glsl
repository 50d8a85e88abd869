// The point to look up, counted from the world's origin. A float has 24 bits: a thousand kilometres away from the origin its steps
// are 6 cm, and the difference of two such numbers is no better than they are.
in vec3 positionWorld;
uniform vec3 lightOriginWorld;
// A compiler may subtract in the vertex shader what is only subtracted here, and round less (Mesa 26 does). It cannot move `min`,
// which changes no position (scenes end at 1e15).
#define positionLightRelative (min(positionWorld, vec3(1e30)) - lightOriginWorld)
