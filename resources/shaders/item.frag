#version 450
// Drawn with GL_EQUAL over a finished depth buffer: of all triangles at a pixel's depth the lowest number stays, whatever the order.

layout(early_fragment_tests) in;
layout(location = 4) uniform uint firstTriangle;
layout(binding = 0, r32ui) uniform coherent uimage2D items;

void main() { imageAtomicMin(items, ivec2(gl_FragCoord.xy), firstTriangle + uint(gl_PrimitiveID)); }
