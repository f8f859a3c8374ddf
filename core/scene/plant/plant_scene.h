#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

struct PlantOptions {
    size_t pipelines = 100;
    uint64_t seed = 1;
    /// The largest distance of triangles from the primitives' surfaces, in metres; 0: pipes have 8, 12 or 16 chords by their
    /// size, equipment 12 to 32. The fewer segments of the strategy level-of-detail begin with these.
    double chordError = 0.0;
};
inline constexpr double kLeastChordError = 1e-4, kMostChordError = 0.1;
inline constexpr double kMostPipelines = 1e6;

/// A process plant of pipe racks with equipment beside them, connected by so many pipelines: pipes, elbows, tees, reducers,
/// flanges with bolts and nuts, valves, supports; columns, vessels, tanks, exchangers, pumps; steel, platforms with rails.
/// Metres, z up. Objects are components of primitives (SceneRemarks::components), named and grouped by pipeline or item; equal
/// ones share a mesh. The same bits on every machine for a seed. Throws Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer plantScene(std::string name, const PlantOptions& options, const Progress& progress = {});

}  // namespace cullscope
