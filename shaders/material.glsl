// The material of what is being drawn, and its reflection. The C++ twin is techniques/foundation/scene/query/shading.h.
uniform vec3 diffuse;
#ifdef NO_SPECULAR // nothing in the scene has highlights: gl::useForLight
const vec3 specular = vec3(0.0);
#else
uniform vec3 specular;
#endif
uniform float shininess;
uniform vec3 emission;
#include "image_place.glsl"
#ifdef COLORED // a surface of the scene has an image laid on it, or colours of its vertices: gl::useForMaterials
in vec3 vertexColor;
uniform int usesVertexColors; // 0: the mesh has none, or a material of the scene replaces them
uniform sampler2D colorMap;  // sRGB; white where there is no image
uniform vec4 colorPlacement; // scale, offset

// The C++ twin is techniques/foundation/scene/model/surface_color.h.
vec3 surfaceDiffuse() {
    vec3 ofVertices = usesVertexColors == 1 ? vertexColor : vec3(1.0);
    return diffuse * ofVertices * texture(colorMap, imagePlace(colorPlacement)).rgb;
}
#else
vec3 surfaceDiffuse() { return diffuse; }
#endif

const float kPi = 3.14159265358979;

// Reflected radiance toward the eye per unit of irradiance: Lambert plus normalised Blinn-Phong.
// All vectors are unit and in view space; the normal is on the viewer's side.
vec3 reflectance(vec3 normalView, vec3 toLightView, vec3 toEyeView) {
    vec3 halfwayView = normalize(toLightView + toEyeView);
    float cosHalfway = max(dot(normalView, halfwayView), 0.0);
    float lobe = (shininess + 8.0) / (8.0 * kPi) * (shininess > 0.0 ? pow(cosHalfway, shininess) : 1.0);
    return surfaceDiffuse() / kPi + specular * lobe;
}
