// The point to look up, counted from the light (world axes): composed in double for each object, so a float is enough.
in vec3 positionLightRelative;
