#version 330 core
// The number of the patch in this pixel. A patch seen from behind blocks light and receives none.
flat in uint patchNumber;
uniform int fromBehind; // 1 or 0
out uint seen;

void main() { seen = fromBehind == 1 ? 0xffffffffu : patchNumber; }
