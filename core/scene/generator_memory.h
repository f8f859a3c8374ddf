#pragma once

#include <string>

#include "core/mesh/load.h"

namespace cullscope {

/// Bytes that generators take at their peak, measured with a million of each and more.
inline constexpr double kBytesOfMadeTriangle = 40.0;  ///< of a parametric shape: 36 of a divided icosahedron, 24 of grids
inline constexpr double kBytesOfInstance = 300.0;     ///< with its name and its bounds in the scene
inline constexpr double kBytesOfPipeline = 24'000.0;  ///< of a process plant, with its share of equipment and steel

// What a pipeline of a process plant brings along, on average; measured with 100 and with 1000 of them.
inline constexpr double kTrianglesOfPipeline = 4'600.0;
inline constexpr double kObjectsOfPipeline = 53.0;

/// Throws Error(Usage) naming the generator where a scene of so many bytes, by the numbers that were asked for, takes more than
/// `options` allow (LoadOptions::memoryLimitBytes): the limit that files have. Call it before anything is allocated.
void requireGeneratorMemory(const std::string& generator, double bytes, const LoadOptions& options);

}  // namespace cullscope
