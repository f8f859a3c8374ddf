#include "core/scene/drawn_sets.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"

namespace cullscope {
namespace {

using TriangleRange = std::pair<uint64_t, uint64_t>;

std::optional<uint64_t> wholeNumber(std::string_view text) {
    uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// "5-9" as [5, 10).
std::optional<TriangleRange> rangeFromText(std::string_view text) {
    const size_t dash = text.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const std::optional<uint64_t> first = wholeNumber(text.substr(0, dash)), last = wholeNumber(text.substr(dash + 1));
    if (!first || !last || *last < *first || *last == std::numeric_limits<uint64_t>::max()) return std::nullopt;
    return TriangleRange{*first, *last + 1};
}

/// Sorted, and joined where they touch.
void join(DrawnSets::Triangles& ranges) {
    std::ranges::sort(ranges);
    DrawnSets::Triangles joined;
    for (const TriangleRange& range : ranges)
        if (!joined.empty() && range.first <= joined.back().second)
            joined.back().second = std::max(joined.back().second, range.second);
        else if (range.first < range.second)
            joined.push_back(range);
    ranges = std::move(joined);
}

std::optional<Viewport> sizeIn(const Json& root, const std::string& file) {
    if (!root.is_object() || !root.contains("size")) return std::nullopt;
    const Json& size = root["size"];
    const auto isSide = [](const Json& side) {
        return side.is_number_unsigned() && side.get<uint64_t>() >= 1 && side.get<uint64_t>() <= kMostPixels;
    };
    if (!size.is_array() || size.size() != 2 || !isSide(size[0]) || !isSide(size[1]))
        throwInput(CULLSCOPE_TR("%1: \"size\" must be two whole numbers from 1 to %2: width and height of the picture."),
                   {file, std::to_string(kMostPixels)});
    return Viewport{size[0].get<int>(), size[1].get<int>()};
}

class Reader {
public:
    Reader(std::string file, const Scene& scene) : m_file(std::move(file)), m_scene(scene) {
        for (uint32_t i = 0; i < scene.instances().size(); ++i) m_objects[scene.instances()[i].name].push_back(i);
    }

    DrawnSets read(const Json& root) {
        if (!root.is_object() || !root.contains("poses") || !root["poses"].is_array() || root["poses"].empty())
            throwInput(CULLSCOPE_TR("%1: drawn sets need a list \"poses\" with at least one pose."), {m_file});
        DrawnSets sets;
        sets.file = m_file;
        sets.path.name = m_file;
        sets.path.fovy = Angle::fromDegrees(lens(root, "fovy_deg", 45.0));
        sets.path.nearDistance = lens(root, "near", sets.path.nearDistance);
        sets.path.farDistance = lens(root, "far", sets.path.farDistance);
        readProjection(root, sets.path);
        sets.size = sizeIn(root, m_file);
        for (const Json& pose : root["poses"]) {
            m_pose = std::to_string(sets.poses.size());
            sets.poses.push_back(drawnAt(pose, sets.byObjects));
            addCamera(pose, sets.path);
        }
        if (!sets.path.poses.empty() && sets.path.poses.size() != sets.poses.size())
            throwInput(CULLSCOPE_TR("%1: some poses have a camera and some have none. Give every pose one, or none."), {m_file});
        return sets;
    }

private:
    double lens(const Json& root, const char* key, double fallback) const {
        if (!root.contains(key)) return fallback;
        if (!root[key].is_number()) throwInput(CULLSCOPE_TR("%1: \"%2\" must be a number."), {m_file, key});
        return root[key].get<double>();
    }

    void readProjection(const Json& root, CameraPath& path) const {
        if (!root.contains("projection")) return;
        const std::optional<ProjectionKind> known =
            root["projection"].is_string() ? projectionFromId(root["projection"].get_ref<const std::string&>()) : std::nullopt;
        if (!known) throwInput(CULLSCOPE_TR("%1: \"projection\" must be \"perspective\" or \"parallel\"."), {m_file});
        path.projection = *known;
        if (*known == ProjectionKind::Perspective) return;
        if (!root.contains("height"))
            throwInput(CULLSCOPE_TR("%1: a parallel projection needs its \"height\", in scene units."), {m_file});
        path.height = lens(root, "height", path.height);
    }

    DrawnSets::Triangles drawnAt(const Json& pose, bool& byObjects) const {
        const bool triangles = pose.is_object() && pose.contains("triangles"),
                   objects = pose.is_object() && pose.contains("objects");
        const char* key = triangles ? "triangles" : "objects";
        if ((!triangles && !objects) || !pose[key].is_array())
            throwInput(CULLSCOPE_TR("%1: pose %2 needs a list \"objects\" or a list \"triangles\" of what is drawn."),
                       {m_file, m_pose});
        byObjects = byObjects && !triangles;
        DrawnSets::Triangles drawn;
        for (const Json& entry : pose[key])
            if (triangles)
                drawn.push_back(numbers(entry, m_scene.triangleCount()));
            else
                addObjects(entry, drawn);
        join(drawn);
        return drawn;
    }

    [[noreturn]] void refuse(const Json& entry) const {
        constexpr size_t kMostShown = 60;
        std::string shown = entry.dump();
        if (shown.size() > kMostShown) shown = std::to_string(shown.size()) + " bytes";
        throwInput(
            CULLSCOPE_TR("%1: pose %2: %3 names nothing in this scene of %4 triangles in %5 objects. Numbers count from 0."),
            {m_file, m_pose, shown, std::to_string(m_scene.triangleCount()), std::to_string(m_scene.instances().size())});
    }

    TriangleRange numbers(const Json& entry, uint64_t count) const {
        std::optional<TriangleRange> range;
        if (entry.is_number_unsigned() && entry.get<uint64_t>() < count)
            range = TriangleRange{entry.get<uint64_t>(), entry.get<uint64_t>() + 1};
        else if (entry.is_string())
            range = rangeFromText(entry.get_ref<const std::string&>());
        if (!range || range->second > count) refuse(entry);
        return *range;
    }

    void addObjects(const Json& entry, DrawnSets::Triangles& drawn) const {
        // The triangles of objects that follow each other do so, too.
        const auto add = [&](uint64_t first, uint64_t last) {
            drawn.emplace_back(m_scene.firstTriangle(first), m_scene.firstTriangle(last) + m_scene.meshOf(last).triangleCount());
        };
        if (entry.is_string())
            if (const auto named = m_objects.find(entry.get_ref<const std::string&>()); named != m_objects.end()) {
                for (const uint32_t object : named->second) add(object, object);
                return;
            }
        const TriangleRange range = numbers(entry, m_scene.instances().size());
        add(range.first, range.second - 1);
    }

    void addCamera(const Json& pose, CameraPath& path) const {
        if (!pose.contains("eye")) return;
        const auto vector = [&](const char* key, const Vec3& fallback) {
            if (!pose.contains(key)) return fallback;
            const Json& list = pose[key];
            if (!list.is_array() || list.size() != 3 ||
                !std::ranges::all_of(list, [](const Json& one) { return one.is_number(); }))
                throwInput(CULLSCOPE_TR("%1: pose %2: \"%3\" must be three numbers."), {m_file, m_pose, key});
            return Vec3(list[0].get<double>(), list[1].get<double>(), list[2].get<double>());
        };
        path.poses.push_back({vector("eye", Vec3(0.0)), vector("target", Vec3(0.0)), vector("up", {0, 1, 0})});
        try {
            validate(path.camera(path.poses.size() - 1), {1, 1});
        } catch (const Error& failure) {
            throwInput(CULLSCOPE_TR("%1: pose %2: %3"), {m_file, m_pose, failure.message().english()});
        }
    }

    std::string m_file;
    const Scene& m_scene;
    std::map<std::string, std::vector<uint32_t>> m_objects;
    std::string m_pose;  ///< the one that is being read
};

}  // namespace

size_t DrawnSets::nearestPose(const Camera& camera) const {
    const auto ahead = [](const Vec3& eye, const Vec3& target) { return glm::normalize(target - eye); };
    const Vec3 direction = ahead(camera.eye, camera.target);
    double scale = 1e-300;
    for (const CameraPath::Pose& pose : path.poses) scale = std::max(scale, glm::length(pose.eye - path.poses.front().eye));
    size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < path.poses.size(); ++i) {
        const CameraPath::Pose& pose = path.poses[i];
        const double away = glm::length(pose.eye - camera.eye) / scale + glm::length(ahead(pose.eye, pose.target) - direction);
        if (away < least) {
            least = away;
            best = i;
        }
    }
    return best;
}

DrawnSets::Triangles rangesOf(std::vector<uint32_t> triangles) {
    std::ranges::sort(triangles);
    DrawnSets::Triangles ranges;
    for (const uint32_t triangle : triangles)
        if (!ranges.empty() && triangle <= ranges.back().second)
            ranges.back().second = std::max<uint64_t>(ranges.back().second, uint64_t(triangle) + 1);
        else
            ranges.emplace_back(triangle, uint64_t(triangle) + 1);
    return ranges;
}

DrawnSets readDrawnSets(const std::filesystem::path& file, const Scene& scene) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file.string()});
    Json root;
    try {
        root = Json::parse(in);
    } catch (const Json::parse_error& failure) {
        throwInput(CULLSCOPE_TR("%1 is not JSON: it breaks off at byte %2. Drawn sets have a list \"poses\"."),
                   {file.string(), std::to_string(failure.byte)});
    } catch (const Json::exception&) {
        throwInput(CULLSCOPE_TR("%1 holds a number that is too large."), {file.string()});
    }
    return Reader(file.string(), scene).read(root);
}

std::optional<Viewport> pictureSizeIn(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const Json root = Json::parse(in, nullptr, false);
    return root.is_discarded() ? std::nullopt : sizeIn(root, file.string());
}

void writeDrawnSets(const std::filesystem::path& file, const WrittenSets& sets) {
    const auto array = [](const Vec3& v) { return Json::array({v.x, v.y, v.z}); };
    Json root{{"scene", sets.scene},
              {"size", {sets.size.width, sets.size.height}},
              {"facing", sets.facing},
              {"fovy_deg", sets.path.fovy.degrees()},
              {"near", sets.path.nearDistance},
              {"far", sets.path.farDistance},
              {"poses", Json::array()}};
    if (sets.path.projection == ProjectionKind::Parallel) {
        root["projection"] = projectionId(sets.path.projection);
        root["height"] = sets.path.height;
    }
    for (const WrittenPose& written : sets.poses) {
        Json pose{{"eye", array(written.pose.eye)}, {"target", array(written.pose.target)}, {"up", array(written.pose.up)}};
        pose["objects"] = written.objects;
        if (!written.triangles.empty() || written.objects.empty()) {
            Json list = Json::array();
            for (const auto& [first, end] : written.triangles)
                list.push_back(end == first + 1 ? Json(first) : Json(std::to_string(first) + "-" + std::to_string(end - 1)));
            pose["triangles"] = std::move(list);
        }
        root["poses"].push_back(std::move(pose));
    }
    writeFileAtomically(file, [&](std::ostream& out) { out << root.dump(1) << '\n'; });
}

}  // namespace cullscope
