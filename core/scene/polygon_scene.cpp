#include "core/scene/polygon_scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/mesh_assembler.h"
#include "core/mesh/numbers_in_text.h"
#include "core/mesh/polygon.h"
#include "core/scene/camera_path.h"

namespace cullscope {
namespace {

/// How far a corner may lie from the polygon's plane, in parts of the polygon's size.
constexpr double kFlat = 1e-6;

/// Takes the lines of a file one by one.
class PolygonReader {
public:
    PolygonReader(std::string fileName, const LoadOptions& options, const Progress& progress)
        : m_fileName(std::move(fileName)), m_assembler(m_fileName, options, progress) {}

    void line(uint64_t number, std::string_view text) {
        m_line = number;
        std::string_view rest = text.substr(0, text.find('#'));
        const std::string_view keyword = takeWord(rest);
        if (keyword.empty()) return;
        if (keyword == "polygon")
            polygon(rest);
        else if (keyword == "plane")
            plane(rest);
        else if (keyword == "eye" || keyword == "camera")
            camera(keyword, rest);
        else
            refuse(CULLSCOPE_TR("%1, line %2: \"%3\" is none of polygon, plane, eye and camera. Write one of them, or # before a "
                                "comment."),
                   shownWord(keyword));
    }

    [[nodiscard]] FileScene finish(const std::string& sceneName) {
        if (m_polygonNames.empty())
            throwInput(CULLSCOPE_TR("%1 names no polygon. Write at least one line such as polygon A 0 0 0  1 0 0  0 1 0."),
                       {m_fileName});
        std::vector<MeshPointer> meshes;
        std::vector<Instance> instances;
        for (LoadedObject& object : m_assembler.finish()) {
            instances.push_back({uint32_t(meshes.size()), Mat4(1.0), object.name});
            meshes.push_back(std::move(object.mesh));
        }
        if (m_remarks.camera) {
            const Scene bounds("", meshes, instances);
            if (m_looksAtTheMiddle) m_remarks.camera->target = bounds.boundingSphere().centre;
            if (m_remarks.camera->target == m_remarks.camera->eye)
                refuse(CULLSCOPE_TR("%1, line %2: the camera looks at its own place. Give it another target."), "", m_cameraLine);
            fitDepthRange(*m_remarks.camera, bounds);
        }
        return {std::make_shared<const Scene>(sceneName, std::move(meshes), std::move(instances), nullptr, std::move(m_remarks)),
                std::move(m_assembler.report)};
    }

private:
    [[noreturn]] void refuse(std::string_view sentence, const std::string& more = {}, uint64_t line = 0) const {
        throwInput(sentence, {m_fileName, std::to_string(line > 0 ? line : m_line), more});
    }

    std::string takeName(std::string_view& rest, std::set<std::string>& names) const {
        const std::string name(takeWord(rest));
        double number = 0.0;
        if (name.empty() || parseReal(name, number))
            refuse(CULLSCOPE_TR(
                "%1, line %2: a name is missing before the numbers. Write for example polygon A 0 0 0  1 0 0  0 1 0."));
        if (!names.insert(name).second)
            refuse(CULLSCOPE_TR("%1, line %2: the name \"%3\" is used twice. Give each its own."), shownWord(name));
        return name;
    }

    [[nodiscard]] std::vector<double> numbers(std::string_view rest) const {
        std::vector<double> values;
        for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            double value = 0.0;
            if (!parseReal(word, value) || !(std::abs(value) <= kLargestCoordinate))
                refuse(CULLSCOPE_TR("%1, line %2: \"%3\" is not a usable number. Write one from -1e30 to 1e30, with a point "
                                    "for decimals."),
                       shownWord(word));
            values.push_back(value);
        }
        return values;
    }

    void polygon(std::string_view rest) {
        RawMesh mesh;
        mesh.name = takeName(rest, m_polygonNames);
        const std::vector<double> values = numbers(rest);
        if (values.size() % 3 != 0 || values.size() < 9)
            refuse(CULLSCOPE_TR("%1, line %2: a polygon has three coordinates for each of three or more corners; here are %3 "
                                "numbers."),
                   std::to_string(values.size()));
        std::vector<uint32_t> corners;
        for (size_t i = 0; i < values.size(); i += 3) {
            corners.push_back(uint32_t(mesh.wide.size()));
            mesh.wide.emplace_back(values[i], values[i + 1], values[i + 2]);
        }
        requireFlat(mesh.wide);
        mesh.addFace(corners);
        ++m_assembler.report.facesRead;
        m_assembler.add(std::move(mesh));
    }

    void requireFlat(const std::vector<Vec3>& corners) const {
        const Vec3 area = doubledArea(corners);
        const double length = glm::length(area);
        if (!(length > 0.0))
            refuse(CULLSCOPE_TR("%1, line %2: the polygon has no area. Give it corners around a face, not all on one line."));
        double size = 0.0, away = 0.0;
        for (const Vec3& corner : corners) {
            size = std::max(size, glm::length(corner - corners.front()));
            away = std::max(away, std::abs(glm::dot(corner - corners.front(), area / length)));
        }
        if (away > kFlat * size)
            refuse(CULLSCOPE_TR("%1, line %2: the polygon's corners do not lie in one plane. Write it as several polygons."));
    }

    void plane(std::string_view rest) {
        NamedPlane plane;
        plane.name = takeName(rest, m_planeNames);
        const std::vector<double> values = numbers(rest);
        if (values.size() == 4) {
            plane.normal = {values[0], values[1], values[2]};
            plane.offset = values[3];
        } else if (values.size() == 6) {
            plane.normal = {values[3], values[4], values[5]};
            plane.offset = -glm::dot(plane.normal, Vec3(values[0], values[1], values[2]));
        } else {
            refuse(CULLSCOPE_TR("%1, line %2: a plane is written as a b c d, for ax + by + cz + d = 0, or as a point and a "
                                "normal, six numbers; here are %3."),
                   std::to_string(values.size()));
        }
        if (plane.normal == Vec3(0.0))
            refuse(CULLSCOPE_TR("%1, line %2: the plane's normal is 0. At least one of its three numbers must not be 0."));
        m_remarks.planes.push_back(std::move(plane));
    }

    void camera(std::string_view keyword, std::string_view rest) {
        if (m_remarks.camera) refuse(CULLSCOPE_TR("%1, line %2: the file has a camera already."));
        const std::vector<double> values = numbers(rest);
        m_looksAtTheMiddle = keyword == "eye";
        if (values.size() != (m_looksAtTheMiddle ? 3u : 6u))
            refuse(CULLSCOPE_TR("%1, line %2: an eye has three numbers, a camera six: its place and where it looks."));
        m_remarks.camera = Camera{};
        m_remarks.camera->eye = {values[0], values[1], values[2]};
        if (!m_looksAtTheMiddle) m_remarks.camera->target = {values[3], values[4], values[5]};
        m_cameraLine = m_line;
    }

    std::string m_fileName;
    MeshAssembler m_assembler;
    uint64_t m_line = 0, m_cameraLine = 0;
    std::set<std::string> m_polygonNames, m_planeNames;
    SceneRemarks m_remarks;
    bool m_looksAtTheMiddle = false;
};

}  // namespace

bool isPolygonFile(const std::filesystem::path& path) { return extensionOf(path) == kPolygonExtension; }

FileScene readPolygonFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    ByteSource source(path, progress, false, options.memoryLimitBytes);
    skipByteOrderMark(source);
    PolygonReader reader(source.name(), options, progress);
    for (std::string_view line; source.line(line);) reader.line(source.lineNumber(), line);
    return reader.finish(path.filename().string());
}

FileScene readPolygonText(std::string_view text, const std::string& name, const Progress& progress) {
    PolygonReader reader(name, {}, progress);
    uint64_t number = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        reader.line(++number, text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish(name);
}

}  // namespace cullscope
