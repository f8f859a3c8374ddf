#version 450
// Drawn with GL_EQUAL over a finished depth buffer: of all triangles at a pixel's depth the lowest number stays, in any drawing
// order.

layout(early_fragment_tests) in;
layout(location = 4) uniform uint firstTriangle;
layout(location = 8) uniform int firstPlace;  // first place of the draw in a strategy's order; below 0: the mesh's own order
layout(binding = 0, r32ui) uniform coherent uimage2D items;
layout(std430, binding = 2) readonly buffer Order { uint triangleAt[]; };

void main() {
    uint own = firstPlace < 0 ? uint(gl_PrimitiveID) : triangleAt[firstPlace + gl_PrimitiveID];
    imageAtomicMin(items, ivec2(gl_FragCoord.xy), firstTriangle + own);
}
