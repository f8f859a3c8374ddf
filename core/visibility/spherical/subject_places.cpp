#include "core/visibility/spherical/subject_places.h"

#include <numbers>

#include "core/geometry/map_line.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_place.h"
#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

constexpr double kSamePlace = 1e-9;                     ///< of directions: at the axis all azimuths are one
constexpr double kPlaceStep = std::numbers::pi / 90.0;  ///< of lines on a sphere, radians

Vec3 unitVector(const Vec2& angles) {
    return {std::sin(angles.x) * std::cos(angles.y), std::sin(angles.x) * std::sin(angles.y), std::cos(angles.x)};
}

/// Points from one value to another, at most kPlaceStep apart.
template <typename Use>
void alongSteps(double from, double to, const Use& use) {
    const int pieces = std::max(1, int(std::ceil(std::abs(to - from) / kPlaceStep)));
    for (int i = 0; i <= pieces; ++i) use(from + (to - from) * i / pieces);
}

/// Collects the place of one subject of one object.
class PlaceMaker {
public:
    PlaceMaker(const Scene& scene, const MapSnapshot& map) : m_map(map), m_place(scene, map) {}

    void addRay(const CornerRay& ray, double end, bool result) {
        m_made.lines.push_back({m_place.world(m_map.decision.eye), m_place.world(ray.ray.at(end))});
        if (ray.span) addMapRay(ray.ray, ray.span->from, end);
        if (!ray.hit && result) m_made.lines.back().push_back(m_place.world(ray.point));
        if (ray.hit && result) m_made.triangle = ray.hit->triangle;
    }

    void addMapRay(const Ray& ray, double from, double to) {
        MapLine line(ray.at(from));
        if (to > from) line.follow([&](double t) { return ray.at(t); }, from, to);
        m_made.mapLines.push_back(std::move(line).take());
    }

    void addBox(const SphericalGrid& grid, const CellBox& box) {
        const double top = grid.thetaOf(box.firstRow), bottom = grid.thetaOf(box.lastRow + 1);
        const double left = grid.phiOf(box.firstColumn), right = grid.phiOf(box.lastColumn + 1);
        m_made.mapLines.push_back({{top, left}, {top, right}, {bottom, right}, {bottom, left}, {top, left}});
        std::vector<Vec2> outline;
        alongSteps(left, right, [&](double phi) { outline.emplace_back(top, phi); });
        alongSteps(top, bottom, [&](double theta) { outline.emplace_back(theta, right); });
        alongSteps(right, left, [&](double phi) { outline.emplace_back(bottom, phi); });
        alongSteps(bottom, top, [&](double theta) { outline.emplace_back(theta, left); });
        addOnSphere(outline);
    }

    void addRegion(const VisibleRegion& region) {
        std::vector<Vec2> outline;
        for (size_t i = 1; i < region.outline.size(); ++i) addStraight(outline, region.outline[i - 1], region.outline[i]);
        if (region.caseNumber != 1 && region.outline.size() > 1)
            addStraight(outline, region.outline.back(), region.outline.front());
        addOnSphere(outline);
        m_made.mapLines.push_back(std::move(outline));
    }

    /// The cells [first, last): rectangles of whole rows, and of the parts of the first and the last one.
    void addRange(const SphericalGrid& grid, const CellRun& cells) {
        const uint32_t columns = grid.columns();
        for (uint32_t from = cells.first; from < cells.last;) {
            const SphericalGrid::Cell at = grid.cell(from);
            uint32_t to = std::min(cells.last, from - at.column + columns);
            if (at.column == 0 && to < cells.last) to = cells.last - cells.last % columns;
            const SphericalGrid::Cell end = grid.cell(to - 1);
            addBox(grid, {at.row, end.row, at.column, end.column});
            from = to;
        }
    }

    /// The circle at which a band ends, and the borders of one of its sectors.
    void addBand(const ContourBands& bands, uint32_t number) {
        const uint32_t band = number / bands.sectors, sector = number % bands.sectors;
        const double from = band * bands.width, to = std::min(std::numbers::pi, (band + 1) * bands.width);
        const double left = kTurn * sector / bands.sectors, right = kTurn * (sector + 1) / bands.sectors;
        std::vector<Vec3> circle, border;
        alongSteps(0.0, kTurn, [&](double beta) { circle.push_back(bands.direction(to, beta)); });
        alongSteps(from, to, [&](double alpha) { border.push_back(bands.direction(alpha, left)); });
        alongSteps(left, right, [&](double beta) { border.push_back(bands.direction(to, beta)); });
        alongSteps(to, from, [&](double alpha) { border.push_back(bands.direction(alpha, right)); });
        alongSteps(right, left, [&](double beta) { border.push_back(bands.direction(from, beta)); });
        m_made.onCurve = {sector + 1, from / std::numbers::pi * 180.0, to / std::numbers::pi * 180.0};
        for (const std::vector<Vec3>& directions : {circle, border}) {
            MapLine line(directions.front());
            for (size_t i = 1; i < directions.size(); ++i)
                if (glm::distance(directions[i - 1], directions[i]) > kSamePlace) line.arc(directions[i - 1], directions[i]);
            m_made.mapLines.push_back(std::move(line).take());
            addOnSphere(directions);
        }
    }

    void addTreeCell(const CellTree& tree, uint32_t node) {
        const std::vector<Vec2> outline = cellOutline(tree.layout(), tree.nodes()[node].cell());
        if (!outline.empty()) m_made.mapLines.push_back(outline);
    }

    [[nodiscard]] SubjectPlace take() { return std::move(m_made); }

private:
    static void addStraight(std::vector<Vec2>& outline, const Vec2& from, const Vec2& to) {
        const int pieces = std::max(1, int(std::ceil(glm::length(to - from) / kPlaceStep)));
        for (int i = 0; i <= pieces; ++i) outline.push_back(from + (to - from) * (double(i) / pieces));
    }

    void addOnSphere(const std::vector<Vec2>& angles) {
        std::vector<Vec3> directions;
        for (const Vec2& each : angles) directions.push_back(unitVector(each));
        addOnSphere(directions);
    }
    void addOnSphere(const std::vector<Vec3>& directions) {
        std::vector<Vec3> line;
        for (const Vec3& direction : directions) line.push_back(m_place.world(m_map.maps.sphere().radius * direction));
        m_made.lines.push_back(std::move(line));
    }

    const MapSnapshot& m_map;
    MapPlace m_place;
    SubjectPlace m_made;
};

class PlacesOnMaps final : public SubjectPlaces {
public:
    explicit PlacesOnMaps(std::shared_ptr<const MapDetails> maps) : m_maps(std::move(maps)) {}

    [[nodiscard]] std::optional<SubjectPlace> of(const Scene& scene, const Decision& decision) const override {
        // A strategy that walks a tree of cells compares objects' boxes first.
        const bool bySphere = !m_maps->maps.empty() && !m_maps->maps.front().tree;
        if (decision.subject.kind == Subject::Kind::Object && bySphere) return sphereOf(scene, decision.subject.object);
        const auto found = std::ranges::find_if(
            m_maps->maps, [&](const MapSnapshot& map) { return map.decision.instance == decision.subject.object; });
        if (found == m_maps->maps.end()) return std::nullopt;
        PlaceMaker maker(scene, *found);
        if (!add(*found, decision, maker)) return std::nullopt;
        return maker.take();
    }

private:
    /// What is compared with the frustum's planes: three great circles of the object's sphere.
    [[nodiscard]] static SubjectPlace sphereOf(const Scene& scene, uint32_t object) {
        const Sphere& sphere = scene.instanceSphere(object);
        SubjectPlace place;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<Vec3>& circle = place.lines.emplace_back();
            alongSteps(0.0, kTurn, [&](double angle) {
                Vec3 direction(0.0);
                direction[(axis + 1) % 3] = std::cos(angle);
                direction[(axis + 2) % 3] = std::sin(angle);
                circle.push_back(sphere.centre + sphere.radius * direction);
            });
        }
        return place;
    }

    /// Whether the subject could be placed.
    [[nodiscard]] static bool add(const MapSnapshot& map, const Decision& said, PlaceMaker& maker) {
        const SphericalDecision& decision = map.decision;
        const uint32_t number = said.subject.number;
        switch (said.subject.kind) {
            case Subject::Kind::Ray: {
                if (number >= decision.rays.size()) return false;
                const CornerRay& ray = decision.rays[number];
                // The first decision about a ray, with two numbers, is its entry into the sphere; the other one is the result.
                const bool result = said.operandCount > 2;
                const double entry = ray.span ? ray.span->from : 0.0;
                maker.addRay(ray, result && ray.hit ? ray.hit->t : entry, result);
                return true;
            }
            case Subject::Kind::Cell:
                if (map.tree)
                    maker.addTreeCell(*map.tree, number);
                else
                    addMapCell(map, said, maker);
                return true;
            case Subject::Kind::Cells:
                return addCells(map, number, maker);
            case Subject::Kind::Band:
                if (!decision.bands || number >= decision.bands->table.size()) return false;
                maker.addBand(*decision.bands, number);
                return true;
            default:
                return false;
        }
    }

    /// A cell of the map, and the ray that walks through it, where the decision is about that.
    static void addMapCell(const MapSnapshot& map, const Decision& said, PlaceMaker& maker) {
        const SphericalGrid& grid = map.maps->grid();
        const SphericalGrid::Cell cell = grid.cell(said.subject.number);
        const std::array<CornerRay, 4>& rays = map.decision.rays;
        if (said.operandCount > 0 && said.operands[0] >= 1.0 && said.operands[0] <= double(rays.size())) {
            const CornerRay& ray = rays[size_t(said.operands[0]) - 1];
            const auto walked = std::ranges::find(ray.walkedCells, cell, &WalkedCell::cell);
            if (walked != ray.walkedCells.end()) maker.addRay(ray, walked->span.to, false);
        }
        maker.addBox(grid, {cell.row, cell.row, cell.column, cell.column});
    }

    [[nodiscard]] static bool addCells(const MapSnapshot& map, uint32_t number, PlaceMaker& maker) {
        const SphericalDecision& decision = map.decision;
        const CellGroups groups(decision);
        if (number == CellGroups::kRegion && decision.region) {
            maker.addRegion(*decision.region);
            return true;
        }
        if (const auto box = groups.boxOf(number)) {
            maker.addBox(map.maps->grid(), decision.region->boxes[*box]);
            return true;
        }
        const auto range = groups.rangeOf(number);
        if (!range || *range >= decision.drawn.size()) return false;
        maker.addRange(map.maps->grid(), decision.drawn[*range]);
        return true;
    }

    std::shared_ptr<const MapDetails> m_maps;
};

}  // namespace

std::shared_ptr<const SubjectPlaces> placesOnMaps(std::shared_ptr<const MapDetails> maps) {
    return std::make_shared<PlacesOnMaps>(std::move(maps));
}

}  // namespace cullscope::spherical
