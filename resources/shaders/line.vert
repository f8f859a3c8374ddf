#version 450
// A line as a rectangle of constant width in pixels, with square ends: not every OpenGL supports a glLineWidth above 1, and a
// line shorter than a pixel must be drawn as a dot.

layout(location = 0) in vec3 from;  // relative to the eye, world axes
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 colour;

layout(location = 0) uniform mat4 clipFromEyeRelative;
layout(location = 1) uniform vec2 halfViewport;
layout(location = 2) uniform float halfWidth;
layout(location = 3) uniform float leastDistance;

layout(location = 0) flat out vec3 lineColour;

// A line on a surface is drawn in front of it: a relative bias of the reversed depth.
const float towardEye = 1.0 + 1.0 / 4096.0;

vec4 cut(vec4 point, vec4 other) {
    return point.w < leastDistance ? mix(point, other, (leastDistance - point.w) / (other.w - point.w)) : point;
}

void main() {
    lineColour = colour;
    vec4 start = clipFromEyeRelative * vec4(from, 1.0);
    vec4 end = clipFromEyeRelative * vec4(to, 1.0);
    if (max(start.w, end.w) < leastDistance) {
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // behind the eye: a degenerate triangle outside the picture
        return;
    }
    vec4 a = cut(start, end);
    vec4 b = cut(end, start);
    vec2 along = (b.xy / b.w - a.xy / a.w) * halfViewport;
    float pixels = length(along);
    along = pixels > 1e-4 ? along / pixels : vec2(1.0, 0.0);
    bool atEnd = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
    bool onLeft = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
    vec4 point = atEnd ? b : a;
    vec2 offset = (along * (atEnd ? 1.0 : -1.0) + vec2(-along.y, along.x) * (onLeft ? 1.0 : -1.0)) * halfWidth;
    gl_Position = vec4(point.xy + offset / halfViewport * point.w, point.z * towardEye, point.w);
}
