// Numbers that are read by index (gl::TableTexture) lie in the rows of a texture. A buffer texture would need none of this, but
// OpenGL 3.3 promises only 65,536 texels of one, and the tables of a room are larger.
const int kTableWidth = 4096; // gl::kTableWidth

ivec2 tableTexel(int index) { return ivec2(index & (kTableWidth - 1), index / kTableWidth); }
vec4 entry(sampler2D table, int index) { return texelFetch(table, tableTexel(index), 0); }
uvec4 entry(usampler2D table, int index) { return texelFetch(table, tableTexel(index), 0); }
