#include "core/geometry/frustum_planes.h"

#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/frustum.h"
#include "core/geometry/random.h"

namespace cullscope::frustum_planes_test {
namespace {

constexpr std::array kDepths{ClipDepth::MinusOneToOne, ClipDepth::ZeroToOne, ClipDepth::ReversedZeroToOne};

enum class Hand { Right, Left };

/// The projection matrix of a textbook: GLM's, which shares no code with ours. `eye` in world coordinates.
Mat4 textbookMatrix(const Vec3& eye, const Vec3& forward, const Vec3& up, Hand hand, ClipDepth depth, Angle fovy, double aspect,
                    double nearDistance, double farDistance) {
    const double f = fovy.radians();
    const auto project = [&](double from, double to) {
        if (depth == ClipDepth::MinusOneToOne)
            return hand == Hand::Right ? glm::perspectiveRH_NO(f, aspect, from, to) : glm::perspectiveLH_NO(f, aspect, from, to);
        return hand == Hand::Right ? glm::perspectiveRH_ZO(f, aspect, from, to) : glm::perspectiveLH_ZO(f, aspect, from, to);
    };
    const Mat4 projection =
        depth == ClipDepth::ReversedZeroToOne ? project(farDistance, nearDistance) : project(nearDistance, farDistance);
    const Mat4 look = hand == Hand::Right ? glm::lookAtRH(eye, eye + forward, up) : glm::lookAtLH(eye, eye + forward, up);
    return projection * look;
}

/// The same view by makeFrustum. The x axis of a left-handed camera points to the opposite side: what it shows on the left, a
/// right-handed one with the same axes shows on the right.
Frustum frustumOf(const Vec3& forward, const Vec3& up, Hand hand, Angle fovy, double aspect, double nearDistance,
                  double farDistance) {
    const double tall = std::tan(fovy.radians() / 2);
    Vec3 right = glm::normalize(glm::cross(forward, up));
    const Vec3 upward = glm::cross(right, forward);
    if (hand == Hand::Left) right = -right;
    return makeFrustum(forward, right, upward, tall * aspect, tall, nearDistance, farDistance);
}

TEST(FrustumPlanes, rowsCornersAndMakeFrustumAgree) {
    Random random(31);
    double worstAngle = 0.0, worstOffset = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 forward = random.direction();
        const Vec3 up = glm::cross(forward, random.direction());
        if (glm::length(up) < 0.1) continue;
        const Angle fovy = Angle::fromDegrees(random.between(1, 150));
        const double aspect = std::pow(2.0, random.between(-4, 4));
        const double nearDistance = std::pow(10.0, random.between(-3, 3));
        const double farDistance = nearDistance * std::pow(10.0, random.between(0.1, 4));
        for (const Hand hand : {Hand::Right, Hand::Left})
            for (const ClipDepth depth : kDepths) {
                const Mat4 clip = textbookMatrix(Vec3(0), forward, up, hand, depth, fovy, aspect, nearDistance, farDistance);
                const auto rows = planesFromRows(clip, depth);
                const auto corners = planesFromCorners(clip, depth);
                ASSERT_TRUE(rows && corners) << i;
                const FrustumPlanes exact = frustumOf(forward, up, hand, fovy, aspect, nearDistance, farDistance).planes;
                for (const PlaneDifference& difference :
                     {largestDifference(*rows, *corners), largestDifference(*rows, exact), largestDifference(*corners, exact)}) {
                    worstAngle = std::max(worstAngle, difference.angle.radians());
                    worstOffset = std::max(worstOffset, difference.offset / farDistance);
                }
            }
    }
    // At a far distance of 10,000 × near, four of sixteen digits are lost.
    EXPECT_LT(worstAngle, 1e-10);
    EXPECT_LT(worstOffset, 1e-10);
}

TEST(FrustumPlanes, viewFarFromTheOriginHasTheMovedPlanes) {
    Random random(32);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 forward = random.direction();
        const Vec3 up = glm::cross(forward, random.direction());
        const Vec3 eye = random.direction() * 1000.0;
        if (glm::length(up) < 0.1) continue;
        const Mat4 clip =
            textbookMatrix(eye, forward, up, Hand::Right, ClipDepth::ZeroToOne, Angle::fromDegrees(60), 1.5, 1, 100);
        FrustumPlanes exact = frustumOf(forward, up, Hand::Right, Angle::fromDegrees(60), 1.5, 1, 100).planes;
        for (Plane& plane : exact) plane.offset -= glm::dot(plane.normal, eye);
        for (const auto& planes : {planesFromRows(clip, ClipDepth::ZeroToOne), planesFromCorners(clip, ClipDepth::ZeroToOne)}) {
            ASSERT_TRUE(planes);
            EXPECT_LT(largestDifference(*planes, exact).angle.radians(), 1e-10);
            EXPECT_LT(largestDifference(*planes, exact).offset, 1e-8);
        }
    }
}

TEST(FrustumPlanes, mirroredOrUpsideDownMatrixPointsItsNormalsInward) {
    Random random(33);
    const Frustum frustum = frustumOf({0, 0, -1}, {0, 1, 0}, Hand::Right, Angle::fromDegrees(70), 1.6, 0.5, 50);
    for (const ClipDepth depth : kDepths) {
        const Mat4 clip =
            textbookMatrix(Vec3(0), {0, 0, -1}, {0, 1, 0}, Hand::Right, depth, Angle::fromDegrees(70), 1.6, 0.5, 50);
        for (const Vec3 scale : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(-1, -1, 1)}) {
            // Mirrored in the picture (x/w and y/w change sign) and in the world.
            for (const Mat4& mirrored : {glm::scale(Mat4(1.0), scale) * clip, clip * glm::scale(Mat4(1.0), scale)}) {
                const auto rows = planesFromRows(mirrored, depth);
                const auto corners = planesFromCorners(mirrored, depth);
                ASSERT_TRUE(rows && corners);
                EXPECT_LT(largestDifference(*rows, *corners).angle.radians(), 1e-12);
                for (int i = 0; i < 100; ++i) {
                    const Vec3 point(random.between(-60, 60), random.between(-60, 60), random.between(-60, 5));
                    bool in = true, inRows = true;
                    for (size_t p = 0; p < 6; ++p) {
                        in = in && frustum.planes[p].distance(point) >= 0;
                        inRows = inRows && (*rows)[p].distance(point) >= 0;
                    }
                    EXPECT_EQ(in, inRows) << "this frustum is symmetric: mirroring changes no more than the names of its sides";
                }
                const Vec3 onTheRight(30, 0, -10);
                EXPECT_LT((*rows)[scale.x < 0 ? 0 : 1].distance(onTheRight), 0.0) << "left is where x/w = -1";
            }
        }
    }
}

TEST(FrustumPlanes, orthographicViewHasItsPlanes) {
    const Mat4 clip = glm::orthoRH_ZO(-3.0, 5.0, -1.0, 2.0, 0.5, 20.0);
    const auto rows = planesFromRows(clip, ClipDepth::ZeroToOne);
    const auto corners = planesFromCorners(clip, ClipDepth::ZeroToOne);
    ASSERT_TRUE(rows && corners);
    EXPECT_LT(largestDifference(*rows, *corners).offset, 1e-13);
    EXPECT_LT(largestDifference(*rows, *corners).angle.radians(), 1e-13);
    const FrustumPlanes exact{Plane{{1, 0, 0}, 3},  Plane{{-1, 0, 0}, 5},    Plane{{0, 1, 0}, 1},
                              Plane{{0, -1, 0}, 2}, Plane{{0, 0, -1}, -0.5}, Plane{{0, 0, 1}, 20}};
    EXPECT_LT(largestDifference(*rows, exact).offset, 1e-13);
    EXPECT_LT(largestDifference(*rows, exact).angle.radians(), 1e-13);
}

TEST(FrustumPlanes, extremeRatioLosesWhatItsCommentSays) {
    // Near : far = 1e-6 : 1e9. The reversed matrix as View builds it; GLM's, called with far and near exchanged, cancels during
    // its construction.
    const double n = 1e-6, f = 1e9;
    Mat4 reversed(0.0);
    reversed[0][0] = reversed[1][1] = 1.0;
    reversed[2][2] = n / (f - n);
    reversed[2][3] = -1.0;
    reversed[3][2] = n * (f / (f - n));
    const auto clip = [&](ClipDepth depth) {
        if (depth == ClipDepth::ReversedZeroToOne) return reversed;
        return textbookMatrix(Vec3(0), {0, 0, -1}, {0, 1, 0}, Hand::Right, depth, Angle::fromDegrees(90), 1, n, f);
    };
    for (const ClipDepth depth : kDepths) {
        const auto rows = planesFromRows(clip(depth), depth);
        ASSERT_TRUE(rows);
        const double lost = std::abs((*rows)[5].offset / f - 1.0);
        std::printf("far plane from rows, depth %d: off by %.3g of its distance; near by %.3g\n", int(depth), lost,
                    std::abs((*rows)[4].offset / -n - 1.0));
        EXPECT_LT(std::abs((*rows)[4].offset / -n - 1.0), 1e-14) << "near loses nothing";
        if (depth == ClipDepth::ReversedZeroToOne) {
            EXPECT_LT(lost, 1e-14);
            continue;
        }
        EXPECT_GT(lost, 1e-4) << "what the comment says is lost was not";
        EXPECT_LT(lost, 0.5);
    }
    const Frustum made = makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1, 1, n, f);
    EXPECT_EQ(made.planes[4].offset, -n);
    EXPECT_EQ(made.planes[5].offset, f);
    const auto corners = planesFromCorners(reversed, ClipDepth::ReversedZeroToOne);
    ASSERT_TRUE(corners);
    EXPECT_LT(largestDifference(*corners, made.planes).angle.radians(), 1e-13);
}

TEST(FrustumPlanes, matrixWithoutPlanesGivesNone) {
    const Mat4 good =
        textbookMatrix(Vec3(0), {0, 0, -1}, {0, 1, 0}, Hand::Right, ClipDepth::ZeroToOne, Angle::fromDegrees(90), 1, 1, 9);
    Mat4 flat = good, notANumber = good, endless(0.0);
    for (int column = 0; column < 4; ++column) flat[column][0] = 0.0;
    notANumber[2][1] = std::nan("");
    // A far plane at infinity: z/w = near / distance.
    endless[0][0] = endless[1][1] = 1.0;
    endless[2][3] = -1.0;
    endless[3][2] = 0.1;
    for (const auto planes : {planesFromRows, planesFromCorners}) {
        EXPECT_TRUE(planes(good, ClipDepth::ZeroToOne));
        EXPECT_FALSE(planes(Mat4(0.0), ClipDepth::ZeroToOne));
        EXPECT_FALSE(planes(flat, ClipDepth::ZeroToOne));
        EXPECT_FALSE(planes(notANumber, ClipDepth::ZeroToOne));
        EXPECT_FALSE(planes(endless, ClipDepth::ReversedZeroToOne));
    }
    // Corners behind the eye: their hull is not the view.
    EXPECT_FALSE(planesFromCorners(
        textbookMatrix(Vec3(0), {0, 0, -1}, {0, 1, 0}, Hand::Right, ClipDepth::ZeroToOne, Angle::fromDegrees(90), 1, -1, 9),
        ClipDepth::ZeroToOne));
}

// The control: Orangelie's pseudo-code as printed (left-handed, row vectors, depth 0 … 1).

Plane getNormalFromPoints(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
    const Vec3 normal = glm::cross(p1 - p2, p1 - p3);
    return {normal, -glm::dot(normal, p1)};
}

struct Printed {
    std::array<Vec3, 8> vertices;
    Plane nearPlane, farPlane, left, right, bottom, up;
};

Printed asPrinted(const Mat4& clip) {
    const Mat4 inverse = glm::inverse(clip);
    Printed blog;
    const std::array<Vec3, 8> cube{Vec3(-1, 1, 0), Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, -1, 0),
                                   Vec3(-1, 1, 1), Vec3(1, 1, 1), Vec3(1, -1, 1), Vec3(-1, -1, 1)};
    // A row vector times a matrix is the transposed matrix times the vector; the division by w is missing.
    for (size_t i = 0; i < 8; ++i) blog.vertices[i] = Vec3(inverse * Vec4(cube[i], 1.0));
    const auto& v = blog.vertices;
    blog.nearPlane = getNormalFromPoints(v[0], v[1], v[2]);
    blog.farPlane = getNormalFromPoints(v[4], v[7], v[5]);
    blog.left = getNormalFromPoints(v[0], v[1], v[2]);
    blog.right = getNormalFromPoints(v[0], v[1], v[2]);
    blog.bottom = getNormalFromPoints(v[0], v[1], v[2]);
    blog.up = getNormalFromPoints(v[0], v[1], v[2]);
    return blog;
}

TEST(BlogAsPrinted, keepsNothingOutWhereTheMendedFormDoes) {
    const Mat4 clip =
        textbookMatrix(Vec3(0), {0, 0, 1}, {0, 1, 0}, Hand::Left, ClipDepth::ZeroToOne, Angle::fromDegrees(90), 1, 2, 10);
    const Printed blog = asPrinted(clip);
    for (const Plane& side : {blog.left, blog.right, blog.bottom, blog.up}) {
        EXPECT_EQ(side.normal, blog.nearPlane.normal) << "a side of its own";
        EXPECT_EQ(side.offset, blog.nearPlane.offset);
    }
    EXPECT_GT(std::abs(glm::length(blog.nearPlane.normal) - 1.0), 0.1) << "a unit normal";
    EXPECT_GT(glm::distance(blog.vertices[0], Vec3(-2, 2, 2)), 0.5) << "a near corner";
    EXPECT_GT(glm::distance(blog.vertices[4], Vec3(-10, 10, 10)), 0.5) << "a far corner";

    // Far out to the left: our planes cull it; the printed ones cannot distinguish it from one in the middle of the view.
    const auto culled = [](const Plane& plane, const Vec3& centre, double radius) { return plane.distance(centre) > radius; };
    const Vec3 middle(0, 0, 5), aside(-500, 0, 5);
    for (const Plane& plane : {blog.nearPlane, blog.farPlane, blog.left, blog.right, blog.bottom, blog.up})
        EXPECT_EQ(culled(plane, middle, 1), culled(plane, aside, 1)) << "the sides keep something out";
    const auto mended = planesFromCorners(clip, ClipDepth::ZeroToOne);
    ASSERT_TRUE(mended);
    EXPECT_LT((*mended)[size_t(FrustumPlane::Left)].distance(aside), -1.0);
    for (const Plane& plane : *mended) EXPECT_GT(plane.distance(middle), 1.0);
}

}  // namespace
}  // namespace cullscope::frustum_planes_test
