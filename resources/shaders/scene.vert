#version 450
// The only vertex program: pictures, depth pass and item buffer must have bit-identical vertex positions.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) uniform mat4 clipFromPositions;
layout(location = 1) uniform mat4 sightFromPositions;
layout(location = 2) uniform mat3 normalMatrix;

invariant gl_Position;
layout(location = 0) out vec3 toSurface;  // along the line of sight, world axes
layout(location = 1) out vec3 surfaceNormal;

void main() {
    gl_Position = clipFromPositions * vec4(position, 1.0);
    toSurface = (sightFromPositions * vec4(position, 1.0)).xyz;
    surfaceNormal = normalMatrix * normal;
}
