// The facing gate left open, for rasterisers that draw nothing with a shader that reads gl_PrimitiveID (volume_case.h).
bool eyeSideFacesLight() { return true; }
