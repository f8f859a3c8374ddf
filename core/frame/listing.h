#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// A line of a strategy's pseudo-code.
struct ListingLine {
    std::string text;         ///< English, marked for translation
    uint8_t indentation = 0;  ///< levels
};
/// A listing has no more lines.
inline constexpr size_t kMostListingLines = 10;

/// Where the decisions of a recorded frame fell in a listing. Of the first entries of a log (FrameLog::upTo) it is the state
/// after them.
struct ListingState {
    std::vector<uint64_t> decisions;  ///< by line, from the first: how many fell there
    uint8_t current = 0;              ///< the line of the last decision that has a line, from 1; 0: there is none

    [[nodiscard]] uint64_t total() const;
    bool operator==(const ListingState&) const = default;
};

/// The state of a listing of so many lines after all decisions of a log.
[[nodiscard]] ListingState listingState(const FrameLog& log, size_t lines);
/// The same of the decisions about one triangle alone (its number in the scene): those about its object, about the nodes that
/// contain the object, and, of the object's cells and of parts of triangles, about those that contain the triangle or are of it,
/// with the nodes around these. `current` is the line that decided what became of it. The log is of a whole frame of the scene.
[[nodiscard]] ListingState listingState(const Scene& scene, const FrameLog& log, size_t lines, uint64_t triangle);

}  // namespace cullscope
