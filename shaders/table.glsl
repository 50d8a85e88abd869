// Numbers that are read by index (gl::TableTexture) are stored in the rows of a texture. A buffer texture would be simpler,
// but OpenGL 3.3 guarantees only 65,536 texels, and the tables of radiosity are larger.
const int kTableWidth = 4096; // gl::kTableWidth

ivec2 tableTexel(int index) { return ivec2(index & (kTableWidth - 1), index / kTableWidth); }
vec4 entry(sampler2D table, int index) { return texelFetch(table, tableTexel(index), 0); }
uvec4 entry(usampler2D table, int index) { return texelFetch(table, tableTexel(index), 0); }
