#include "core/scene/section.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace cullscope {
namespace {

constexpr std::array kAxes{Section::Axis::X, Section::Axis::Y, Section::Axis::Z, Section::Axis::View};
constexpr std::string_view kFlip = "flip";

std::string_view cutWord(std::string_view& text) {
    const size_t colon = std::min(text.find(':'), text.size());
    const std::string_view word = text.substr(0, colon);
    text.remove_prefix(std::min(colon + 1, text.size()));
    return word;
}

}  // namespace

const char* sectionAxisId(Section::Axis axis) {
    switch (axis) {
        case Section::Axis::X:
            return "x";
        case Section::Axis::Y:
            return "y";
        case Section::Axis::Z:
            return "z";
        case Section::Axis::View:
            break;
    }
    return "view";
}

std::string sectionText(const Section& section) {
    std::array<char, 32> number{};
    const auto [end, error] = std::to_chars(number.data(), number.data() + number.size(), section.share);
    std::string text = sectionAxisId(section.axis) + std::string(":") + std::string(number.data(), end);
    if (section.flipped) text += ":" + std::string(kFlip);
    return text;
}

std::optional<Section> sectionFromText(std::string_view text) {
    if (text.ends_with(':')) return std::nullopt;
    Section section;
    const std::string_view word = cutWord(text);
    const auto axis = std::ranges::find(kAxes, word, sectionAxisId);
    if (axis == kAxes.end()) return std::nullopt;
    section.axis = *axis;
    const std::string_view share = cutWord(text);
    const auto [end, error] = std::from_chars(share.data(), share.data() + share.size(), section.share);
    if (error != std::errc() || end != share.data() + share.size()) return std::nullopt;
    if (!(section.share >= 0.0) || !(section.share <= 1.0)) return std::nullopt;
    section.flipped = text == kFlip;
    return text.empty() || section.flipped ? std::optional(section) : std::nullopt;
}

Plane sectionPlane(const Section& section, const Box3& scene, const Camera& camera) {
    Vec3 normal(0.0);
    if (section.axis == Section::Axis::View)
        normal = glm::normalize(camera.target - camera.eye);
    else
        normal[int(section.axis)] = 1.0;
    const double middle = scene.empty() ? 0.0 : glm::dot(normal, scene.centre());
    const double reach = scene.empty() ? 0.0 : glm::dot(glm::abs(normal), scene.halfExtent());
    const Plane plane{normal, -(middle + (2.0 * section.share - 1.0) * reach)};
    return section.flipped ? Plane{-plane.normal, -plane.offset} : plane;
}

std::vector<Vec3> planeInBox(const Plane& plane, const Box3& box) {
    if (box.empty()) return {};
    const auto corner = [&](int c) {
        return Vec3((c & 1) != 0 ? box.max.x : box.min.x, (c & 2) != 0 ? box.max.y : box.min.y,
                    (c & 4) != 0 ? box.max.z : box.min.z);
    };
    std::vector<Vec3> points;
    for (int from = 0; from < 8; ++from)
        for (const int axis : {1, 2, 4}) {
            if ((from & axis) != 0) continue;
            const Vec3 a = corner(from), b = corner(from | axis);
            const double da = plane.distance(a), db = plane.distance(b);
            if ((da < 0.0) == (db < 0.0)) continue;
            points.push_back(a + (b - a) * (da / (da - db)));
        }
    if (points.size() < 3) return {};
    // In the order around their middle.
    Vec3 middle(0.0);
    for (const Vec3& point : points) middle += point / double(points.size());
    const Vec3 size = glm::abs(plane.normal);
    const Vec3 other = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0) : size.y <= size.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 right = glm::normalize(glm::cross(plane.normal, other)), up = glm::cross(plane.normal, right);
    std::ranges::sort(
        points, {}, [&](const Vec3& point) { return std::atan2(glm::dot(point - middle, up), glm::dot(point - middle, right)); });
    return points;
}

}  // namespace cullscope
