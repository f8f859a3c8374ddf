#include "core/scene/tour.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "core/geometry/angle.h"
#include "core/scene/eye_triangle.h"
#include "core/scene/scene_columns.h"
#include "core/scene/tour_places.h"

namespace cullscope {
namespace {

constexpr double kFovy = 60.0, kAspect = 4.0 / 3.0, kDown = 8.0;  // degrees; the tour looks slightly down
constexpr size_t kTurns = 12;                                     // directions tried at a place
constexpr int kRaysAcross = 16, kRaysUp = 12;                     // of the picture that is tried
constexpr size_t kMostViews = 512;                                // different ones; a longer tour goes round again
constexpr double kMostOfPlane = 0.5, kMostOfObject = 0.75;        // of a picture
constexpr double kSeenAgain = 0.7;   // what an object counts at a pose, for each pose before that shows it
constexpr double kSamePlace = 0.5;   // what a view counts, for each pose at its place
constexpr double kCellWeight = 0.5;  // what a part of space counts beside an object
constexpr double kRich = 0.5;        // of what a view of the best tenth shows; poorer ones are left out
constexpr int kCells = 16;           // parts of space along an axis

/// What a view from a place shows.
struct Outlook {
    uint32_t place = 0;
    Vec3 direction;
    std::vector<uint32_t> seen;  ///< objects, and after their numbers parts of space; ascending
    bool filled = false;         ///< a flat surface or an object has too much of the picture
};

Vec3 upOf(const Scene& scene) { return scene.upAxis() == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0); }

Vec3 directionOf(const Scene& scene, size_t turn) {
    const double azimuth = kTurn * double(turn) / double(kTurns), down = Angle::fromDegrees(kDown).radians();
    const double level = std::cos(down);
    if (scene.upAxis() == UpAxis::Z) return {level * std::cos(azimuth), level * std::sin(azimuth), -std::sin(down)};
    return {level * std::cos(azimuth), -std::sin(down), level * std::sin(azimuth)};
}

/// Counts the rays of a picture by flat surface.
class FlatSurfaces {
public:
    explicit FlatSurfaces(double radius) : m_tolerance(1e-3 * radius) {}

    /// `corners` relative to the eye, which all share.
    void add(const std::array<Vec3, 3>& corners) {
        const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(across);
        if (!(length > 0.0)) return;
        const Vec3 normal = across / length;
        const double offset = glm::dot(normal, corners[0]);
        for (Flat& flat : m_flats) {
            if (std::abs(glm::dot(normal, flat.normal)) < kSameNormal) continue;
            if (std::abs(std::abs(offset) - std::abs(flat.offset)) > m_tolerance) continue;
            m_most = std::max(m_most, ++flat.count);
            return;
        }
        m_flats.push_back({normal, offset, 1});
        m_most = std::max<size_t>(m_most, 1);
    }
    [[nodiscard]] size_t most() const { return m_most; }

private:
    static constexpr double kSameNormal = 0.999;
    struct Flat {
        Vec3 normal;
        double offset;
        size_t count;
    };
    std::vector<Flat> m_flats;
    double m_tolerance;
    size_t m_most = 0;
};

class Tour {
public:
    Tour(const Scene& scene, size_t count, const Progress& progress)
        : m_scene(scene),
          m_wanted(std::min(count, kMostViews)),
          m_progress(progress),
          m_rays(scene, scene.bounds().empty() ? Vec3(0.0) : scene.bounds().centre(), {}, progress) {
        m_places = tourPlaces(scene, m_rays, std::clamp<size_t>(4 * m_wanted, 128, 2 * kMostViews), progress.part(0.5, 0.6));
        look();
        choose();
    }

    /// Different views, in the order of the walk; empty where there are none.
    [[nodiscard]] std::vector<CameraPath::Pose> poses(size_t count) const {
        std::vector<CameraPath::Pose> poses;
        const std::vector<size_t> order = walked();
        for (size_t i = 0; i < count && !order.empty(); ++i) {
            const Outlook& outlook = m_outlooks[order[i % order.size()]];
            const Vec3 eye = m_places[outlook.place].eye + aside(outlook, i / order.size());
            poses.push_back({eye, eye + outlook.direction * m_scene.boundingSphere().radius, upOf(m_scene)});
        }
        return poses;
    }
    /// Nearer than every surface to every pose.
    [[nodiscard]] double nearDistance() const {
        double least = m_scene.boundingSphere().radius;
        for (const size_t chosen : m_chosen) least = std::min(least, clearanceOf(m_outlooks[chosen]));
        return kNear * least;
    }

private:
    static constexpr double kNear = 0.25, kAside = 0.25;  // of the clearance; together below 1 in a wide picture's corners, too

    void look();
    void dropPoor();
    [[nodiscard]] Outlook outlook(uint32_t place, const Vec3& direction) const;
    [[nodiscard]] uint32_t cellOf(const Vec3& point) const;
    void choose();
    [[nodiscard]] double gain(const Outlook& outlook) const;
    void take(size_t outlook);
    [[nodiscard]] std::vector<size_t> walked() const;
    [[nodiscard]] double clearanceOf(const Outlook& outlook) const { return m_rays.clearance(m_places[outlook.place].eye); }
    /// Where the tour goes round again it goes slightly aside, within what is free.
    [[nodiscard]] Vec3 aside(const Outlook& outlook, size_t round) const;

    const Scene& m_scene;
    size_t m_wanted;
    const Progress& m_progress;
    SceneRays m_rays;
    std::vector<TourPlace> m_places;
    std::vector<Outlook> m_outlooks;
    std::vector<size_t> m_chosen;
    std::vector<uint16_t> m_timesSeen;  ///< by object and part of space
    std::vector<uint16_t> m_timesUsed;  ///< by place
};

void Tour::look() {
    m_outlooks.resize(m_places.size() * kTurns);
    tbb::parallel_for(tbb::blocked_range<size_t>(0, m_places.size()), [&](const tbb::blocked_range<size_t>& range) {
        for (size_t place = range.begin(); place < range.end() && !m_progress.stopRequested(); ++place)
            for (size_t turn = 0; turn < kTurns; ++turn)
                m_outlooks[place * kTurns + turn] = outlook(uint32_t(place), directionOf(m_scene, turn));
    });
    m_progress.check();
    const bool some = std::ranges::any_of(m_outlooks, [](const Outlook& outlook) { return !outlook.filled; });
    if (some) std::erase_if(m_outlooks, [](const Outlook& outlook) { return outlook.filled; });
    dropPoor();
}

/// Leaves out views that show little beside what the best ones show.
void Tour::dropPoor() {
    m_timesSeen.assign(m_scene.instances().size() + size_t(kCells) * kCells * kCells, 0);
    m_timesUsed.assign(m_places.size(), 0);
    std::vector<double> gains;
    for (const Outlook& outlook : m_outlooks) gains.push_back(gain(outlook));
    std::ranges::sort(gains);
    const double least = gains.empty() ? 0.0 : kRich * gains[gains.size() * 9 / 10];
    std::erase_if(m_outlooks, [&](const Outlook& outlook) { return gain(outlook) < least; });
}

Outlook Tour::outlook(uint32_t place, const Vec3& direction) const {
    const Vec3 eye = m_places[place].eye;
    const Vec3 right = glm::normalize(glm::cross(direction, upOf(m_scene))), up = glm::cross(right, direction);
    const double tangent = std::tan(Angle::fromDegrees(kFovy / 2).radians());
    Outlook result{place, direction, {}};
    FlatSurfaces flats(m_scene.boundingSphere().radius);
    std::vector<uint32_t> objects, cells;
    for (int y = 0; y < kRaysUp; ++y)
        for (int x = 0; x < kRaysAcross; ++x) {
            const Vec3 ray = direction + right * (kAspect * tangent * ((2.0 * x + 1.0) / kRaysAcross - 1.0)) +
                             up * (tangent * ((2.0 * y + 1.0) / kRaysUp - 1.0));
            const std::optional<SceneRays::Hit> hit = m_rays.firstByNumber(eye, ray);
            if (!hit) continue;
            objects.push_back(hit->instance);
            cells.push_back(cellOf(eye + ray * hit->distance));
            flats.add(InstanceFromEye(m_scene, hit->instance, eye).corners(hit->triangle));
        }
    std::ranges::sort(objects);
    size_t most = 0, same = 0;
    for (size_t i = 0; i < objects.size(); ++i) {
        same = i > 0 && objects[i] == objects[i - 1] ? same + 1 : 1;
        most = std::max(most, same);
    }
    constexpr double kRays = kRaysAcross * kRaysUp;
    result.filled =
        double(flats.most()) > kMostOfPlane * kRays || (m_scene.instances().size() > 1 && double(most) > kMostOfObject * kRays);
    result.seen = std::move(objects);
    result.seen.insert(result.seen.end(), cells.begin(), cells.end());
    std::ranges::sort(result.seen);
    result.seen.erase(std::unique(result.seen.begin(), result.seen.end()), result.seen.end());
    return result;
}

uint32_t Tour::cellOf(const Vec3& point) const {
    const Box3& bounds = m_scene.bounds();
    uint32_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = bounds.max[axis] - bounds.min[axis];
        const double share = extent > 0.0 ? (point[axis] - bounds.min[axis]) / extent : 0.0;
        cell = cell * kCells + uint32_t(std::clamp(int(share * kCells), 0, kCells - 1));
    }
    return uint32_t(m_scene.instances().size()) + cell;
}

double Tour::gain(const Outlook& outlook) const {
    double sum = 0.0;
    for (const uint32_t seen : outlook.seen) {
        const double weight = seen < m_scene.instances().size() ? 1.0 : kCellWeight;
        sum += weight * std::pow(kSeenAgain, m_timesSeen[seen]);
    }
    return sum * std::pow(kSamePlace, m_timesUsed[outlook.place]);
}

void Tour::take(size_t outlook) {
    m_chosen.push_back(outlook);
    ++m_timesUsed[m_outlooks[outlook].place];
    for (const uint32_t seen : m_outlooks[outlook].seen) ++m_timesSeen[seen];
}

/// Greedily the view that shows most that was not shown before. What a view gains only decreases as others are taken, so that one
/// whose gain is still the largest when it is worked out anew is the best of all.
void Tour::choose() {
    enum class Solid : uint8_t { Unknown, Outside, Inside };
    std::vector<Solid> solid(m_places.size(), Solid::Unknown);
    // The larger gain first, then the smaller number.
    const auto later = [](const std::pair<double, size_t>& a, const std::pair<double, size_t>& b) {
        return a.first != b.first ? a.first < b.first : a.second > b.second;
    };
    std::priority_queue<std::pair<double, size_t>, std::vector<std::pair<double, size_t>>, decltype(later)> queue(later);
    for (size_t i = 0; i < m_outlooks.size(); ++i) queue.push({gain(m_outlooks[i]), i});
    while (m_chosen.size() < m_wanted && !queue.empty()) {
        const auto [known, number] = queue.top();
        queue.pop();
        if (!(known > 0.0)) break;
        const double now = gain(m_outlooks[number]);
        if (now < known) {
            queue.push({now, number});
            continue;
        }
        m_progress.check();
        Solid& there = solid[m_outlooks[number].place];
        if (there == Solid::Unknown)
            there = insideSolid(m_scene, m_places[m_outlooks[number].place].eye) ? Solid::Inside : Solid::Outside;
        if (there == Solid::Outside) take(number);
    }
}

/// From the first view always to the nearest place of those that are left.
std::vector<size_t> Tour::walked() const {
    std::vector<size_t> left = m_chosen, order;
    while (!left.empty()) {
        const auto distance = [&](size_t outlook) {
            return order.empty()
                       ? 0.0
                       : glm::distance(m_places[m_outlooks[outlook].place].eye, m_places[m_outlooks[order.back()].place].eye);
        };
        const auto nearest = std::ranges::min_element(left, {}, distance);
        order.push_back(*nearest);
        left.erase(nearest);
    }
    return order;
}

Vec3 Tour::aside(const Outlook& outlook, size_t round) const {
    if (round == 0) return Vec3(0.0);
    const double goldenAngle = kPi * (3.0 - std::sqrt(5.0)), turned = goldenAngle * double(round);
    const double length = kAside * clearanceOf(outlook) * double(round % 7 + 1) / 7.0;
    const Vec3 right = glm::normalize(glm::cross(outlook.direction, upOf(m_scene)));
    return length * (std::cos(turned) * right + std::sin(turned) * glm::cross(right, outlook.direction));
}

}  // namespace

bool isStoodIn(const Scene& scene) {
    constexpr uint32_t kSide = 48;
    constexpr size_t kEvery = 3;                         // in both directions: of the columns whose surroundings are looked at
    constexpr double kRise = 0.03;                       // of the radius of where the scene is dense
    constexpr double kFloors = 0.6, kFloorsOfOne = 0.8;  // of the columns; of a single object
    constexpr double kSurrounded = 0.5;                  // of the columns with a floor
    constexpr int kSectors = 8, kSides = 6;
    if (scene.triangleCount() > kOptionalAnalysisLimit) return false;
    const Box3 part = denseBox(scene);
    const SceneColumns columns(scene, part, kSide);
    const double rise = kRise * 0.5 * part.diagonal();
    const auto surrounded = [&](size_t x, size_t y, double height) {
        std::array<bool, kSectors> sides{};
        for (size_t other = 0; other < columns.count(); ++other) {
            const auto crossings = columns.crossings(other);
            if (crossings.empty() || crossings.back().height <= height) continue;
            const double dx = double(other % columns.across()) - double(x), dy = double(other / columns.across()) - double(y);
            if (dx != 0.0 || dy != 0.0) sides[size_t((std::atan2(dy, dx) / kTurn + 1.0) * kSectors) % kSectors] = true;
        }
        return std::ranges::count(sides, true) >= kSides;
    };
    size_t floors = 0, asked = 0, within = 0;
    for (size_t column = 0; column < columns.count(); ++column) {
        const auto crossings = columns.crossings(column);
        const auto floor = std::ranges::find_if(crossings, [](const auto& crossing) { return crossing.floor; });
        if (floor == crossings.end()) continue;
        ++floors;
        const size_t x = column % columns.across(), y = column / columns.across();
        if (x % kEvery != kEvery / 2 || y % kEvery != kEvery / 2) continue;
        ++asked;
        within += surrounded(x, y, floor->height + rise) ? 1 : 0;
    }
    const double least = scene.instances().size() > 1 ? kFloors : kFloorsOfOne;
    return asked > 0 && double(floors) >= least * double(columns.count()) && double(within) >= kSurrounded * double(asked);
}

CameraPath tour(const Scene& scene, size_t count, const Progress& progress) {
    CameraPath path;
    if (scene.triangleCount() > 0) {
        const Tour planned(scene, count, progress);
        path.poses = planned.poses(count);
        path.nearDistance = planned.nearDistance();
    }
    if (path.poses.empty()) {
        path = cameraPath("orbit:" + std::to_string(count), scene);
    } else {
        path.fovy = Angle::fromDegrees(kFovy);
        path.farDistance = 4.0 * scene.boundingSphere().radius;
    }
    path.name = "tour:" + std::to_string(count);
    return path;
}

}  // namespace cullscope
