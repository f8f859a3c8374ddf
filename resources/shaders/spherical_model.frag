#version 450
// Intersects the ray from the centre, through the pixel's zenith angle and azimuth, with the triangle: R gives the depth (larger
// R is nearer to the viewer) and the colour; the light comes from outside along the ray.

layout(location = 0) flat in vec3 corners[3];
layout(location = 3) flat in vec3 normals[3];

layout(location = 1) uniform float largestRadius;
layout(location = 2) uniform vec4 map;  // lower left corner and size of the map in pixels of the window
layout(location = 3) uniform vec3 ramp[5];  // by ascending R

layout(location = 0) out vec4 colour;

const float pi = 3.14159265358979;

void main() {
    // From the pixel, not interpolated over the rectangle, so that the direction is identical for all triangles at this pixel.
    vec2 place = (gl_FragCoord.xy - map.xy) / map.zw;
    float theta = pi * (1.0 - place.y), phi = 2.0 * pi * place.x;
    vec3 direction = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
    // On the other side of an edge the bits are exactly the negative, so that neighbours leave no gap.
    precise vec3 planes[3];
    precise vec3 sides;
    for (int i = 0; i < 3; ++i) {
        planes[i] = cross(corners[(i + 1) % 3], corners[(i + 2) % 3]);
        sides[i] = dot(planes[i], direction);
    }
    bool left = all(greaterThanEqual(sides, vec3(0.0)));
    bool right = all(lessThanEqual(sides, vec3(0.0)));
    if (!left && !right) discard;
    vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    float along = dot(n, direction);
    if (along == 0.0) discard;  // the plane is parallel to the ray
    float radius = dot(n, corners[0]) / along;
    if (!(radius > 0.0)) discard;  // on the other side of the centre
    float sum = sides.x + sides.y + sides.z;
    vec3 weights = sum != 0.0 ? sides / sum : vec3(1.0 / 3.0);
    vec3 normal = weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2];
    float lengths = dot(normal, normal);
    float cosine = lengths > 0.0 ? abs(dot(normal, direction)) * inversesqrt(lengths) : 1.0;
    float share = clamp(radius / largestRadius, 0.0, 1.0);
    int below = min(int(share * 4.0), 3);
    vec3 tint = mix(ramp[below], ramp[below + 1], share * 4.0 - float(below));
    colour = vec4(tint * (0.25 + 0.75 * cosine), 1.0);
    gl_FragDepth = clamp(0.999 * share, 1e-6, 1.0);
}
