#version 450
// The part of the map that a triangle may cover, as a rectangle. The fragment shader decides for each of its pixels whether the
// triangle covers it, so that edges are great-circle arcs, the seam is no edge, and a triangle over a pole covers complete polar
// rows. A triangle across the seam is emitted twice: from the start of its azimuths, and a whole turn before.

layout(triangles) in;
layout(triangle_strip, max_vertices = 8) out;

layout(location = 0) in vec3 fromCentre[];
layout(location = 1) in vec3 cornerNormal[];

layout(location = 0) flat out vec3 corners[3];
layout(location = 3) flat out vec3 normals[3];

const float pi = 3.14159265358979;
const float margin = 1e-3;        // radians, covers the inaccuracy of atan; it only enlarges the rectangle
const float poleSlack = 1e-6;

float zenith(vec3 direction) { return atan(length(direction.xy), direction.z); }

// Whether the great-circle arc from a to b, whose plane has the normal n, contains a direction that lies in this plane.
bool onArc(vec3 a, vec3 b, vec3 n, vec3 direction) { return dot(direction, cross(n, a)) > 0.0 && dot(direction, cross(b, n)) > 0.0; }

void widen(inout vec2 range, float value) { range = vec2(min(range.x, value), max(range.y, value)); }

void widenByArc(inout vec2 zeniths, vec3 a, vec3 b) {
    vec3 n = cross(a, b);
    vec3 top = vec3(0.0, 0.0, dot(n, n)) - n * n.z;
    if (onArc(a, b, n, top)) widen(zeniths, zenith(top));
    if (onArc(a, b, n, -top)) widen(zeniths, zenith(-top));
}

void emitCorner(float theta, float phi) {
    for (int i = 0; i < 3; ++i) {
        corners[i] = fromCentre[i];
        normals[i] = cornerNormal[i];
    }
    gl_Position = vec4(phi / pi - 1.0, 1.0 - 2.0 * theta / pi, 0.5, 1.0);
    EmitVertex();
}

void emitRectangle(vec2 zeniths, vec2 azimuths) {
    emitCorner(zeniths.x, azimuths.x);
    emitCorner(zeniths.y, azimuths.x);
    emitCorner(zeniths.x, azimuths.y);
    emitCorner(zeniths.y, azimuths.y);
    EndPrimitive();
}

float nearestTurn(float phi, float before) { return phi + 2.0 * pi * round((before - phi) / (2.0 * pi)); }

void main() {
    vec3 a = fromCentre[0] / max(length(fromCentre[0]), 1e-30);
    vec3 b = fromCentre[1] / max(length(fromCentre[1]), 1e-30);
    vec3 c = fromCentre[2] / max(length(fromCentre[2]), 1e-30);
    vec2 zeniths = vec2(zenith(a));
    widen(zeniths, zenith(b));
    widen(zeniths, zenith(c));
    widenByArc(zeniths, a, b);
    widenByArc(zeniths, b, c);
    widenByArc(zeniths, c, a);

    vec3 sides = vec3(cross(a, b).z, cross(b, c).z, cross(c, a).z);
    bool overPole = min(min(sides.x, sides.y), sides.z) >= -poleSlack || max(max(sides.x, sides.y), sides.z) <= poleSlack;
    if (overPole) {
        vec3 n = cross(fromCentre[1] - fromCentre[0], fromCentre[2] - fromCentre[0]);
        float side = n.z * dot(n, fromCentre[0]);
        if (side >= 0.0) zeniths.x = 0.0;
        if (side <= 0.0) zeniths.y = pi;
        emitRectangle(zeniths + vec2(-margin, margin), vec2(0.0, 2.0 * pi));
        return;
    }
    float first = atan(a.y, a.x);
    vec2 azimuths = vec2(first);
    widen(azimuths, nearestTurn(atan(b.y, b.x), first));
    widen(azimuths, nearestTurn(atan(c.y, c.x), first));
    azimuths -= 2.0 * pi * floor(azimuths.x / (2.0 * pi));
    zeniths += vec2(-margin, margin);
    azimuths += vec2(-margin, margin);
    emitRectangle(zeniths, azimuths);
    if (azimuths.y > 2.0 * pi) emitRectangle(zeniths, azimuths - 2.0 * pi);
}
