#include "core/frame/named_parts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/frame/part_names.h"

namespace cullscope {
namespace {

/// A drawn fragment: its triangles among the own ones, and what it is sorted by.
struct Fragment {
    PlaceRun run;
    PartKey part;
    Vec3 middle{0.0};

    [[nodiscard]] auto order() const { return std::tuple(part.number, middle.x, middle.y, middle.z, run.first); }
};

OwnTrianglesPointer ownTriangles(const FrameLog& log) {
    for (const Command& command : log.commands)
        if (const auto* own = std::get_if<OwnTrianglesPointer>(&command)) return *own;
    return nullptr;
}

/// The sum of a run's triangle areas, and of their middles weighted by these.
std::pair<double, Vec3> weighed(const NamedParts& parts, const Scene& scene, uint32_t instance, const PlaceRun& run) {
    double area = 0.0;
    Vec3 sum(0.0);
    for (uint32_t i = run.first; i < run.first + run.count; ++i) {
        const auto [a, b, c] = worldCorners(*parts.own, i, scene, instance);
        const double own = 0.5 * glm::length(glm::cross(b - a, c - a));
        area += own;
        sum += own * (a + b + c) / 3.0;
    }
    return {area, sum};
}

}  // namespace

bool NamedParts::divides() const {
    for (size_t i = 1; i < parts.size(); ++i)
        if (parts[i].object == parts[i - 1].object) return true;
    return false;
}

std::optional<size_t> NamedParts::partAt(const Scene& scene, uint64_t triangle, const Vec3& point) const {
    const auto object = uint32_t(scene.instanceOf(triangle));
    std::optional<size_t> best;
    double away = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].object != object) continue;
        if (!own) return i;
        for (const PlaceRun& run : parts[i].drawn)
            for (uint32_t place = run.first; place < run.first + run.count; ++place) {
                if (own->triangles[place] != triangle) continue;
                const double outside = shareOutside(worldCorners(*own, place, scene, object), point);
                if (outside >= away) continue;
                best = i;
                away = outside;
            }
    }
    return best;
}

Vec3 NamedParts::middleOf(const Scene& scene, size_t part) const {
    double area = 0.0;
    Vec3 sum(0.0);
    for (const PlaceRun& run : parts[part].drawn) {
        const auto [ofRun, weighted] = weighed(*this, scene, parts[part].object, run);
        area += ofRun;
        sum += weighted;
    }
    return area > 0.0 ? sum / area : scene.instanceBox(parts[part].object).centre();
}

PartNames::PartNames(const Scene& scene) : m_scene(scene) {
    for (const Instance& instance : scene.instances()) m_sorted.push_back(instance.name);
    std::ranges::sort(m_sorted);
}

std::string PartNames::of(size_t object, size_t number) const {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::string begin = m_scene.instances()[object].name;
    const auto isTaken = [&] {
        if (begin != m_scene.instances()[object].name && std::ranges::binary_search(m_sorted, begin)) return true;
        for (auto name = std::ranges::upper_bound(m_sorted, begin); name != m_sorted.end() && name->starts_with(begin); ++name)
            if (std::all_of(name->begin() + std::ptrdiff_t(begin.size()), name->end(), isDigit)) return true;
        return false;
    };
    while (isTaken()) begin += ".";
    return begin + std::to_string(number);
}

NamedParts namedParts(const Scene& scene, const FrameLog& log, const PartOf& partOf) {
    NamedParts result;
    result.own = ownTriangles(log);
    if (!result.own || result.own->triangles.size() > NamedParts::kMostTriangles) return {};
    std::map<uint32_t, std::vector<Fragment>> fragments;  // by object
    std::map<uint32_t, bool> cut;                         // by object: whether a triangle of it is drawn in parts
    std::set<uint32_t> seen;
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Fragment || decision.places.count == 0) continue;
        const uint32_t object = decision.subject.object;
        cut[object] = !seen.insert(result.own->triangles[decision.places.first]).second || cut[object];
        const auto [area, sum] = weighed(result, scene, object, decision.places);
        fragments[object].push_back({decision.places,
                                     partOf ? partOf(decision) : PartKey{result.own->triangles[decision.places.first], {}},
                                     area > 0.0 ? sum / area : Vec3(0.0)});
    }
    const PartNames names(scene);
    for (auto& [object, own] : fragments) {
        std::ranges::sort(own, {}, &Fragment::order);
        const size_t first = result.parts.size();
        for (size_t i = 0; i < own.size(); ++i) {
            const bool same = i > 0 && (partOf ? own[i].part.number == own[i - 1].part.number : !cut[object]);
            if (!same) result.parts.push_back({scene.instances()[object].name, object, own[i].part.place});
            result.parts.back().drawn.push_back(own[i].run);
        }
        for (size_t part = first; part < result.parts.size(); ++part) {
            std::ranges::sort(result.parts[part].drawn, {}, &PlaceRun::first);
            if (result.parts.size() > first + 1) result.parts[part].name = names.of(object, part - first + 1);
        }
    }
    return result;
}

std::array<Vec3, 3> worldCorners(const OwnTriangles& own, size_t triangle, const Scene& scene, uint32_t instance) {
    const Mat4& world = scene.instances()[instance].worldFromMesh;
    const Vec3 origin = scene.meshOf(instance).origin();
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = Vec3(world * Vec4(origin + Vec3(own.positions[3 * triangle + i]), 1.0));
    return corners;
}

double shareOutside(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double doubled = glm::dot(normal, normal);
    if (!(doubled > 0.0)) return std::numeric_limits<double>::infinity();
    double least = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        least = std::min(least, glm::dot(glm::cross(b - a, point - a), normal) / doubled);
    }
    return -least;
}

}  // namespace cullscope
