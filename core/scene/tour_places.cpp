#include "core/scene/tour_places.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/geometry/random.h"
#include "core/geometry/triangle.h"
#include "core/scene/eye_triangle.h"
#include "core/scene/scene_columns.h"

namespace cullscope {
namespace {

constexpr uint32_t kColumns = 64;                           // along the longer side
constexpr std::array<double, 3> kHeights{0.02, 0.05, 0.1};  // of the eye above the floor, in radii of where the scene is dense
constexpr double kHeadroom = 1.5;                           // the ceiling's least height, in heights of the eye
constexpr double kLeastGap = 0.004;                         // of that radius, between floor and ceiling
constexpr double kClearance = 0.4;                          // of the height above the floor
constexpr double kFewBacks = 0.05;
constexpr size_t kDirections = 48;

/// The places above one floor: at several heights, or at half the height of a low room.
void addAbove(std::vector<TourPlace>& places, const SceneColumns& columns, size_t column, double floor, double ceiling,
              double radius) {
    const size_t before = places.size();
    for (const double share : kHeights)
        if (share * radius * kHeadroom < ceiling - floor)
            places.push_back({columns.at(column, floor + share * radius), share * radius});
    if (places.size() == before && ceiling - floor > kLeastGap * radius)
        places.push_back({columns.at(column, 0.5 * floor + 0.5 * ceiling), 0.5 * (ceiling - floor)});
}

std::vector<TourPlace> aboveFloors(const Scene& scene) {
    const Box3 part = denseBox(scene);
    const SceneColumns columns(scene, part, kColumns);
    const double radius = 0.5 * part.diagonal();
    std::vector<TourPlace> places;
    for (size_t column = 0; column < columns.count(); ++column) {
        const auto crossings = columns.crossings(column);
        for (size_t i = 0; i < crossings.size(); ++i) {
            if (!crossings[i].floor) continue;
            const bool open = i + 1 == crossings.size();
            const double ceiling = open ? std::numeric_limits<double>::infinity() : crossings[i + 1].height;
            addAbove(places, columns, column, crossings[i].height, ceiling, radius);
        }
    }
    return places;
}

/// Fisher and Yates; the standard library's shuffle is not the same everywhere.
void shuffle(std::vector<TourPlace>& places) {
    Random random(19);
    for (size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[size_t(random.bits() % i)]);
}

/// The share of back faces among what is seen in all directions; 1 where nothing is seen.
double backsAround(const Scene& scene, const SceneRays& rays, const Vec3& eye) {
    Random random(4);
    size_t seen = 0, backs = 0;
    for (size_t i = 0; i < kDirections; ++i) {
        const Vec3 direction = random.direction();
        const std::optional<SceneRays::Hit> hit = rays.firstByNumber(eye, direction);
        if (!hit) continue;
        ++seen;
        backs += InstanceFromEye(scene, hit->instance, eye).facesAway(hit->triangle) ? 1 : 0;
    }
    return seen > 0 ? double(backs) / double(seen) : 1.0;
}

double windingNumber(const Scene& scene, size_t instance, const Vec3& point) {
    const InstanceFromEye seen(scene, instance, point);
    double sum = 0.0;
    for (uint64_t triangle = 0; triangle < scene.meshOf(instance).triangleCount(); ++triangle)
        sum += solidAngle(seen.corners(triangle));
    return sum / (2.0 * kTurn);
}

}  // namespace

std::vector<TourPlace> tourPlaces(const Scene& scene, const SceneRays& rays, size_t count, const Progress& progress) {
    constexpr size_t kTriedForOne = 6;
    std::vector<TourPlace> places = aboveFloors(scene);
    progress.check();
    shuffle(places);
    places.resize(std::min(places.size(), kTriedForOne * count));
    std::vector<uint8_t> clear(places.size(), 0);
    tbb::parallel_for(tbb::blocked_range<size_t>(0, places.size()), [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end() && !progress.stopRequested(); ++i) {
            clear[i] = rays.clearance(places[i].eye) >= kClearance * places[i].aboveFloor ? 1 : 0;
            if (clear[i] != 0) places[i].backs = backsAround(scene, rays, places[i].eye);
        }
    });
    progress.check();
    size_t kept = 0;
    for (size_t i = 0; i < places.size(); ++i)
        if (clear[i] != 0) places[kept++] = places[i];
    places.resize(kept);
    // Where most places see back faces, the scene's surfaces are not oriented, and its better half is as good as can be had.
    std::vector<double> backs;
    for (const TourPlace& place : places) backs.push_back(place.backs);
    std::ranges::sort(backs);
    const double most = std::max(kFewBacks, backs.empty() ? 0.0 : backs[backs.size() / 4]);
    std::erase_if(places, [most](const TourPlace& place) { return place.backs > most; });
    places.resize(std::min(places.size(), count));
    return places;
}

bool insideSolid(const Scene& scene, const Vec3& point) {
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        const Box3& box = scene.instanceBox(i);
        if (glm::any(glm::lessThan(point, box.min)) || glm::any(glm::greaterThan(point, box.max))) continue;
        if (!scene.frontFacesSuffice(i)) continue;
        if (std::abs(windingNumber(scene, i, point)) > 0.5) return true;
    }
    return false;
}

}  // namespace cullscope
