#version 450
// Drawn in a frame's own order into an integer picture: what the frame shows last at a pixel stays, with its depth.

layout(location = 4) uniform uint firstTriangle;
layout(location = 8) uniform int firstPlace;  // first place of the draw in a strategy's order; below 0: the mesh's own order
layout(std430, binding = 2) readonly buffer Order { uint triangleAt[]; };

layout(location = 0) out uint item;

void main() {
    uint own = firstPlace < 0 ? uint(gl_PrimitiveID) : triangleAt[firstPlace + gl_PrimitiveID];
    item = firstTriangle + own;
}
