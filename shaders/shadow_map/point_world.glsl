// The point to look up, counted from the world's origin. A float has 24 bits: a thousand kilometres away from the origin its steps
// are 6 cm, and the difference of two such numbers is no better than they are.
in vec3 positionWorld;
uniform vec3 lightOriginWorld;
#define positionLightRelative (positionWorld - lightOriginWorld)
