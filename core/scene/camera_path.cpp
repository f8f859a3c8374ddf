#include "core/scene/camera_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <numbers>

#include "core/base/error.h"
#include "core/scene/camera_path_pose.h"
#include "core/scene/eye_triangle.h"
#include "core/scene/frustum_share.h"
#include "core/scene/tour.h"

namespace cullscope {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

double radiusOf(const Scene& scene) { return scene.boundingSphere().radius > 0 ? scene.boundingSphere().radius : 1.0; }

CameraPath pathAround(const Scene& scene, std::string name, Angle fovy) {
    CameraPath path;
    path.name = std::move(name);
    path.fovy = fovy;
    path.nearDistance = radiusOf(scene) * 0.01;
    path.farDistance = radiusOf(scene) * 100.0;
    return path;
}

bool saysZUp(const Scene& scene) { return scene.remarks().up == UpAxis::Z; }

/// A direction with y up as the same with another axis up.
Vec3 standing(bool zUp, const Vec3& direction) { return zUp ? Vec3(direction.x, -direction.z, direction.y) : direction; }
Vec3 standing(const Scene& scene, const Vec3& direction) { return standing(saysZUp(scene), direction); }

/// A pose at 3 R from the centre in a direction that is given with y up, with the scene's axis up (another where it looks along
/// that).
CameraPath::Pose poseAround(const Scene& scene, const Vec3& direction) {
    const Vec3 centre = scene.boundingSphere().centre;
    const Vec3 up = std::abs(direction.y) > 0.999 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    return {centre + standing(scene, direction) * (3.0 * radiusOf(scene)), centre, standing(scene, up)};
}

CameraPath orbit(const Scene& scene, size_t count) {
    CameraPath path = pathAround(scene, "orbit:" + std::to_string(count), Angle::fromDegrees(45));
    const double elevation = Angle::fromDegrees(15).radians();
    for (size_t i = 0; i < count; ++i) {
        const double azimuth = kTau * double(i) / double(count);
        path.poses.push_back(poseAround(
            scene, {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)}));
    }
    return path;
}

/// Uniformly distributed over the sphere: equal steps of height, azimuths apart by the golden angle.
CameraPath fibonacci(const Scene& scene, size_t count) {
    CameraPath path = pathAround(scene, "fibonacci:" + std::to_string(count), Angle::fromDegrees(45));
    const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (size_t i = 0; i < count; ++i) {
        const double height = 1.0 - (2.0 * double(i) + 1.0) / double(count);
        const double r = std::sqrt(1.0 - height * height);
        path.poses.push_back(
            poseAround(scene, {r * std::cos(goldenAngle * double(i)), height, r * std::sin(goldenAngle * double(i))}));
    }
    return path;
}

/// A walk into the scene at half its height, from its edge to 0.70 of its depth, looking ahead with a small sway. The depth
/// decides how much of the scene is behind the walker: in the 20 × 20 field the frustum culls 79 % of the objects on average, as
/// in Cho et al.
CameraPath walk(const Scene& scene, size_t count) {
    constexpr double kDepth = 0.70;
    constexpr double kSway = 0.08;
    CameraPath path = pathAround(scene, "walk:" + std::to_string(count), Angle::fromDegrees(45));
    const bool empty = scene.bounds().empty();
    const Vec3 half = empty ? Vec3(1.0) : scene.bounds().halfExtent();
    const Vec3 centre = empty ? Vec3(0.0) : scene.bounds().centre();
    // The walker stands upright. Where the scene does not say what is up, it extends horizontally; then y is up unless the scene
    // is clearly flat along z.
    const bool zUp = scene.remarks().up ? saysZUp(scene) : half.z < 0.5 * half.y;
    const Vec3 up = zUp ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const Vec3 depth = zUp ? Vec3(0, half.y, 0) : Vec3(0, 0, -half.z);
    const bool alongX = half.x > glm::length(depth);
    // Gives a scene without extent in that plane (a single sheet) a direction to look in.
    const Vec3 least = Vec3(1, 0, 0) * (1e-3 * radiusOf(scene));
    const Vec3 ahead = (alongX ? Vec3(half.x, 0, 0) : depth) + (glm::length(depth) + half.x > 0 ? Vec3(0) : least);
    const Vec3 side = alongX ? depth : Vec3(half.x, 0, 0);
    path.nearDistance = radiusOf(scene) * 0.002;
    path.farDistance = radiusOf(scene) * 4.0;
    for (size_t i = 0; i < count; ++i) {
        const double share = count > 1 ? double(i) / double(count - 1) : 0.0;
        const Vec3 eye = centre + ahead * (2.0 * kDepth * share - 1.0) + side * (kSway * std::sin(kTau * share));
        const Vec3 direction = ahead * (2.0 * kDepth) + side * (kSway * kTau * std::cos(kTau * share));
        path.poses.push_back({eye, eye + direction, up});
    }
    return path;
}

/// Views along −z from before the scene's front, slightly shifted on a circle, each filled by the back of the scene's box in a
/// window of up to 16 : 9. The eye is the scene's radius away from the front.
CameraPath front(const Scene& scene, size_t count) {
    constexpr double kWidest = 16.0 / 9.0;
    constexpr double kFilled = 0.9, kShift = 0.05;  // of the box's half extent
    CameraPath path = pathAround(scene, "front:" + std::to_string(count), Angle::fromDegrees(45));
    const bool empty = scene.bounds().empty();
    const Vec3 half = empty ? Vec3(1.0) : scene.bounds().halfExtent();
    const Vec3 centre = empty ? Vec3(0.0) : scene.bounds().centre();
    const double before = radiusOf(scene);
    const double tangent = kFilled * std::min(half.y, half.x / kWidest) / (before + 2.0 * half.z);
    if (tangent > 1e-6) path.fovy = Angle::fromRadians(2.0 * std::atan(std::min(tangent, 1.0)));
    const double shift = kShift * std::min(half.x, half.y);
    for (size_t i = 0; i < count; ++i) {
        const double turn = kTau * double(i) / double(count);
        const Vec3 eye = centre + Vec3(shift * std::cos(turn), shift * std::sin(turn), half.z + before);
        path.poses.push_back({eye, eye - Vec3(0, 0, before), Vec3(0, 1, 0)});
    }
    return path;
}

/// The cameras from which the scene is to be judged; without any, the one that shows all of it.
CameraPath given(const Scene& scene, size_t /*count*/) {
    const std::vector<Camera>& cameras = scene.remarks().cameras;
    const Camera first = cameras.empty() ? overviewCamera(scene, 4.0 / 3.0) : cameras.front();
    CameraPath path{"given", first.fovy, first.nearDistance, first.farDistance, first.projection, first.height, {}};
    if (cameras.empty()) path.poses.push_back({first.eye, first.target, first.up});
    for (const Camera& camera : cameras) path.poses.push_back({camera.eye, camera.target, camera.up});
    return path;
}

/// One of the three cases of Han & Hong 2008, Table 2.
struct SphericalCase {
    const char* name;
    double share;    ///< of the faces in the frustum: the faces the paper considered (13,508, 16,434, 26,308 of 144,078)
    Vec3 direction;  ///< to the eye: at a pole of the map, opposite the seam, at the seam
    Vec3 up;
    double fovy;  ///< degrees; with it the bunny covers all four corners of the window in each pose
};

const std::array<SphericalCase, 3> kSphericalCases{{{"case-1", 13508.0 / 144078.0, {0, 0, 1}, {1, 0, 0}, 14.0},
                                                    {"case-2", 16434.0 / 144078.0, {-1, 0, 0}, {0, 0, 1}, 6.0},
                                                    {"case-3", 26308.0 / 144078.0, {1, 0, 0}, {0, 0, 1}, 13.0}}};

/// The distance of the eye at which a share of the faces is in a frustum of aspect 4 : 3; a smaller distance gives fewer faces.
double distanceOfShare(const Scene& scene, CameraPath& path, size_t pose, const Vec3& direction, double share) {
    constexpr Viewport kFourToThree{640, 480};
    constexpr uint64_t kMostLookedAt = 200'000;
    const uint64_t step = scene.triangleCount() / kMostLookedAt + 1;
    const double looked = double((scene.triangleCount() + step - 1) / step);
    const double radius = radiusOf(scene);
    double near = 1.05 * radius, far = 20.0 * radius;
    for (int i = 0; i < 16; ++i) {
        const double middle = std::sqrt(near * far);
        path.poses[pose].eye = path.poses[pose].target + direction * middle;
        const double found = double(trianglesInFrustum(scene, View(path.camera(pose), kFourToThree), step)) / looked;
        (found < share ? near : far) = middle;
    }
    return std::sqrt(near * far);
}

/// Twelve views slightly around the case's direction, from outside the bounding sphere with a narrow field of view, at the
/// distance that gives the paper's share of faces. Which faces `spherical` considers there is a result, not a setting. `only`:
/// the pose whose distance is searched for; left out: all.
CameraPath sphericalCase(const Scene& scene, const SphericalCase& wanted, std::optional<size_t> only = {}) {
    constexpr size_t kPoses = 12;
    constexpr double kTilt = 0.04;
    CameraPath path = pathAround(scene, wanted.name, Angle::fromDegrees(wanted.fovy));
    const Vec3 target = surfaceCentroid(scene);
    const Vec3 side = glm::cross(wanted.up, wanted.direction);
    for (size_t i = 0; i < kPoses; ++i) {
        const double turn = kTau * double(i) / kPoses;
        const Vec3 direction = glm::normalize(wanted.direction + kTilt * (std::cos(turn) * side + std::sin(turn) * wanted.up));
        path.poses.push_back({target + direction, target, wanted.up});
        if (only.value_or(i) == i)
            path.poses.back().eye = target + direction * distanceOfShare(scene, path, i, direction, wanted.share);
    }
    return path;
}

size_t poseCount(std::string_view text, std::string_view name) {
    size_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > kMostPoses)
        throwUsage(CULLSCOPE_TR("The path %1 needs a number of poses between 1 and 1000000 after the colon."),
                   {std::string(name)});
    return count;
}

/// A built-in path and what makes it; the number of poses counts where the id ends with ":N".
struct Maker {
    BuiltInPath path;
    std::function<CameraPath(const Scene&, size_t count, const Progress&)> make;

    [[nodiscard]] bool numbered() const { return path.id.ends_with(":N"); }
    [[nodiscard]] std::string_view name() const {
        return std::string_view(path.id).substr(0, path.id.size() - (numbered() ? 2 : 0));
    }
};

Maker maker(std::string id, std::string description, CameraPath (*make)(const Scene&, size_t)) {
    return {{std::move(id), std::move(description)},
            [make](const Scene& scene, size_t count, const Progress&) { return make(scene, count); }};
}

Maker maker(const SphericalCase& wanted, std::string description) {
    return {{wanted.name, std::move(description)},
            [wanted](const Scene& scene, size_t, const Progress&) { return sphericalCase(scene, wanted); }};
}

const std::vector<Maker>& makers() {
    static const std::vector<Maker> kMakers{
        maker("orbit:N", CULLSCOPE_TR("N poses on a circle at three times the scene's radius, 15 degrees above it"), orbit),
        maker("fibonacci:N", CULLSCOPE_TR("N poses spread evenly around the scene at three times its radius"), fibonacci),
        {{"tour:N", CULLSCOPE_TR("N poses in a scene that one stands in: above its floors, outside solids, where much is seen")},
         tour},
        maker("walk:N", CULLSCOPE_TR("N poses on a walk into the scene, looking ahead"), walk),
        maker("front:N", CULLSCOPE_TR("N poses before the scene's front, looking along -z, which the scene fills"), front),
        maker(kSphericalCases[0],
              CULLSCOPE_TR("12 close views with a pole of the spherical map in them, 9.4 % of the faces in the frustum")),
        maker(kSphericalCases[1],
              CULLSCOPE_TR("12 close views of one clump of the spherical map, 11.4 % of the faces in the frustum")),
        maker(kSphericalCases[2],
              CULLSCOPE_TR("12 close views of a clump that the map's seam splits, 18.3 % of the faces in the frustum")),
        maker("given",
              CULLSCOPE_TR("the poses that the scene gives, as those of the gallery do; of others one that shows it all"),
              given)};
    return kMakers;
}

std::optional<CameraPath> builtIn(std::string_view name, const Scene& scene, const Progress& progress) {
    constexpr size_t kUsualPoses = 16;
    const size_t colon = name.find(':');
    const std::string_view id = name.substr(0, colon);
    for (const Maker& known : makers()) {
        if (known.name() != (known.numbered() ? id : name)) continue;
        const size_t count = colon == std::string_view::npos ? kUsualPoses : poseCount(name.substr(colon + 1), name);
        return known.make(scene, count, progress);
    }
    return std::nullopt;
}

}  // namespace

Vec3 surfaceCentroid(const Scene& scene) {
    Vec3 moment(0.0);
    double area = 0.0;
    const Vec3 centre = scene.boundingSphere().centre;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const InstanceFromEye instance(scene, i, centre);
        for (uint64_t triangle = 0; triangle < scene.meshOf(i).triangleCount(); ++triangle) {
            const auto [a, b, c] = instance.corners(triangle);
            const double own = glm::length(glm::cross(b - a, c - a));
            moment += own / 3.0 * (a + b + c);
            area += own;
        }
    }
    return area > 0.0 ? centre + moment / area : centre;
}

Camera CameraPath::camera(size_t pose) const {
    return {poses.at(pose).eye, poses.at(pose).target, poses.at(pose).up, fovy, nearDistance, farDistance, projection, height};
}

CameraPath cameraPathAt(std::string_view nameOrFile, size_t pose, const Scene& scene) {
    const auto* one = std::ranges::find(kSphericalCases, nameOrFile, [](const SphericalCase& each) { return each.name; });
    return one != kSphericalCases.end() ? sphericalCase(scene, *one, pose) : cameraPath(nameOrFile, scene);
}

CameraPath cameraPath(std::string_view nameOrFile, const Scene& scene, const Progress& progress) {
    if (auto path = builtIn(nameOrFile, scene, progress)) return *path;
    const std::filesystem::path file{std::string(nameOrFile)};
    std::error_code ignored;  // a name may be too long to be asked for
    if (nameOrFile.find_first_of("./\\") == std::string_view::npos && !std::filesystem::exists(file, ignored))
        throwUsage(CULLSCOPE_TR("\"%1\" is neither a camera path file nor a built-in path. Built in: %2."),
                   {std::string(nameOrFile), builtInPathNames()});
    if (!std::filesystem::is_regular_file(file, ignored))
        throwInput(CULLSCOPE_TR("%1 is no camera path file that can be read: check the name."), {file.string()});
    return readCameraPath(file);
}

Angle verticalField(Angle horizontal, const Viewport& size) {
    return Angle::fromRadians(2.0 * std::atan(std::tan(horizontal.radians() / 2.0) * size.height / size.width));
}

std::string defaultPathName(const Scene& scene) {
    if (!scene.remarks().cameras.empty()) return "given";
    if (isStoodIn(scene)) return "tour:16";
    return scene.instances().size() > 1 ? "walk:16" : "fibonacci:16";
}

Camera overviewCamera(const Scene& scene, double aspect) {
    if (scene.remarks().camera) return *scene.remarks().camera;
    Camera camera;
    const double radius = radiusOf(scene);
    const double halfAngle = std::min(camera.fovy.radians() / 2, std::atan(std::tan(camera.fovy.radians() / 2) * aspect));
    const double distance = 1.05 * radius / std::sin(halfAngle);
    camera.target = scene.boundingSphere().centre;
    const bool zUp = scene.upAxis() == UpAxis::Z;
    camera.eye = camera.target + standing(zUp, glm::normalize(Vec3(0.35, 0.35, 1.0)) * distance);
    camera.up = standing(zUp, camera.up);
    camera.nearDistance = distance * 1e-3;
    camera.farDistance = distance * 1e2;
    return camera;
}

void fitDepthRange(Camera& camera, const Scene& scene) {
    const double radius = radiusOf(scene);
    const double distance = glm::length(camera.eye - scene.boundingSphere().centre);
    // Outside the bounding sphere no point of the scene is nearer than it; inside, near is a fraction of its radius. Reversed
    // depth keeps its precision at such ratios.
    camera.nearDistance = std::max(distance - radius, radius * 1e-3) * 0.5;
    camera.farDistance = (distance + radius) * 2.0;
}

const std::vector<BuiltInPath>& builtInPaths() {
    static const std::vector<BuiltInPath> kPaths = [] {
        std::vector<BuiltInPath> paths;
        for (const Maker& maker : makers()) paths.push_back(maker.path);
        return paths;
    }();
    return kPaths;
}

std::string builtInPathNames() {
    std::string names;
    for (const BuiltInPath& path : builtInPaths()) names += (names.empty() ? "" : ", ") + path.id;
    return names;
}

}  // namespace cullscope
