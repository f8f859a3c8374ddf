#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/map_circles.h"
#include "core/frame/triangle_state.h"
#include "core/frame/words.h"
#include "core/geometry/spherical_grid.h"

namespace cullscope {

/// What something over a map means; each looks different.
enum class MapSymbol : uint8_t {
    Region,      ///< the outline of what is seen
    Box,         ///< a rectangle of cells
    Hit,         ///< a place that was hit
    Miss,        ///< a place in place of a hit
    Walked,      ///< a cell that was walked through
    Circle,      ///< of MapCircles
    RightAngle,  ///< the circle at 90°
    Part,        ///< the edges of the shown part (CellMapSource::partEdges)
    Start,       ///< where the axis starts
    End,         ///< where it ends
    Cell,        ///< the border of a cell of the strategy's own (CellMapSource::outlines)
    Horizon,     ///< a line behind which all is hidden
    Picked,      ///< the picked triangle's cells
    Cells        ///< a cell's colour
};

/// One of the colourings of a map's cells.
struct MapColouring {
    std::string id;  ///< on the command line and in metadata
    Words name;
    Words scale{};        ///< the meaning of its colours, with the unit; none for states
    bool states = false;  ///< by the cells' states; else by their values
    bool fixed = false;   ///< it depends on nothing but CellMapSource::key()
};

/// A line over a map through points (θ, φ) in radians, with φ continued over the seam (below 0 or beyond 2π where it crosses).
struct MapCurve {
    MapSymbol symbol = MapSymbol::Region;
    std::vector<Vec2> points;
    bool closed = false;           ///< the last point is connected with the first
    std::optional<double> pole{};  ///< of a line around the axis: θ of the edge of the map on whose side its inside lies
};

/// A place (θ, φ) in radians with a number beside it and words about it.
struct MapMark {
    MapSymbol symbol = MapSymbol::Hit;
    Vec2 place{0.0};
    uint32_t number = 0;
    Words words;
};

struct MapLegendEntry {
    MapSymbol symbol = MapSymbol::Cells;
    Words words;
};

/// A legend for which room is reserved: what may stand in one at once. Most maps show fewer states.
struct MapLegendRoom {
    std::vector<TriangleState> states;       ///< where cells are coloured by state
    std::vector<TriangleState> otherStates;  ///< in all other colourings
    std::vector<MapLegendEntry> entries;
};

/// The values of a map's cells in one colouring.
struct MapValues {
    std::vector<float> shares;  ///< by cell number, in [0, 1]; below 0: the cell is empty
    Term least, most;           ///< the values at 0 and 1
};

/// What is made of a map on demand, because all of it would be large: what is said of cells and triangles, which are numbered
/// within the object's mesh, and lines of which only some are drawn. Thread-safe.
class CellMapSource {
public:
    virtual ~CellMapSource() = default;

    /// What the fixed colourings and the triangles of cells are read from: as long as two sources exist and have the same key,
    /// they have the same.
    [[nodiscard]] virtual const void* key() const = 0;
    /// The triangles that belong to a cell, the one that a click picks first at the end. Each belongs to one cell.
    [[nodiscard]] virtual std::span<const uint32_t> owned(uint32_t cell) const = 0;
    /// The triangles that lie in a cell, wholly or in part, in the same order.
    [[nodiscard]] virtual std::span<const uint32_t> touching(uint32_t cell) const = 0;
    [[nodiscard]] virtual SphericalGrid::Cell ownerOf(uint32_t triangle) const = 0;
    [[nodiscard]] virtual std::vector<SphericalGrid::Cell> cellsOf(uint32_t triangle) const = 0;

    /// Of a colouring by values.
    [[nodiscard]] virtual MapValues values(std::string_view colouring) const = 0;
    /// The states by cell number, without the truth: what is drawn counts as visible. None where a cell owns no triangle.
    [[nodiscard]] virtual const std::vector<std::optional<TriangleState>>& states() const = 0;
    /// Of a cell that owns no triangle: the state of what the strategy decided about its direction; none: nothing was.
    [[nodiscard]] virtual std::optional<TriangleState> stateBetween(uint32_t /*cell*/) const { return std::nullopt; }
    /// What is said of a cell, but its state.
    [[nodiscard]] virtual std::vector<Words> words(uint32_t cell) const = 0;

    /// The borders of the strategy's own cells that extend at least `leastSize` (radians) in both θ and φ, as lines like those of
    /// MapCurve.
    [[nodiscard]] virtual std::vector<std::vector<Vec2>> outlines(double /*leastSize*/) const { return {}; }
    /// The edges of a part (CellMap::parts) as lines like those of MapCurve, and what is said of them.
    [[nodiscard]] virtual std::vector<std::vector<Vec2>> partEdges(uint32_t /*part*/) const { return {}; }
    [[nodiscard]] virtual Words partWords(uint32_t /*part*/) const { return {}; }
};

/// The directions from a point in an object, divided into cells of zenith angle and azimuth, with what a strategy decided about
/// them, as plain data: a kind of what strategies show (visibility/show.h). Texts are English, marked for translation.
struct CellMap {
    Words title;
    uint32_t object = 0;  ///< instance
    SphericalGrid grid;
    std::vector<MapColouring> colourings;  ///< that it has; the first is the default

    Words objectWords, decisionWords;
    std::vector<Words> lines{};  ///< further words
    uint32_t lineRoom = 0;       ///< lines of text for which room is reserved

    bool veiled = false;  ///< hidden cells are veiled where the colouring is not by states
    std::optional<MapCircles> circles{};
    std::optional<Vec3> axis{};  ///< a direction from which something is seen; its start and its end are marked
    std::vector<SphericalGrid::Cell> walked{};
    std::vector<SphericalGrid::Box> boxes{};
    std::vector<MapCurve> curves{};
    std::vector<MapMark> marks{};
    uint32_t parts = 0;  ///< the parts whose edges can be shown are numbered from 1
    std::vector<MapLegendEntry> legend{};
    std::vector<MapLegendRoom> rooms{};

    std::shared_ptr<const CellMapSource> source;

    /// The colouring with this id; null where it has none.
    [[nodiscard]] const MapColouring* colouring(std::string_view id) const;
};
using CellMapPointer = std::shared_ptr<const CellMap>;

}  // namespace cullscope
