#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/cause.h"
#include "core/geometry/frustum.h"

namespace cullscope {

/// What a decision is about.
struct Subject {
    enum class Kind : uint8_t {
        Object,    ///< `number`: the instance
        Node,      ///< `number`: of a node of the strategy's structure over objects
        Cell,      ///< `number`: of a cell of the structure that the strategy has for `object`
        Ray,       ///< `number`: of a ray from the eye that the strategy follows for `object`
        Band,      ///< `number`: of a part of the curve (frame/curve.h) that the strategy has for `object`
        Fragment,  ///< `number`: of a part of a triangle
        Rows,      ///< `number`: of a row of pixels, from the bottom; of several rows the first one
        Span,      ///< `number`: of a piece of a row of pixels
        Cells,  ///< `number`: of a group of cells, such as a range of them, of the structure that the strategy has for `object`
        Triangles  ///< `number`: of a triangle in the mesh of `object`; of several consecutive ones the first one
    };
    static constexpr uint32_t kNoObject = 0xFFFFFFFF;

    Kind kind = Kind::Object;
    uint32_t number = 0;
    uint32_t object = kNoObject;  ///< the instance that it belongs to; kNoObject: several

    [[nodiscard]] static Subject ofObject(uint32_t instance) { return {Kind::Object, instance, instance}; }
    [[nodiscard]] static Subject ofNode(uint32_t node) { return {Kind::Node, node, kNoObject}; }
    [[nodiscard]] static Subject ofCell(uint32_t cell, uint32_t instance) { return {Kind::Cell, cell, instance}; }
    [[nodiscard]] static Subject ofTriangles(uint32_t first, uint32_t instance) { return {Kind::Triangles, first, instance}; }
    /// Whether a decision about it may say which triangles of `object` it has (Decision::places).
    [[nodiscard]] bool holdsTriangles() const { return kind == Kind::Cell || kind == Kind::Cells || kind == Kind::Triangles; }
    bool operator==(const Subject&) const = default;
};

/// A range of triangles by their places in an order.
struct PlaceRun {
    uint32_t first = 0, count = 0;

    bool operator==(const PlaceRun&) const = default;
};

/// One test of a subject, or what became of it, as it happened.
struct Decision {
    enum class Outcome : uint8_t {
        Open,          ///< a test; what becomes of the subject is decided after it
        Drawn,         ///< drawn completely
        PartlyDrawn,   ///< drawn in part
        Culled,        ///< nothing of it is drawn
        DrawnAfterAll  ///< drawn, although an earlier decision, whose cause this one repeats, had culled it
    };
    static constexpr size_t kOperands = 5;

    Subject subject;
    Outcome outcome = Outcome::Open;
    Containment containment = Containment::Straddles;  ///< what the test found
    Cause cause = Cause::OutsideFrustum;               ///< of what is not drawn, with PartlyDrawn and Culled
    std::optional<FrustumPlane> plane;                 ///< of a plane test
    /// English, marked for translation: %1, %2, … are the plane's name (where there is one), then the operands. Null: the
    /// sentence that every decision of this outcome has.
    const char* sentence = nullptr;
    /// Of a plane test the signed distance of the bounds' point farthest inside, and the margin, in scene units: outside only
    /// below −margin.
    std::array<double, kOperands> operands{};
    uint8_t operandCount = 0;
    uint8_t nesting = 0;  ///< how many subjects, whose decisions came before, this one lies in
    /// Of a Cell, Cells or Triangles: its triangles, in the order FrameLog::order. Of a Fragment: its triangles among the
    /// strategy's own that are drawn next. Of Rows or a Span that are shown: from the lower left to the upper right pixel, which
    /// are numbered row by row from the bottom. None: not said.
    PlaceRun places;
    uint32_t firstObject = 0;  ///< of a Node that is decided as a whole: its objects, in FrameLog::objects
    uint32_t objectCount = 0;
    uint32_t commands = 0;  ///< number of the frame's commands before it
    uint8_t line = 0;       ///< the line of the strategy's listing (frame/listing.h) at which it fell, from 1; 0: none

    [[nodiscard]] double distance() const { return operands[0]; }
    [[nodiscard]] double margin() const { return operands[1]; }
};

/// The same decision with the line of the strategy's listing at which it falls. `Line`: an enumeration of the lines, from 1.
template <typename Line>
[[nodiscard]] Decision atLine(Line line, Decision decision) {
    decision.line = static_cast<uint8_t>(line);
    return decision;
}

}  // namespace cullscope
