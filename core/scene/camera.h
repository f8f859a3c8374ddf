#pragma once

#include "core/geometry/angle.h"
#include "core/geometry/frustum.h"
#include "core/geometry/types.h"

namespace cullscope {

/// The world axis that points up on the screen.
enum class UpAxis { Y, Z };

/// A perspective camera in world coordinates.
struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};
    Vec3 up{0.0, 1.0, 0.0};
    Angle fovy = Angle::fromDegrees(45.0);  ///< the full vertical angle, in (0, 180°)
    double nearDistance = 0.05;
    double farDistance = 1000.0;

    bool operator==(const Camera&) const = default;
};

/// The largest width and height of a picture, in pixels.
inline constexpr int kMostPixels = 16384;

/// Size in pixels.
struct Viewport {
    int width = 640;
    int height = 480;

    bool operator==(const Viewport&) const = default;
};

/// Throws Error(Usage) where camera and size define no picture: values that are not finite, eye at the target, fovy outside (0,
/// 180°), near not in (0, far), a size below 1 or above 16384.
void validate(const Camera& camera, const Viewport& viewport);

/// A camera with a viewport and what follows from them: basis, frustum, matrices. In double precision; GPU matrices are relative
/// to the eye. Clip space is OpenGL's with depth 0 … 1 reversed: 1 at the near plane, 0 at the far plane.
class View {
public:
    /// Validates (see above). Where `up` is parallel to the view direction, another axis is used in its place.
    View(const Camera& camera, const Viewport& viewport);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
    [[nodiscard]] const Vec3& eye() const { return m_camera.eye; }
    /// Relative to the eye; see Frustum.
    [[nodiscard]] const Frustum& frustum() const { return m_frustum; }

    /// The clip matrix for world axes with the origin at the eye.
    [[nodiscard]] const Mat4& clipFromEyeRelative() const { return m_clipFromEyeRelative; }
    /// The float matrix that transforms a mesh's float positions to clip space on the GPU: all translations are summed in double
    /// before rounding.
    [[nodiscard]] Mat4f clipFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const;
    /// The float matrix that transforms a mesh's float positions to world axes with the origin at the eye (for shading).
    [[nodiscard]] Mat4f eyeRelativeFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const;
    /// The direction (not normalised: forward component 1) through a point of the picture; pixel centres lie at +0.5,
    /// y counts upward as in OpenGL.
    [[nodiscard]] Vec3 direction(double x, double y) const;
    /// Distance along the forward axis from a reversed depth sample; +infinity for 0 when far is infinite.
    [[nodiscard]] double distanceFromDepth(double depth) const;
    [[nodiscard]] double depthFromDistance(double forwardDistance) const;

private:
    Camera m_camera;
    Viewport m_viewport;
    Frustum m_frustum;
    Mat4 m_clipFromEyeRelative{1.0};
};

}  // namespace cullscope
