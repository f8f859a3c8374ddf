#version 450
// Lambert shading with a headlight at the eye, the same for both sides of a face but for their colours.

layout(location = 0) in vec3 toSurface;
layout(location = 1) in vec3 surfaceNormal;

layout(location = 3) uniform vec3 surfaceColour;
layout(location = 10) uniform vec3 backColour;

layout(location = 0) out vec4 colour;

void main() {
    float lengths = dot(toSurface, toSurface) * dot(surfaceNormal, surfaceNormal);
    float cosine = lengths > 0.0 ? abs(dot(toSurface, surfaceNormal)) * inversesqrt(lengths) : 1.0;
    colour = vec4((gl_FrontFacing ? surfaceColour : backColour) * (0.12 + 0.88 * cosine), 1.0);
}
