#include "core/experiments/han_hong_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/message.h"
#include "core/experiments/han_hong_random_views.h"
#include "core/experiments/han_hong_rows.h"
#include "core/visibility/spherical/mapped_scene.h"
#include "core/visibility/spherical/visible_region.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::han_hong {
namespace {

using Origin = ResultColumn::Origin;

constexpr Viewport kPicture{320, 240};
constexpr double kFacesOfTable2 = 144'078;
constexpr double kNearest = 1.02, kFarthest = 12.0, kNear = 0.005;  // radii
constexpr size_t kDistances = 48;
constexpr size_t kPoses = 12;
constexpr std::array kScannedFields{6.0, 10.0, 20.0, 35.0, 50.0, 65.0};
constexpr double kTilt = 0.04;
/// Relative differences of faces: near the case's share, and so near that no better view is searched.
constexpr double kClose = 0.02, kCloseEnough = 0.002;
/// Of one of the twelve views; their mean is to be within kNearTheShare.
constexpr double kMostOfOne = 0.15;

double distanceAt(size_t step) { return kNearest * std::pow(kFarthest / kNearest, double(step) / (kDistances - 1)); }

/// Cameras on an object from distances in radii of its bounding sphere.
class Lens {
public:
    Lens(const Scene& scene, Angle field, const Vec3& up)
        : m_radius(scene.boundingSphere().radius), m_middle(surfaceCentroid(scene)), m_field(field), m_up(up) {
        m_targets = {m_middle, scene.boundingSphere().centre, 0.5 * (m_middle + scene.boundingSphere().centre)};
    }

    /// What a camera looks at: the middle of the surface, the bounding sphere's centre, or between both.
    static constexpr size_t kTargets = 3;
    [[nodiscard]] View view(const Vec3& direction, size_t target, double distance) const {
        const Vec3 at = m_targets[target];
        return {{at + distance * m_radius * direction, at, m_up, m_field, kNear * m_radius, (distance + 2.0) * m_radius},
                kPicture};
    }

private:
    double m_radius;
    Vec3 m_middle;
    Angle m_field;
    Vec3 m_up;
    std::array<Vec3, kTargets> m_targets;
};

/// How far a view is from what a case wants, of its relative difference in faces and the rays that miss: beyond any such where
/// the case is another; of views within two hundredths those come first of which more rays hit.
double missOf(const Considered& found, const TableCase& wanted, double faces) {
    const double off = std::abs(double(found.faces) / (wanted.share * faces) - 1.0);
    if (found.caseNumber != wanted.number) return 1e6 + off;
    return off > kClose ? 1.0 + off : 0.1 * double(4 - found.hits) + off;
}

/// The view from a direction whose considered faces are nearest to the case's.
class ViewSearch {
public:
    ViewSearch(const ConsideredFaces& considered, const Lens& lens, const TableCase& wanted, const Vec3& direction, double faces)
        : m_considered(considered), m_lens(lens), m_wanted(wanted), m_direction(direction), m_faces(faces) {}

    [[nodiscard]] View find() {
        // With all rays and within a few thousandths no other target is needed.
        for (size_t target = 0; target < Lens::kTargets && m_least > kCloseEnough; ++target) search(target);
        return *m_best;
    }

private:
    /// Whether a view from there considers too many faces, too few, or those of another case (0).
    int side(size_t target, double distance) {
        const View view = m_lens.view(m_direction, target, distance);
        const Considered found = m_considered.in(view);
        const double miss = missOf(found, m_wanted, m_faces);
        if (!m_best || miss < m_least) m_best = view, m_least = miss;
        if (found.caseNumber != m_wanted.number) return 0;
        return double(found.faces) > m_wanted.share * m_faces ? 1 : -1;
    }

    void search(size_t target) {
        int before = 0;
        for (size_t step = 0; step < kDistances; ++step) {
            const int here = side(target, distanceAt(step));
            // Between too few and too many there are as many as wanted, but for the steps of cells and the rays that begin to
            // miss.
            if (before * here < 0) divide(target, distanceAt(step - 1), distanceAt(step), here);
            before = here;
        }
    }

    void divide(size_t target, double from, double to, int sideOfTo) {
        for (int round = 0; round < 10 && m_least > kCloseEnough; ++round) {
            const double middle = 0.5 * (from + to);
            const int found = side(target, middle);
            if (found == 0) return;
            (found == sideOfTo ? to : from) = middle;
        }
    }

    const ConsideredFaces& m_considered;
    const Lens& m_lens;
    const TableCase& m_wanted;
    Vec3 m_direction;
    double m_faces;
    std::optional<View> m_best;
    double m_least = std::numeric_limits<double>::infinity();
};

}  // namespace

struct ConsideredFaces::Impl {
    explicit Impl(const Scene& ofScene)
        : scene(ofScene),
          maps(spherical::makeMaps(ofScene.meshes()[ofScene.instances().front().mesh], strategyFromText("spherical").parameters,
                                   {})) {}

    const Scene& scene;
    SphericalMapsPointer maps;  ///< those of the strategy: of a coarse mesh they have fewer cells than the paper's
};

ConsideredFaces::ConsideredFaces(const Scene& scene) : m_impl(std::make_unique<Impl>(scene)) {}
ConsideredFaces::~ConsideredFaces() = default;

Considered ConsideredFaces::in(const View& view) const {
    const SphericalMaps& maps = *m_impl->maps;
    const spherical::ObjectSpaceView seen = spherical::objectSpaceView(m_impl->scene, 0, maps.sphere(), view);
    Considered result;
    if (seen.relation != spherical::SphereRelation::Cut) return result;
    std::array<spherical::CornerRay, 4> corners;
    for (uint32_t i = 0; i < 4; ++i) {
        const Ray ray{seen.eye + seen.cornerDirections[i], seen.cornerDirections[i]};
        corners[i] = spherical::followCorner(maps, ray, i, spherical::RayStart::Sphere, nullptr);
        result.hits += corners[i].hit ? 1 : 0;
    }
    if (result.hits == 0) return result;
    const spherical::VisibleRegion region =
        spherical::visibleRegion(maps, corners, spherical::Join::Chart, spherical::poleInView(maps, seen));
    result.caseNumber = region.caseNumber;
    for (const spherical::CellRun& run : spherical::runsOf(maps.grid(), region))
        result.faces += maps.run(run.first, run.last).second;
    return result;
}

const std::array<TableCase, 3>& tableCases() {
    // At a pole of the map, opposite the seam, and at the seam.
    static const std::array<TableCase, 3> kCases{{{1, 13'508 / kFacesOfTable2, {0, 0, 1}, {1, 0, 0}},
                                                  {2, 16'434 / kFacesOfTable2, {-1, 0, 0}, {0, 0, 1}},
                                                  {3, 26'308 / kFacesOfTable2, {1, 0, 0}, {0, 0, 1}}}};
    return kCases;
}

namespace {

/// Directions slightly around a case's own.
std::array<Vec3, kPoses> directionsOf(const TableCase& wanted) {
    std::array<Vec3, kPoses> directions;
    const Vec3 side = glm::cross(wanted.up, wanted.direction);
    for (size_t i = 0; i < kPoses; ++i) {
        const double turn = 2.0 * std::numbers::pi * double(i) / kPoses;
        directions[i] = glm::normalize(wanted.direction + kTilt * (std::cos(turn) * side + std::sin(turn) * wanted.up));
    }
    return directions;
}

}  // namespace

bool isNear(const Considered& found, const TableCase& wanted, double faces, double within) {
    return found.caseNumber == wanted.number && std::abs(double(found.faces) / faces - 1.0) <= within;
}

std::vector<FoundView> nearestViews(const Scene& scene, const ConsideredFaces& considered, const TableCase& wanted, Angle field) {
    const Lens lens(scene, field, wanted.up);
    const auto faces = double(scene.meshOf(0).triangleCount());
    std::vector<FoundView> views;
    for (const Vec3& direction : directionsOf(wanted)) {
        const View view = ViewSearch(considered, lens, wanted, direction, faces).find();
        views.push_back({view, considered.in(view)});
    }
    return views;
}

CameraPath viewsOfCase(const Scene& scene, const TableCase& wanted, Angle field) {
    const ConsideredFaces considered(scene);
    const double faces = wanted.share * double(scene.meshOf(0).triangleCount());
    std::vector<View> views;
    bool near = true;
    double sum = 0.0;
    for (const FoundView& nearest : nearestViews(scene, considered, wanted, field)) {
        views.push_back(nearest.view);
        sum += double(nearest.found.faces);
        near = near && isNear(nearest.found, wanted, faces, kMostOfOne);
    }
    const double mean = sum / double(views.size());
    if (!near || std::abs(mean / faces - 1.0) > kNearTheShare) {
        const std::vector<FoundView> others = randomViewsOfCase(scene, considered, wanted, field, kRandomViews, kPoses);
        if (!others.empty()) views.clear();
        for (const FoundView& other : others) views.push_back(other.view);
    }
    return pathThrough(views, field, fmt::format("considered-{} {:g}", wanted.number, field.degrees()));
}

CameraPath pathThrough(const std::vector<View>& views, Angle field, std::string name) {
    CameraPath path;
    path.name = std::move(name);
    path.fovy = field;
    path.nearDistance = std::numeric_limits<double>::infinity();
    path.farDistance = 0.0;
    for (const View& view : views) {
        const Camera& camera = view.camera();
        path.poses.push_back({camera.eye, camera.target, camera.up});
        path.nearDistance = std::min(path.nearDistance, camera.nearDistance);
        path.farDistance = std::max(path.farDistance, camera.farDistance);
    }
    return path;
}

std::optional<ShareRange> sharesOfCase(const Scene& scene, const ConsideredFaces& faces, const TableCase& wanted, Angle field,
                                       const Vec3& direction) {
    const Lens lens(scene, field, wanted.up);
    const auto all = double(scene.meshOf(0).triangleCount());
    std::optional<ShareRange> range;
    for (size_t target = 0; target < Lens::kTargets; ++target)
        for (size_t step = 0; step < kDistances; ++step) {
            const Considered found = faces.in(lens.view(direction, target, distanceAt(step)));
            if (found.caseNumber != wanted.number) continue;
            const double share = double(found.faces) / all;
            if (!range) range = ShareRange{share, share};
            range->least = std::min(range->least, share);
            range->most = std::max(range->most, share);
        }
    return range;
}

namespace {

/// The considered faces of the case's nearest view; none where no direction has one.
std::optional<uint64_t> nearestFaces(const Scene& scene, const ConsideredFaces& considered, const TableCase& wanted,
                                     Angle field) {
    const double faces = wanted.share * double(scene.meshOf(0).triangleCount());
    const auto off = [&](uint64_t found) { return std::abs(double(found) - faces); };
    std::optional<uint64_t> nearest;
    for (const FoundView& view : nearestViews(scene, considered, wanted, field))
        if (view.found.caseNumber == wanted.number && (!nearest || off(view.found.faces) < off(*nearest)))
            nearest = view.found.faces;
    return nearest;
}

Rows rowsOfViews(const ScenePointer& scene, size_t randomViews, const Progress& progress) {
    const ConsideredFaces considered(*scene);
    const auto faces = double(scene->meshOf(0).triangleCount());
    Rows rows;
    for (const double field : kScannedFields)
        for (const TableCase& wanted : tableCases()) {
            progress.check();
            const Angle angle = Angle::fromDegrees(field);
            std::optional<ShareRange> all;
            for (const Vec3& direction : directionsOf(wanted)) {
                const auto range = sharesOfCase(*scene, considered, wanted, angle, direction);
                if (range) all = all ? ShareRange{std::min(all->least, range->least), std::max(all->most, range->most)} : *range;
            }
            const std::optional<uint64_t> nearest = nearestFaces(*scene, considered, wanted, angle);
            const size_t random = randomViewsOfCase(*scene, considered, wanted, angle, randomViews, randomViews).size();
            const double wantedFaces = wanted.share * faces;
            const bool exists = random > 0 || (nearest && std::abs(double(*nearest) / wantedFaces - 1.0) <= kNearTheShare);
            Row row{{kField, field},
                    {"case", double(wanted.number)},
                    {"wanted_share", wanted.share},
                    {"wanted_faces", wantedFaces},
                    {"random_views", double(random)},
                    {"exists", std::string(exists ? CULLSCOPE_TR("yes") : CULLSCOPE_TR("none found"))}};
            if (all) row["least_share"] = all->least, row["most_share"] = all->most;
            if (nearest) row["nearest_faces"] = double(*nearest);
            rows.push_back(std::move(row));
        }
    return rows;
}

}  // namespace

Experiment tableViews(size_t randomViews) {
    Experiment experiment;
    experiment.id = "table-2-views";
    experiment.title = CULLSCOPE_TR("Which cases have views that consider the paper's faces");
    experiment.source = std::string(kSource) + ", Table 2";
    experiment.notes = {note(CULLSCOPE_TR(
        "The share of the faces that spherical considers where the case occurs, over 48 distances of 1.02 to 12 radii, three "
        "targets and twelve directions around the case's own: the least and the most; the faces of the nearest view that "
        "a search between these distances finds; and of 20,000 random views (the eye 1.05 to 4 radii away, any target within "
        "the bounding sphere, any roll) those of the case whose faces are within 5 % of the paper's. Where the nearest view "
        "is within 5 %, or a random one, the case has such views: cells go in steps, so a share between least and most may be "
        "that of no view."))};
    experiment.axes = {{kField, CULLSCOPE_TR("field of view, °"), Axis::Kind::InTurns, axisValues(kScannedFields)},
                       {"case", CULLSCOPE_TR("case"), Axis::Kind::InTurns, axisValues(std::array{1.0, 2.0, 3.0})}};
    experiment.columns = {{kField, CULLSCOPE_TR("field of view, °"), Origin::Axis},
                          {"case", CULLSCOPE_TR("case"), Origin::Axis},
                          {"wanted_faces", CULLSCOPE_TR("faces wanted"), Origin::Measured},
                          {"wanted_share", CULLSCOPE_TR("share wanted"), Origin::Measured, 3},
                          {"least_share", CULLSCOPE_TR("least share"), Origin::Measured, 3},
                          {"most_share", CULLSCOPE_TR("most share"), Origin::Measured, 3},
                          {"nearest_faces", CULLSCOPE_TR("faces of the nearest view"), Origin::Measured},
                          {"random_views", CULLSCOPE_TR("such random views, of 20,000"), Origin::Measured},
                          {"exists", CULLSCOPE_TR("exists"), Origin::Measured}};
    Setting setting;
    setting.scene = kBunny;
    experiment.settings = {setting};
    experiment.measured = [randomViews](const Setting& /*setting*/, const ScenePointer& scene, const Progress& progress) {
        return rowsOfViews(scene, randomViews, progress);
    };
    return withOtherScenes(std::move(experiment));
}

}  // namespace cullscope::han_hong
