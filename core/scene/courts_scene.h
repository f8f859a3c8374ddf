#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

struct Courts {
    size_t n = 4;        ///< courts along each side
    double walls = 1.1;  ///< their height, as a share of the scene's; 0: there are none
};
inline constexpr size_t kWallsOfACourt = 4, kTrianglesOfAWall = 12;
inline constexpr double kMostCourts = 1000;  ///< along each side

/// n × n copies of a scene on its ground, which share its meshes, each in a court with four walls of its own and an alley to its
/// neighbours. The court whose copy lies where the scene does comes first: its objects have the scene's order and names, its
/// walls follow. From below the top of walls that are higher than the scene no other court can be seen. The same for the same
/// scene. Throws Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer courtsScene(std::string name, const Scene& one, const Courts& courts, const Progress& progress = {});

/// How many objects a court of `one` has, with its walls.
[[nodiscard]] size_t objectsOfACourt(const Scene& one, const Courts& courts);

/// The first court alone, of a scene of so many courts along each side. The scene must be such a one.
[[nodiscard]] ScenePointer firstCourt(const Scene& courts, size_t n);

}  // namespace cullscope
