#version 450
// Lines have one colour and no shading.

layout(location = 0) flat in vec3 lineColour;

layout(location = 0) out vec4 colour;

void main() { colour = vec4(lineColour, 1.0); }
