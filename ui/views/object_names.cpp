#include "ui/views/object_names.h"

#include <algorithm>
#include <cmath>

#include "core/scene/eye_triangle.h"

namespace cullscope::ui {

namespace {

constexpr size_t kMostNames = 26;
constexpr uint64_t kMostTriangles = 200;  // of an object, from which its places are taken
constexpr uint64_t kFewTriangles = 8;     // of which several places each are taken
constexpr int kRows = 8;                  // of places in one of few triangles
constexpr double kSameSurface = 0.02;     // of the distance: by so much the picture's surface may differ from the place

/// Places on a triangle as shares of its corners.
const std::vector<Vec3>& shares(bool several) {
    static const std::vector<Vec3> middle{Vec3(1.0 / 3.0)};
    static const std::vector<Vec3> spread = [] {
        std::vector<Vec3> found;
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; row + column < kRows; ++column) {
                const double a = (row + 1.0 / 3.0) / kRows, b = (column + 1.0 / 3.0) / kRows;
                found.push_back({a, b, 1.0 - a - b});
            }
        return found;
    }();
    return several ? spread : middle;
}

/// Places on an object in a picture, in its pixels from the top left.
struct Places {
    std::vector<QPointF> all, seen;  ///< in the picture; where the picture shows the object
};

Places placesOf(const Scene& scene, size_t instance, const View& view, const ViewPicture& shown) {
    const InstanceFromEye object(scene, instance, view.eye());
    const uint64_t count = scene.firstTriangle(instance + 1) - scene.firstTriangle(instance);
    const uint64_t step = std::max<uint64_t>(1, count / kMostTriangles);
    const Viewport& size = shown.request.size;
    Places places;
    for (uint64_t triangle = 0; triangle < count; triangle += step) {
        const std::array<Vec3, 3> corners = object.corners(triangle);
        for (const Vec3& share : shares(count <= kFewTriangles)) {
            const Vec3 point = share.x * corners[0] + share.y * corners[1] + share.z * corners[2];
            const Vec4 clip = view.clipFromEyeRelative() * Vec4(point, 1.0);
            if (!(clip.w > 0.0)) continue;
            const double x = (clip.x / clip.w * 0.5 + 0.5) * size.width, y = (clip.y / clip.w * 0.5 + 0.5) * size.height;
            if (!(x >= 0.0 && x < size.width && y >= 0.0 && y < size.height)) continue;
            places.all.emplace_back(x, size.height - y);
            if (shown.depth.empty()) continue;
            const double depth = shown.depth[size_t(y) * size_t(size.width) + size_t(x)];
            const double distance = glm::dot(point, view.frustum().forward);
            if (depth > 0.0 && std::abs(view.distanceFromDepth(depth) - distance) <= kSameSurface * distance)
                places.seen.push_back(places.all.back());
        }
    }
    return places;
}

PlacedName placed(const std::string& name, const std::vector<QPointF>& places) {
    QPointF mean;
    QRectF extent(places.front(), QSizeF());
    for (const QPointF& place : places) {
        mean += place / double(places.size());
        extent.setCoords(std::min(extent.left(), place.x()), std::min(extent.top(), place.y()),
                         std::max(extent.right(), place.x()), std::max(extent.bottom(), place.y()));
    }
    // The mean itself may lie beside what is seen, as in a ring.
    const auto away = [&](const QPointF& place) { return std::hypot(place.x() - mean.x(), place.y() - mean.y()); };
    const QPointF middle = *std::ranges::min_element(places, {}, away);
    return {QString::fromStdString(name), middle, extent};
}

}  // namespace

std::vector<PlacedName> objectNames(const Session& session, const ViewPicture& shown) {
    const Scene& scene = shown.request.buffers->scene();
    const size_t count = scene.instances().size();
    if (count < 2 || count > kMostNames || shown.request.look.inPlace()) return {};
    if (scene.planes().empty() && !session.question()) return {};
    const View view(shown.request.viewing, shown.request.size);
    std::vector<PlacedName> names;
    for (size_t i = 0; i < count; ++i) {
        const std::string& name = scene.instances()[i].name;
        if (name.empty()) continue;
        // What is not drawn yet, or hidden, has its name where it would be seen.
        const Places places = placesOf(scene, i, view, shown);
        if (!places.all.empty()) names.push_back(placed(name, places.seen.empty() ? places.all : places.seen));
    }
    return names;
}

}  // namespace cullscope::ui
