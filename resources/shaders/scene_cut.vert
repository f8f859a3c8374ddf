#version 450
// scene.vert for pictures of a section: what lies on the other side of a plane is cut away. The positions have the same bits.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) uniform mat4 clipFromPositions;
layout(location = 1) uniform mat4 sightFromPositions;
layout(location = 2) uniform mat3 normalMatrix;
layout(location = 9) uniform vec4 section;  // in the positions' coordinates: below 0 is cut away

invariant gl_Position;
layout(location = 0) out vec3 toSurface;  // along the line of sight, world axes
layout(location = 1) out vec3 surfaceNormal;

void main() {
    gl_Position = clipFromPositions * vec4(position, 1.0);
    gl_ClipDistance[0] = dot(section, vec4(position, 1.0));
    toSurface = (sightFromPositions * vec4(position, 1.0)).xyz;
    surfaceNormal = normalMatrix * normal;
}
