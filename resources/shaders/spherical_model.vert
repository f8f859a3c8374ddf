#version 450
// Corners of a mesh relative to the centre of its spherical coordinates.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) uniform vec3 centre;

layout(location = 0) out vec3 fromCentre;
layout(location = 1) out vec3 cornerNormal;

void main() {
    fromCentre = position - centre;
    cornerNormal = normal;
}
