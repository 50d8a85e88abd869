#version 330 core
// The corner of a patch, projected onto one face of the half cube around another patch's centre.
layout(location = 0) in vec3 positionCentred;
layout(location = 1) in uint patchOfCorner;
uniform vec3 centreCentred;    // of the half cube
uniform mat4 clipFromRelative; // relative to that centre, along the axes of centred space
flat out uint patchNumber;

void main() {
    gl_Position = clipFromRelative * vec4(positionCentred - centreCentred, 1.0);
    patchNumber = patchOfCorner;
}
