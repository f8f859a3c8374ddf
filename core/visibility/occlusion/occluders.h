#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/frame/decision.h"
#include "core/frame/draw_list.h"
#include "core/raster/occlusion_buffer.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/spatial/occluder_mesh.h"

namespace cullscope::occlusion {

/// What may hide the rest of a scene: of each mesh its largest triangles, and how instances stretch them.
struct Occluders {
    std::vector<OccluderMesh> meshes;   ///< by mesh
    std::vector<double> areaOfSquares;  ///< by instance: the area of a square of the mesh's unit, in the world

    Occluders() = default;
    /// Throws Error(Interrupted) soon after a stop is requested.
    explicit Occluders(const Scene& scene, const Progress& progress = {});

    [[nodiscard]] uint64_t bytes() const;
    /// How many of an instance's largest triangles have so many pixels each on average, where they face the eye at the nearest
    /// point of the instance's box.
    [[nodiscard]] size_t countFrom(const Scene& scene, uint32_t instance, const View& view, double pixels) const;
};

/// The area in the world that has `pixels` pixels where it faces the eye, `distance` from it.
[[nodiscard]] double areaOfPixels(const View& view, double distance, double pixels);

/// A world box as an occlusion buffer is asked about it.
struct AskedBox {
    std::optional<BoxInPicture> place;  ///< none: it reaches before the near plane, and counts as visible
    double nearest = 0.0;               ///< distance ahead of the eye, grown
    double growth = 0.0;                ///< towards the eye, world units
};

/// Lets the box grow for the question (visibility/eye_bounds.h): by its rounding on each side, and towards the eye by a pixel's
/// width besides, for depths that OpenGL interpolates at a pixel's centre beside an edge. So nothing visible is hidden by it.
[[nodiscard]] AskedBox askedBox(const OcclusionBuffer& buffer, const Box3& world, const View& view);
/// The same of a box relative to the eye; `margin`: of its plane tests.
[[nodiscard]] AskedBox askedBox(const OcclusionBuffer& buffer, EyeBox box, double margin, const View& view);
/// A test whether occluders hide something, without its subject.
[[nodiscard]] Decision hidingTest(bool hidden, const char* sentence, std::initializer_list<double> operands);
/// That of a box: the question with its answer.
[[nodiscard]] Decision askedDecision(const OcclusionBuffer& buffer, const AskedBox& asked, bool hidden, const View& view);

}  // namespace cullscope::occlusion
