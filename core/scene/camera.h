#pragma once

#include <optional>
#include <string_view>

#include "core/geometry/angle.h"
#include "core/geometry/frustum.h"
#include "core/geometry/types.h"

namespace cullscope {

/// The world axis that points up on the screen.
enum class UpAxis { Y, Z };

enum class ProjectionKind {
    Perspective,  ///< lines of sight meet in the eye
    Parallel      ///< lines of sight run along the view direction: an eye at infinity
};
/// The id used in files and on the command line: "perspective", "parallel".
[[nodiscard]] const char* projectionId(ProjectionKind projection);
[[nodiscard]] std::optional<ProjectionKind> projectionFromId(std::string_view id);

/// A camera in world coordinates. Of a parallel one the eye is the middle of the plane from which near and far are counted.
struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};
    Vec3 up{0.0, 1.0, 0.0};
    Angle fovy = Angle::fromDegrees(45.0);  ///< the full vertical angle, in (0, 180°); of a parallel camera without effect
    double nearDistance = 0.05;
    double farDistance = 1000.0;
    ProjectionKind projection = ProjectionKind::Perspective;
    double height = 2.0;  ///< of a parallel camera's view volume, in scene units, above 0; else without effect

    bool operator==(const Camera&) const = default;
};

/// The largest width and height of a picture, in pixels.
inline constexpr int kMostPixels = 16384;

/// The height of what a camera shows at its target.
[[nodiscard]] double heightAtTarget(const Camera& camera);
/// The same camera as a parallel one that shows the target as large. The eye stays.
[[nodiscard]] Camera inParallel(const Camera& camera);
/// The same camera as a perspective one that shows the target as large: its eye moves along the view direction.
[[nodiscard]] Camera inPerspective(const Camera& camera);

/// Size in pixels.
struct Viewport {
    int width = 640;
    int height = 480;

    bool operator==(const Viewport&) const = default;
};

/// Throws Error(Usage) where camera and size define no picture: values that are not finite, eye at the target, fovy outside (0,
/// 180°), near not in (0, far), a parallel camera's height not above 0, a size below 1 or above 16384.
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
    /// A plane in world coordinates whose other side pictures of the view do not show (scene/section.h). Culling knows of none.
    [[nodiscard]] const std::optional<Plane>& section() const { return m_section; }
    void cutBy(const std::optional<Plane>& section) { m_section = section; }
    /// Relative to the eye; see Frustum.
    [[nodiscard]] const Frustum& frustum() const { return m_frustum; }

    /// The clip matrix for world axes with the origin at the eye.
    [[nodiscard]] const Mat4& clipFromEyeRelative() const { return m_clipFromEyeRelative; }
    /// The float matrix that transforms a mesh's float positions to clip space on the GPU: all translations are summed in double
    /// before rounding.
    [[nodiscard]] Mat4f clipFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const;
    /// The float matrix that transforms a mesh's float positions to vectors along the lines of sight, in world axes (for
    /// shading): from the eye to the position; in a parallel view the view direction for each.
    [[nodiscard]] Mat4f sightFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const;
    /// The direction (not normalised: forward component 1) through a point of the picture; pixel centres lie at +0.5,
    /// y counts upward as in OpenGL. In a parallel view the same everywhere.
    [[nodiscard]] Vec3 direction(double x, double y) const;
    /// Where the line of sight through a point of the picture begins, relative to the eye: 0 in perspective.
    [[nodiscard]] Vec3 sightOrigin(double x, double y) const;
    /// The place at a distance ahead of the eye on that line, in the world.
    [[nodiscard]] Vec3 pointAt(double x, double y, double ahead) const {
        return m_camera.eye + sightOrigin(x, y) + ahead * direction(x, y);
    }
    /// Distance along the forward axis from a reversed depth sample; +infinity for 0 when far is infinite.
    [[nodiscard]] double distanceFromDepth(double depth) const;
    [[nodiscard]] double depthFromDistance(double forwardDistance) const;
    /// The reversed depth at a point of the picture of the plane normal·p = offset, p relative to the eye: affine in the picture.
    [[nodiscard]] double depthOfPlane(const Vec3& normal, double offset, double x, double y) const;

private:
    Camera m_camera;
    Viewport m_viewport;
    Frustum m_frustum;
    std::optional<Plane> m_section;
    Mat4 m_clipFromEyeRelative{1.0};
};

}  // namespace cullscope
