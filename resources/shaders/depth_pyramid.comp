#version 450
// Up to three levels of a depth pyramid: each texel is the farthest, which of reversed depths is the least, of up to 2 × 2 texels
// of the level below. A level has half the columns and rows of that one, rounded up: so texel (x, y) of level n stands for the
// pixels from (x, y) · 2^n on, at any size of the picture, and of an odd column or row the last texel has fewer below it. One
// invocation for each texel of the third level, for up to 8 × 8 texels of the level below: a level a dispatch would take most of
// its time to begin.

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer Pyramid { float pyramid[]; };    // the levels from 1 on, one after the other, row by row
layout(location = 0) uniform ivec2 belowSize;
layout(location = 1) uniform int start;   // of the first of the levels
layout(location = 2) uniform int levels;  // how many of the three there are: the last one of a pyramid has one texel

// The texels of the level below. Two programs: a software OpenGL executes both sides of a condition.
#ifdef BELOW_IS_THE_PICTURE
layout(binding = 0) uniform sampler2D depth;
float below(ivec2 texel) { return texelFetch(depth, texel, 0).r; }
#else
layout(location = 3) uniform int belowStart;  // in the pyramid
float below(ivec2 texel) { return pyramid[belowStart + texel.y * belowSize.x + texel.x]; }
#endif

void main() {
    ivec2 firstSize = (belowSize + 1) / 2, secondSize = (firstSize + 1) / 2, thirdSize = (secondSize + 1) / 2;
    int secondStart = start + firstSize.x * firstSize.y, thirdStart = secondStart + secondSize.x * secondSize.y;
    ivec2 third = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(third, thirdSize))) return;
    float ofThird = 1.0;
    for (int i = 0; i < 4; ++i) {
        // What lies beyond a level's last column or row is that one again: nothing branches on it.
        ivec2 second = min(2 * third + ivec2(i & 1, i >> 1), secondSize - 1);
        float ofSecond = 1.0;
        for (int j = 0; j < 4; ++j) {
            ivec2 first = min(2 * second + ivec2(j & 1, j >> 1), firstSize - 1);
            ivec2 low = 2 * first, high = min(low + 1, belowSize - 1);
            float ofFirst = min(min(below(low), below(ivec2(high.x, low.y))), min(below(ivec2(low.x, high.y)), below(high)));
            pyramid[start + first.y * firstSize.x + first.x] = ofFirst;
            ofSecond = min(ofSecond, ofFirst);
        }
        if (levels > 1) pyramid[secondStart + second.y * secondSize.x + second.x] = ofSecond;
        ofThird = min(ofThird, ofSecond);
    }
    if (levels > 2) pyramid[thirdStart + third.y * thirdSize.x + third.x] = ofThird;
}
