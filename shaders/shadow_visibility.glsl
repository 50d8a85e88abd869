// The visible fraction of the light when nothing shadows anything. A technique that answers in the fragment shader
// substitutes a file of its own that defines the same function.
float shadowVisibility() { return 1.0; }
