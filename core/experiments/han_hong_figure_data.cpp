#include "core/experiments/han_hong_figure_data.h"

#include <fmt/format.h>

#include <map>

#include "core/experiments/han_hong_rows.h"
#include "core/geometry/angle.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/map_details.h"
#include "core/visibility/spherical/map_overlays.h"

namespace cullscope::han_hong {
namespace {

using namespace spherical;
using Origin = ResultColumn::Origin;

double degrees(double radians) { return radians / kTurn * 360.0; }

/// Writes rows of one object in one view.
class RowWriter {
public:
    RowWriter(ResultTable& table, const Row& common) : m_table(table), m_common(common) {}

    void addRays(const SphericalDecision& decision) {
        for (size_t i = 0; i < decision.rays.size(); ++i) {
            const CornerRay& ray = decision.rays[i];
            if (!ray.followed) continue;
            Row row{{"number", double(i + 1)}, {"state", std::string(ray.hit ? "hit" : "miss")}};
            if (ray.span) row["entry_r"] = glm::length(ray.ray.at(ray.span->from));
            if (ray.hit) row["triangle"] = double(ray.hit->triangle);
            const SphericalPoint point = sphericalPoint(ray.point);
            row["r"] = point.radius;
            addAngles(row, point.theta, point.phi);
            add("ray", std::move(row));
        }
    }

    void addRegion(const VisibleRegion& region, const SphericalGrid& grid) {
        for (size_t i = 0; i < region.outline.size(); ++i) {
            Row row{{"number", double(i + 1)}};
            addAngles(row, region.outline[i].x, region.outline[i].y);
            add("outline", std::move(row));
        }
        for (size_t i = 0; i < region.boxes.size(); ++i) {
            const CellBox& box = region.boxes[i];
            Row row{{"number", double(i + 1)},
                    {"theta_to", degrees(grid.thetaOf(box.lastRow + 1))},
                    {"phi_to", degrees(grid.phiOf(box.lastColumn + 1))}};
            addAngles(row, grid.thetaOf(box.firstRow), grid.phiOf(box.firstColumn));
            add("box", std::move(row));
        }
    }

    void addBands(const MapSnapshot& map) {
        const ContourBands& bands = *map.decision.bands;
        for (uint32_t sector = 0; sector < bands.sectors; ++sector)
            for (const SizePlace& place : sizePlaces(map, sector)) {
                const BandSector& entry = bands.at(place.band, sector);
                const SphericalPoint point = sphericalPoint(place.surface);
                Row row{{"number", double(place.band + 1)},
                        {"sector", double(sector + 1)},
                        {"alpha", degrees(place.band * bands.width)},
                        {"alpha_to", degrees((place.band + 1) * bands.width)},
                        {"s", entry.size},
                        {"largest_before", entry.horizon},
                        {"foot", glm::dot(place.foot, bands.axis)},
                        {"r", point.radius},
                        {"state", std::string(entry.drawn    ? "drawn"
                                              : entry.within ? "drawn within 90"
                                                             : "hidden")}};
                addAngles(row, point.theta, point.phi);
                add("band", std::move(row));
            }
    }

private:
    static void addAngles(Row& row, double theta, double phi) {
        row["theta"] = degrees(theta);
        row["phi"] = degrees(phi);
    }

    void add(const char* kind, Row row) {
        row.insert(m_common.begin(), m_common.end());
        row["kind"] = std::string(kind);
        m_table.addRow(row);
    }

    ResultTable& m_table;
    const Row& m_common;
};

/// What the rows of one view and object say together.
struct RowSummary {
    std::optional<double> caseNumber;
    size_t rays = 0, hits = 0, bands = 0, drawnBands = 0, cells = 0;
    std::vector<std::string> boxes;

    void add(const ResultTable& table, size_t row) {
        const auto text = [&](const char* key) { return std::get<std::string>(table.value(row, key)); };
        const auto number = [&](const char* key) { return std::get<double>(table.value(row, key)); };
        const std::string kind = text("kind");
        if (const CellValue found = table.value(row, "case"); std::holds_alternative<double>(found))
            caseNumber = std::get<double>(found);
        if (kind == "ray") ++rays, hits += text("state") == "hit" ? 1 : 0;
        if (kind == "band") ++bands, drawnBands += text("state").starts_with("drawn") ? 1 : 0;
        if (kind == "cell") ++cells;
        if (kind == "box")
            boxes.push_back(fmt::format("θ {:g}° to {:g}°, φ {:g}° to {:g}°", number("theta"), number("theta_to"), number("phi"),
                                        number("phi_to")));
    }
    [[nodiscard]] std::vector<std::string> parts() const {
        std::vector<std::string> parts;
        if (caseNumber) parts.push_back(fmt::format("case {:g}", *caseNumber));
        if (rays > 0) parts.push_back(fmt::format("{} of {} corner rays hit", hits, rays));
        if (!boxes.empty()) parts.push_back(fmt::format("boxes {}", fmt::join(boxes, " and ")));
        if (bands > 0) parts.push_back(fmt::format("{} of {} sectors of bands drawn", drawnBands, bands));
        if (cells > 0) parts.push_back(fmt::format("{} cells hold triangles", cells));
        return parts;
    }
};

}  // namespace

ResultTable figureTable(int number, const BuiltStrategy& strategy) {
    ResultTable table;
    table.experiment = fmt::format("figure-{}", number);
    table.title = fmt::format("What Figure {} shows", number);
    table.source = fmt::format("{}, Figure {}", kSource, number);
    table.scene = "";
    table.triangles = strategy.scene().triangleCount();
    table.columns = {{"view", "view", Origin::Axis},
                     {"case", "case", Origin::Measured},
                     {"object", "object", Origin::Axis},
                     {"kind", "kind", Origin::Axis},
                     {"number", "number", Origin::Axis},
                     {"sector", "sector", Origin::Axis},
                     {"state", "state", Origin::Measured},
                     {"r", "R", Origin::Measured, 5},
                     {"theta", "θ, °", Origin::Measured, 3},
                     {"phi", "φ, °", Origin::Measured, 3},
                     {"theta_to", "θ to, °", Origin::Measured, 3},
                     {"phi_to", "φ to, °", Origin::Measured, 3},
                     {"entry_r", "R of the entry", Origin::Measured, 5},
                     {"triangle", "triangle", Origin::Measured},
                     {"alpha", "α, °", Origin::Axis, 2},
                     {"alpha_to", "α to, °", Origin::Axis, 2},
                     {"s", "S", Origin::Measured, 5},
                     {"largest_before", "largest S before it", Origin::Measured, 5},
                     {"foot", "foot on the axis", Origin::Measured, 5},
                     {"entries", "triangles in the cell", Origin::Measured},
                     {"nearest_r", "nearest R", Origin::Measured, 5}};
    return table;
}

void addCellRows(ResultTable& table, uint32_t instance, const SphericalMaps& maps) {
    const SphericalGrid& grid = maps.grid();
    for (uint32_t number = 0; number < grid.cellCount(); ++number) {
        const SphericalMaps::Extent extent = maps.extent(number);
        if (extent.empty()) continue;
        const SphericalGrid::Cell cell = grid.cell(number);
        table.addRow({{"view", 1.0},
                      {"object", double(instance)},
                      {"kind", std::string("cell")},
                      {"number", double(number)},
                      {"theta", degrees(grid.thetaOf(cell.row))},
                      {"theta_to", degrees(grid.thetaOf(cell.row + 1))},
                      {"phi", degrees(grid.phiOf(cell.column))},
                      {"phi_to", degrees(grid.phiOf(cell.column + 1))},
                      {"entries", double(maps.triangles(number).size())},
                      {"nearest_r", double(extent.nearest)},
                      {"r", double(extent.farthest)}});
    }
}

std::vector<std::string> figureSentences(const ResultTable& table) {
    std::map<std::pair<double, double>, RowSummary> summaries;
    for (size_t row = 0; row < table.rows.size(); ++row)
        summaries[{std::get<double>(table.value(row, "view")), std::get<double>(table.value(row, "object"))}].add(table, row);
    constexpr size_t kMostObjects = 8;
    std::map<double, size_t> objects;
    std::vector<std::string> sentences;
    for (const auto& [place, summary] : summaries)
        if (++objects[place.first] <= kMostObjects)
            sentences.push_back(
                fmt::format("view {:g}, object {:g}: {}", place.first, place.second, fmt::join(summary.parts(), "; ")));
    for (const auto& [view, count] : objects)
        if (count > kMostObjects)
            sentences.push_back(fmt::format("view {:g}: {} objects more (--csv or --json)", view, count - kMostObjects));
    return sentences;
}

void addFigureRows(ResultTable& table, size_t view, const BuiltStrategy& strategy, const FrameLog& log) {
    const StructureSnapshot snapshot = strategy.snapshot(log);
    for (const MapSnapshot& map : mapsOf(snapshot)) {
        const SphericalDecision& decision = map.decision;
        Row common{{"view", double(view)}, {"object", double(decision.instance)}};
        if (decision.region) common["case"] = double(decision.region->caseNumber);
        RowWriter writer(table, common);
        writer.addRays(decision);
        if (decision.region) writer.addRegion(*decision.region, map.maps->grid());
        if (decision.bands && !decision.bands->slopes) writer.addBands(map);
    }
}

}  // namespace cullscope::han_hong
