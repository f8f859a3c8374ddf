// The JSON form of a camera path.
#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/scene/camera_path.h"

namespace cullscope {
namespace {

constexpr std::array<const char*, 4> kLensFields{"fovy_deg", "near", "far", "height"};
constexpr const char* kProjection = "projection";
constexpr std::array<const char*, 3> kPoseFields{"eye", "target", "up"};

/// The place of a name in a list; the list's length where it has no such name.
template <size_t kCount>
size_t placeOf(const std::array<const char*, kCount>& names, const std::string& name) {
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Reads a camera path while its JSON text is parsed. A tree of the text's values would take twenty times the memory of the text,
/// which may hold anything; here only the poses and one number a lens field are kept.
class PathReader final : public Json::json_sax_t {
public:
    explicit PathReader(const std::filesystem::path& file) : m_file(file.string()) { m_path.name = m_file; }

    /// The path, after the whole text was read.
    CameraPath take() {
        if (!m_hasPoses || m_path.poses.empty())
            throwInput(CULLSCOPE_TR("%1: a camera path needs a list \"poses\" with at least one pose."), {m_file});
        for (size_t field = 0; field < kLensFields.size(); ++field)
            if (m_lensIsWrong[field]) throwInput(CULLSCOPE_TR("%1: \"%2\" must be a number."), {m_file, kLensFields[field]});
        m_path.fovy = Angle::fromDegrees(m_lens[0].value_or(45.0));
        m_path.nearDistance = m_lens[1].value_or(m_path.nearDistance);
        m_path.farDistance = m_lens[2].value_or(m_path.farDistance);
        m_path.height = m_lens[3].value_or(m_path.height);
        if (!m_projection) throwInput(CULLSCOPE_TR("%1: \"projection\" must be \"perspective\" or \"parallel\"."), {m_file});
        m_path.projection = *m_projection;
        if (*m_projection == ProjectionKind::Parallel && !m_lens[3])
            throwInput(CULLSCOPE_TR("%1: a parallel projection needs its \"height\", in scene units."), {m_file});
        return std::move(m_path);
    }

    bool number_integer(number_integer_t value) override { return number(double(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(double(value)); }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool null() override { return begin(Kind::Other); }
    bool boolean(bool) override { return begin(Kind::Other); }
    bool string(string_t& value) override {
        begin(Kind::Other);
        if (!m_places.empty() && m_places.back() == Place::Path && m_key == kProjection) m_projection = projectionFromId(value);
        return true;
    }
    bool binary(binary_t&) override { return begin(Kind::Other); }
    bool start_object(std::size_t) override { return begin(Kind::Object); }
    bool start_array(std::size_t) override { return begin(Kind::List); }
    bool end_array() override { return end(); }
    bool end_object() override {
        if (m_places.back() == Place::Pose) addPose();
        return end();
    }
    bool key(string_t& name) override {
        m_key = name;
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& failure) override {
        if (dynamic_cast<const Json::out_of_range*>(&failure) != nullptr)
            throwInput(
                CULLSCOPE_TR("%1 holds a number that is too large. A camera path has the fields fovy_deg, near, far and poses."),
                {m_file});
        throwInput(CULLSCOPE_TR("%1 is not JSON: it breaks off at byte %2. A camera path has the fields fovy_deg, near, far and "
                                "poses."),
                   {m_file, std::to_string(position)});
    }

private:
    enum class Kind { Object, List, Other };
    /// The groups and lists that are open, from the outermost on, by what is read of them.
    enum class Place : uint8_t { Path, Poses, Pose, Vector, Ignored };

    /// A value that is no number begins, which is also a whole one where it is neither a group nor a list.
    bool begin(Kind kind) {
        const Place place = placeWithin(kind);
        if (kind != Kind::Other) m_places.push_back(place);
        return true;
    }

    Place placeWithin(Kind kind) {
        if (m_places.empty()) return kind == Kind::Object ? Place::Path : Place::Ignored;
        switch (m_places.back()) {
            case Place::Path:
                return placeInPath(kind);
            case Place::Poses:
                beginPose();
                if (kind == Kind::Object) return Place::Pose;
                addPose();
                return Place::Ignored;
            case Place::Pose:
                m_field = placeOf(kPoseFields, m_key);
                if (m_field < kPoseFields.size()) m_counts[m_field] = 0;
                return m_field < kPoseFields.size() && kind == Kind::List ? Place::Vector : Place::Ignored;
            case Place::Vector:
                m_counts[m_field] = kPoseFields.size() + 1;  // not three numbers, whatever follows
                return Place::Ignored;
            case Place::Ignored:
                break;
        }
        return Place::Ignored;
    }

    Place placeInPath(Kind kind) {
        if (m_key == "poses") {
            m_hasPoses = kind == Kind::List;
            m_path.poses.clear();
            return m_hasPoses ? Place::Poses : Place::Ignored;
        }
        if (m_key == kProjection) m_projection.reset();
        if (const size_t field = placeOf(kLensFields, m_key); field < kLensFields.size()) m_lensIsWrong[field] = true;
        return Place::Ignored;
    }

    bool number(double value) {
        if (!m_places.empty() && m_places.back() == Place::Vector) {
            size_t& count = m_counts[m_field];
            if (count < 3) m_vectors[m_field][static_cast<int>(count)] = value;
            count = std::min(count + 1, kPoseFields.size() + 1);
            return true;
        }
        const size_t field = placeOf(kLensFields, m_key);
        if (!m_places.empty() && m_places.back() == Place::Path && field < kLensFields.size()) {
            m_lens[field] = value;
            m_lensIsWrong[field] = false;
            return true;
        }
        return begin(Kind::Other);
    }

    void beginPose() {
        if (m_path.poses.size() == kMostPoses)
            throwInput(CULLSCOPE_TR("%1 has more than %2 poses. Divide the path into several files."),
                       {m_file, std::to_string(kMostPoses)});
        m_counts = {};
    }

    void addPose() {
        for (size_t field = 0; field < kPoseFields.size(); ++field)
            if (m_counts[field] != 3)
                throwInput(CULLSCOPE_TR("%1: pose %2: \"%3\" must be three numbers."),
                           {m_file, std::to_string(m_path.poses.size()), kPoseFields[field]});
        m_path.poses.push_back({m_vectors[0], m_vectors[1], m_vectors[2]});
    }

    bool end() {
        m_places.pop_back();
        return true;
    }

    std::string m_file;
    CameraPath m_path;
    std::vector<Place> m_places;
    std::string m_key;  ///< the last one
    std::array<std::optional<double>, kLensFields.size()> m_lens;
    std::array<bool, kLensFields.size()> m_lensIsWrong{};
    std::optional<ProjectionKind> m_projection = ProjectionKind::Perspective;  ///< none: its word is wrong
    bool m_hasPoses = false;
    // Of the pose that is being read:
    size_t m_field = 0;
    std::array<Vec3, 3> m_vectors{};
    std::array<size_t, 3> m_counts{};  ///< the entries of each vector so far
};

}  // namespace

CameraPath readCameraPath(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file.string()});
    PathReader reader(file);
    Json::sax_parse(in, &reader);
    CameraPath path = reader.take();
    size_t pose = 0;
    try {
        for (; pose < path.poses.size(); ++pose) validate(path.camera(pose), {1, 1});
    } catch (const Error& failure) {
        throwInput(CULLSCOPE_TR("%1: pose %2: %3"), {file.string(), std::to_string(pose), failure.message().english()});
    }
    return path;
}

void writeCameraPath(const std::filesystem::path& file, const CameraPath& path) {
    const auto array = [](const Vec3& v) { return Json::array({v.x, v.y, v.z}); };
    Json json{{"fovy_deg", path.fovy.degrees()}, {"near", path.nearDistance}, {"far", path.farDistance}};
    if (path.projection == ProjectionKind::Parallel) {
        json[kProjection] = projectionId(path.projection);
        json["height"] = path.height;
    }
    json["poses"] = Json::array();
    for (const CameraPath::Pose& pose : path.poses)
        json["poses"].push_back({{"eye", array(pose.eye)}, {"target", array(pose.target)}, {"up", array(pose.up)}});
    writeFileAtomically(file, [&](std::ostream& out) { out << json.dump(1) << '\n'; });
}

}  // namespace cullscope
