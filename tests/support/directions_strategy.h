#pragma once

#include <algorithm>
#include <cmath>

#include "core/frame/cell_map.h"
#include "core/frame/curve.h"
#include "core/visibility/facing.h"
#include "core/visibility/registry.h"

namespace cullscope::test {

/// The triangles of a mesh by the direction of their centroids from the mesh's origin.
class TrianglesByDirection final : public CellMapSource {
public:
    explicit TrianglesByDirection(const TriangleMesh& mesh) : m_grid(8, 4), m_owned(m_grid.cellCount()) {
        for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
            const auto corner = [&](uint32_t i) { return Vec3(mesh.positions()[mesh.indices()[3 * triangle + i]]); };
            m_owners.push_back(m_grid.cellOf(corner(0) + corner(1) + corner(2)));
            m_owned[m_grid.number(m_owners.back())].push_back(triangle);
        }
        for (const std::vector<uint32_t>& owned : m_owned)
            m_states.push_back(owned.empty() ? std::nullopt : std::optional(TriangleState::Visible));
    }

    [[nodiscard]] const SphericalGrid& grid() const { return m_grid; }
    [[nodiscard]] const void* key() const override { return this; }
    [[nodiscard]] std::span<const uint32_t> owned(uint32_t cell) const override { return m_owned[cell]; }
    [[nodiscard]] std::span<const uint32_t> touching(uint32_t cell) const override { return m_owned[cell]; }
    [[nodiscard]] SphericalGrid::Cell ownerOf(uint32_t triangle) const override { return m_owners[triangle]; }
    [[nodiscard]] std::vector<SphericalGrid::Cell> cellsOf(uint32_t triangle) const override { return {m_owners[triangle]}; }
    [[nodiscard]] MapValues values(std::string_view /*colouring*/) const override {
        MapValues values{{}, Term::count(0), Term::count(0)};
        size_t most = 1;
        for (const std::vector<uint32_t>& owned : m_owned) most = std::max(most, owned.size());
        for (const std::vector<uint32_t>& owned : m_owned)
            values.shares.push_back(owned.empty() ? -1.0f : float(double(owned.size()) / double(most)));
        values.most = Term::count(most);
        return values;
    }
    [[nodiscard]] const std::vector<std::optional<TriangleState>>& states() const override { return m_states; }
    [[nodiscard]] std::vector<Words> words(uint32_t cell) const override {
        return {{"cell %1", {Term::plain(cell)}}, {"triangles: %1", {Term::count(m_owned[cell].size())}}};
    }
    [[nodiscard]] std::vector<std::vector<Vec2>> partEdges(uint32_t part) const override {
        return {{{0.0, m_grid.phiOf(part - 1)}, {3.0, m_grid.phiOf(part - 1)}}};
    }
    [[nodiscard]] Words partWords(uint32_t part) const override { return {"column %1", {Term::plain(part)}}; }

private:
    SphericalGrid m_grid;
    std::vector<std::vector<uint32_t>> m_owned;
    std::vector<SphericalGrid::Cell> m_owners;
    std::vector<std::optional<TriangleState>> m_states;
};

/// Draws everything, and shows of an object its triangles by direction, as a map and, summed over columns, as a curve. No code
/// outside the tests knows it.
class DirectionsStrategy final : public StrategyWith<Structure> {
public:
    [[nodiscard]] CellMapPointer directionMap(std::string_view id, const Structure& structure, const FrameLog& log,
                                              const std::optional<uint32_t>& object) const override {
        if (id != "by-direction" || !log.recorded) return nullptr;
        auto map = std::make_shared<CellMap>();
        map->object = object.value_or(0);
        const auto source = std::make_shared<const TrianglesByDirection>(structure.scene().meshOf(map->object));
        map->title = {"Triangles by direction"};
        map->grid = source->grid();
        map->colourings = {{"number", {"Number"}, {"triangles in a cell"}}, {"fate", {"Fate"}, {}, true}};
        map->objectWords = {"%1, seen from its origin", {Term::name(structure.scene().instances()[map->object].name)}};
        map->decisionWords = {"All of it is drawn."};
        map->marks = {{MapSymbol::Hit, {1.0, 2.0}, 7, {"the seventh place"}}};
        map->boxes = {{1, 2, 3, 4}};
        map->parts = source->grid().columns();
        map->legend = {{MapSymbol::Hit, {"a place"}}};
        map->rooms = {{{TriangleState::Visible}, {}, map->legend}};
        map->source = source;
        return map;
    }
    [[nodiscard]] std::optional<Curve> curve(std::string_view id, const Structure& structure, const FrameLog& log,
                                             const std::optional<uint32_t>& object,
                                             const std::optional<uint32_t>& part) const override {
        if (id != "by-column" || !log.recorded) return std::nullopt;
        const TrianglesByDirection triangles(structure.scene().meshOf(object.value_or(0)));
        const SphericalGrid& grid = triangles.grid();
        Curve curve{{"Triangles by azimuth"}, {{}, 0.0, 360.0, false, 90.0, "°"}, {{"Upwards: triangles"}, 0.0, 0.0, true}};
        curve.areas = {{{"drawn"}, TriangleState::Visible, {}}};
        curve.parts = CurveParts{{"&Row:"}, {"one row of cells"}, {"all rows"}, grid.rows()};
        curve.parts->shown = part && *part <= grid.rows() ? *part : 0;
        if (curve.parts->shown > 0) curve.parts->words = {"row %1", {Term::plain(curve.parts->shown)}};
        for (uint32_t column = 0; column < grid.columns(); ++column) {
            size_t number = 0;
            for (uint32_t row = 0; row < grid.rows(); ++row)
                if (curve.parts->shown == 0 || row + 1 == curve.parts->shown)
                    number += triangles.owned(grid.number({row, column})).size();
            const double from = 45.0 * column;
            if (number > 0) curve.areas.front().boxes.push_back({from, from + 45.0, double(number)});
            curve.intervals.push_back({from, from + 45.0, {{"%1 triangles here", {Term::count(number)}}}, number == 0});
        }
        curve.summary = {curve.y.title};
        return curve;
    }

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& structure, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        DrawList list{frame.facing(), {}};
        for (uint32_t i = 0; i < structure.scene().instances().size(); ++i)
            list.ranges.push_back({i, 0, uint32_t(3 * structure.scene().meshOf(i).triangleCount())});
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
};

inline RegisteredStrategy directionsStrategy() {
    StrategyInfo info{"directions", "Directions", "Draws everything.", "a test", {facingParameter()}};
    Show map;
    map.kind = Show::Kind::DirectionMap;
    map.id = "by-direction";
    map.colourings = {{"number"}, {"fate"}};
    Show curve;
    curve.kind = Show::Kind::Curve;
    curve.id = "by-column";
    curve.title = "Columns";
    info.shows = {map, curve};
    return {std::move(info), std::make_shared<DirectionsStrategy>()};
}

}  // namespace cullscope::test
