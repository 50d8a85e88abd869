#version 330 core
// Which patch is seen in this pixel. What is seen from behind is in the way, and receives nothing.
flat in uint patchNumber;
uniform int fromBehind; // 1 or 0
out uint seen;

void main() { seen = fromBehind == 1 ? 0xffffffffu : patchNumber; }
