#version 450
// A scene triangle coloured by its state, almost unshaded: Lambert ± 10 % with a headlight at the eye. Drawn once for every look.

layout(location = 0) in vec3 toSurface;
layout(location = 1) in vec3 surfaceNormal;

layout(location = 4) uniform uint firstTriangle;
layout(location = 5) uniform uint wantedLook;
layout(location = 6) uniform vec2 hatch;  // units of a period that are black, and units that are white
layout(location = 7) uniform vec3 hatchPlace;  // place of the lower left pixel in the whole picture; pixels for each unit

layout(std430, binding = 0) readonly buffer States { uint states[]; };        // four triangles in each word, the first in the
                                                                              // lowest byte
layout(std430, binding = 1) readonly buffer Palette { vec4 palette[]; };      // colour, look

layout(location = 0) out vec4 colour;

const uint marked = 2u;
const uint wireframe = 1u;
const float hatchPeriod = 16.0;  // units, along a row

void main() {
    uint triangle = firstTriangle + uint(gl_PrimitiveID);
    vec4 entry = palette[(states[triangle >> 2] >> (8u * (triangle & 3u))) & 255u];
    if (uint(entry.a) != wantedLook) discard;
    float lengths = dot(toSurface, toSurface) * dot(surfaceNormal, surfaceNormal);
    float cosine = lengths > 0.0 ? abs(dot(toSurface, surfaceNormal)) * inversesqrt(lengths) : 1.0;
    vec3 shaded = wantedLook == wireframe ? entry.rgb : entry.rgb * (0.9 + 0.2 * cosine);
    if (wantedLook == marked) {
        float along = mod((gl_FragCoord.x + gl_FragCoord.y + hatchPlace.x + hatchPlace.y) / hatchPlace.z, hatchPeriod);
        if (along < hatch.x)
            shaded = vec3(0.0);
        else if (along < hatch.x + hatch.y)
            shaded = vec3(1.0);
    }
    colour = vec4(shaded, 1.0);
}
