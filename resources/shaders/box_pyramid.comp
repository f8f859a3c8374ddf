#version 450
// Whether boxes lie behind the farthest depth of all pixels that they may cover, by a depth pyramid (depth_pyramid.comp). One
// invocation for each box. Every doubt counts as visible.

layout(local_size_x = 64) in;
struct Box {
    vec3 centre;  // relative to the eye
    uint group;
    vec3 halfExtent;
    uint unused;
};
struct Reading {
    uint levelAndTexels;  // level · 2^16 + number of its texels
    float nearest;
    float farthest;
};
layout(binding = 0) uniform sampler2D depth;
layout(std430, binding = 0) readonly buffer Pyramid { float pyramid[]; };
layout(std430, binding = 1) readonly buffer Boxes { Box boxes[]; };
layout(std430, binding = 2) buffer Shows { uint shows[]; };  // by group: whether one of its boxes is visible; 0 before
layout(std430, binding = 3) writeonly buffer Readings { Reading readings[]; };
layout(location = 0) uniform mat4 clipFromEye;
layout(location = 4) uniform ivec2 size;
layout(location = 5) uniform uint boxCount;

const int mostTexels = 4;  // of a level, along a row or column, that are read for one box

void main() {
    uint number = gl_GlobalInvocationID.x;
    if (number >= boxCount) return;
    Box box = boxes[number];
    vec2 low = vec2(1e30), high = vec2(-1e30);
    float nearest = 0.0;  // no farther than where the picture ends
    bool known = true;
    for (int corner = 0; corner < 8; ++corner) {
        vec3 side = vec3((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
        vec4 clip = clipFromEye * vec4(box.centre + side * box.halfExtent, 1.0);
        // Before the near plane, behind the eye, or no number.
        known = known && clip.w > 0.0 && clip.z <= clip.w;
        vec2 pixel = (0.5 * clip.xy / clip.w + 0.5) * vec2(size);
        known = known && all(lessThanEqual(abs(pixel), vec2(1e30)));
        low = min(low, pixel);
        high = max(high, pixel);
        nearest = max(nearest, clip.z / clip.w);
    }
    if (!known) {
        shows[box.group] = 1u;
        readings[number] = Reading(0u, 1.0, 0.0);
        return;
    }
    // What lies beside the picture has no pixels: it is compared with those at the border.
    ivec2 first = ivec2(clamp(floor(low), vec2(0.0), vec2(size - 1)));
    ivec2 last = ivec2(clamp(floor(high), vec2(0.0), vec2(size - 1)));
    int level = 0, start = 0;
    ivec2 levelSize = size;
    while (any(greaterThanEqual((last >> level) - (first >> level), ivec2(mostTexels)))) {
        if (level > 0) start += levelSize.x * levelSize.y;
        levelSize = (levelSize + 1) / 2;
        ++level;
    }
    first >>= level;
    last >>= level;
    float farthest = 1.0;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            farthest = min(farthest, level == 0 ? texelFetch(depth, ivec2(x, y), 0).r : pyramid[start + y * levelSize.x + x]);
    if (!(nearest < farthest)) shows[box.group] = 1u;
    ivec2 texels = last - first + 1;
    readings[number] = Reading(uint(level) * 65536u + uint(texels.x * texels.y), nearest, farthest);
}
