#include "core/scene/rvm/rvm_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/mesh_assembler.h"
#include "core/scene/rvm/facets.h"

namespace cullscope {
namespace rvm {
namespace {

double largestScale(const Mat4& transform) {
    double scale = 0.0;
    for (int column = 0; column < 3; ++column) scale = std::max(scale, glm::length(Vec3(transform[column])));
    return scale;
}

/// The largest absolute coordinate of a record, in its own unit.
double reachOf(const Record& record) {
    Box3 box;
    if (record.kind == Record::Kind::Solid) box = primitive::bounds(record.solid);
    for (const Polygon& polygon : record.polygons)
        for (const std::vector<Vec3>& contour : polygon.contours)
            for (const Vec3& corner : contour) box.add(corner);
    if (box.empty()) return 0.0;
    const Vec3 most = glm::max(glm::abs(box.min), glm::abs(box.max));
    return std::max({most.x, most.y, most.z});
}

class SceneBuilder {
public:
    SceneBuilder(std::string fileName, const LoadOptions& options, const Progress& progress, double chordError)
        : m_fileName(std::move(fileName)),
          m_memory(m_fileName, options, progress),
          m_progress(progress),
          m_chordError(chordError) {}

    void beginGroup(std::string name) {
        m_progress.check();
        m_components.groups.push_back({std::move(name), m_open.empty() ? kNoGroup : m_open.back().number});
        m_open.push_back({uint32_t(m_components.groups.size() - 1), {}});
    }

    void add(Record&& record) {
        if (m_open.empty())
            throwInput(CULLSCOPE_TR("%1, byte %2: a primitive lies outside of all groups."),
                       {m_fileName, std::to_string(record.byte)});
        if (const std::optional<Message> why = refusal(record)) {
            if (m_leftOut++ == 0) m_firstLeftOut = {why->english(), std::to_string(record.byte)};
            return;
        }
        m_open.back().records.push_back(std::move(record));
    }

    void endGroup() {
        const Group group = std::move(m_open.back());
        m_open.pop_back();
        if (std::ranges::none_of(group.records, [](const Record& each) { return each.kind != Record::Kind::Line; })) {
            for (const Record& record : group.records) m_loose.push_back(line(record));
            return;
        }
        const Record& first = group.records.front();
        if (group.records.size() == 1 && first.kind == Record::Kind::Solid && glm::determinant(Mat3(first.worldFromRecord)) > 0.0)
            addShared(group, first);
        else
            addOwn(group);
    }

    FileScene finish(std::string name) {
        if (m_instances.empty())
            throwInput(CULLSCOPE_TR("%1 holds no surface. Export the plant with its primitives."), {m_fileName});
        if (m_leftOut > 0)
            m_report.remarks.push_back(
                {CULLSCOPE_TR("Primitives left out because no such solid exists: %1. The first, at byte %2: %3"),
                 {std::to_string(m_leftOut), m_firstLeftOut.byte, m_firstLeftOut.why}});
        m_components.parts.insert(m_components.parts.end(), m_loose.begin(), m_loose.end());
        SceneRemarks remarks;
        remarks.up = UpAxis::Z;
        remarks.components = std::make_shared<const Components>(std::move(m_components));
        return {std::make_shared<const Scene>(std::move(name), std::move(m_meshes), std::move(m_instances), nullptr,
                                              std::move(remarks)),
                std::move(m_report)};
    }

private:
    struct Group {
        uint32_t number = 0;
        std::vector<Record> records;
    };

    static std::optional<Message> refusal(const Record& record) {
        if (record.kind == Record::Kind::Line) return std::nullopt;
        const double scale = largestScale(record.worldFromRecord);
        if (!(std::abs(glm::determinant(Mat3(record.worldFromRecord))) > 1e-6 * scale * scale * scale) || !(scale > 1e-30))
            return Message{CULLSCOPE_TR("Its transform is flat."), {}};
        if (record.kind == Record::Kind::Solid)
            if (std::optional<Message> why = primitive::whyImpossible(record.solid)) return why;
        const double reach = reachOf(record), away = glm::length(Vec3(record.worldFromRecord[3]));
        if (!(reach <= kLargestCoordinate && 2.0 * reach * scale + away <= kLargestCoordinate))
            return Message{CULLSCOPE_TR("It lies beyond 1e30."), {}};
        return std::nullopt;
    }

    /// From the segment (0, 0, 0) to (1, 0, 0).
    static MeshPart line(const Record& record) {
        Mat4 segment(1.0);
        segment[0].x = record.line.y - record.line.x;
        segment[3].x = record.line.x;
        return {MeshPart::Kind::Line, {}, record.worldFromRecord * segment, 0, 0};
    }

    [[nodiscard]] primitive::Fineness fineness(const Record& record) const {
        constexpr double kPartOfSize = 2e-4;
        return {std::max(m_chordError / largestScale(record.worldFromRecord), kPartOfSize * reachOf(record)), 0};
    }

    /// The bits of a solid's sizes and its fineness: equal ones are equal solids.
    [[nodiscard]] std::string keyOf(const Record& record) const {
        const double error = fineness(record).chordError;
        std::string key(1, char(record.solid.index()));
        key.append(reinterpret_cast<const char*>(&error), sizeof(error));
        std::visit(
            [&](const auto& solid) {
                static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(solid)>>);
                key.append(reinterpret_cast<const char*>(&solid), sizeof(solid));
            },
            record.solid);
        return key;
    }

    void addShared(const Group& group, const Record& record) {
        const auto [known, isNew] = m_shared.emplace(keyOf(record), uint32_t(m_meshes.size()));
        if (isNew) {
            primitive::Surface surface;
            primitive::appendSurface(surface, record.solid, fineness(record));
            m_components.parts.push_back(
                {MeshPart::Kind::Solid, record.solid, Mat4(1.0), 0, uint32_t(surface.triangles.size() / 3)});
            endMesh(surface, group);
        }
        addInstance(known->second, record.worldFromRecord, group);
    }

    void addOwn(const Group& group) {
        primitive::Surface surface;
        for (const Record& record : group.records) {
            const auto first = uint32_t(surface.triangles.size() / 3);
            if (record.kind == Record::Kind::Line) {
                m_components.parts.push_back(line(record));
                continue;
            }
            if (record.kind == Record::Kind::Solid)
                primitive::appendSurface(surface, record.solid, fineness(record), record.worldFromRecord);
            m_memory.requireMemory(m_bytesMade + bytesOf(surface));
            for (const Polygon& polygon : record.polygons) {
                ++m_report.facesRead;
                if (!appendPolygon(surface, polygon, record.worldFromRecord, m_progress)) ++m_report.degenerateFaces;
            }
            m_components.parts.push_back({record.kind == Record::Kind::Solid ? MeshPart::Kind::Solid : MeshPart::Kind::Facets,
                                          record.solid, record.worldFromRecord, first,
                                          uint32_t(surface.triangles.size() / 3) - first});
        }
        if (surface.triangles.empty()) {
            const auto own = m_components.parts.begin() + m_components.firstPart.back();
            m_loose.insert(m_loose.end(), own, m_components.parts.end());
            m_components.parts.erase(own, m_components.parts.end());
            return;
        }
        endMesh(surface, group);
        addInstance(uint32_t(m_meshes.size() - 1), Mat4(1.0), group);
    }

    /// As positions and normals in double, and as a mesh.
    static uint64_t bytesOf(const primitive::Surface& surface) {
        return surface.positions.size() * 2 * (sizeof(Vec3) + sizeof(Vec3f)) + surface.triangles.size() * 2 * sizeof(uint32_t);
    }

    void endMesh(const primitive::Surface& surface, const Group& group) {
        m_memory.requireMemory(m_bytesMade + bytesOf(surface));
        m_components.endMesh();
        m_meshes.push_back(primitive::meshOf(surface, m_components.groups[group.number].name));
        m_bytesMade += m_meshes.back()->bytes() + sizeof(TriangleMesh) + sizeof(MeshPart);
    }

    void addInstance(uint32_t mesh, const Mat4& place, const Group& group) {
        std::string name = m_components.groups[group.number].name;
        if (const uint32_t number = ++m_names[name]; number > 1) name += " (" + std::to_string(number) + ")";
        m_report.trianglesMade += m_meshes[mesh]->triangleCount();
        m_instances.push_back({mesh, place, std::move(name), group.number});
    }

    struct LeftOut {
        std::string why, byte;
    };

    std::string m_fileName;
    MeshAssembler m_memory;  ///< for its limit alone
    uint64_t m_bytesMade = 0;
    const Progress& m_progress;
    double m_chordError;
    std::vector<Group> m_open;  ///< groups that have begun, the innermost last
    std::vector<MeshPointer> m_meshes;
    std::vector<Instance> m_instances;
    std::vector<MeshPart> m_loose;  ///< lines of groups without a surface
    Components m_components;
    std::unordered_map<std::string, uint32_t> m_shared, m_names;
    LoadReport m_report;
    size_t m_leftOut = 0;
    LeftOut m_firstLeftOut;
};

}  // namespace
}  // namespace rvm

bool isRvmFile(const std::filesystem::path& path) { return extensionOf(path) == kRvmExtension; }

FileScene readRvmFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress,
                      double chordError) {
    ByteSource source(path, progress, false, options.memoryLimitBytes);
    rvm::SceneBuilder builder(source.name(), options, progress, chordError);
    rvm::readRecords(source, {[&](std::string name) { builder.beginGroup(std::move(name)); }, [&] { builder.endGroup(); },
                              [&](rvm::Record&& record) { builder.add(std::move(record)); }});
    return builder.finish(path.filename().string());
}

}  // namespace cullscope
