#version 330 core
// For passes that only touch depth or stencil.
void main() {}
