#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/mesh/byte_source.h"
#include "core/mesh/primitive/primitive.h"

/// AVEVA's (PDMS's) binary RVM files, the exchange format of process plants: big-endian records, each with the place of the next.
namespace cullscope::rvm {

/// A polygon of a facet group: its outline and then its holes. Corners in the record's own coordinates.
struct Polygon {
    std::vector<std::vector<Vec3>> contours;
};

/// One primitive of a file (a record PRIM, OBST or INSU).
struct Record {
    enum class Kind { Solid, Facets, Line } kind = Kind::Solid;
    primitive::Primitive solid;  ///< of Kind::Solid, in the record's own unit
    std::vector<Polygon> polygons;
    Vec2 line{0.0};             ///< both ends, on the x axis
    Mat4 worldFromRecord{1.0};  ///< to metres
    Box3 box;                   ///< that the file states, in the record's own coordinates
    uint64_t byte = 0;          ///< where it begins in the file
};

/// What a file holds, as it comes.
struct Visitor {
    std::function<void(std::string name)> beginGroup;
    std::function<void()> endGroup;
    std::function<void(Record&& record)> primitive;
};

/// Whether a file begins as one does.
[[nodiscard]] bool isRvm(ByteSource& source);

/// Reads a file from its begin. Throws Error(Input) with a sentence that names the file, the byte and the defect, for a file that
/// breaks off, whose records do not end where they say, or that has counts which it does not contain. A text RVM file is refused,
/// too. Whether a solid is possible is left to the caller.
void readRecords(ByteSource& source, const Visitor& visitor);

}  // namespace cullscope::rvm
