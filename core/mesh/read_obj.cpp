#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <istream>

#include "core/base/error.h"
#include "core/mesh/obj_lines.h"
#include "core/mesh/readers.h"
#include "core/mesh/steps.h"

namespace cullscope {
namespace {

struct Corner {
    uint32_t vertex = kNoVertex;
    uint32_t normal = kNoVertex;
};

/// An `o` or `g` of the file with its faces; indices count through the whole file.
struct ObjObject {
    std::string name;
    std::vector<Corner> corners;
    std::vector<size_t> faceEnds;  ///< indices into `corners`
};

constexpr int kLongestSearch = 64;
constexpr Vec3 kUnusable(std::numeric_limits<double>::quiet_NaN());

/// Collects the data of tinyobjloader's callbacks.
class ObjContents {
public:
    ObjContents(ReadJob& job, const ObjLines& lines) : m_job(job), m_lines(lines) {
        m_objects.push_back({job.objectName, {}, {}});
    }

    void addVertex(const Vec3& position) {
        m_positions.push_back(m_lines.notFinite() ? kUnusable : position);
        if (m_positions.size() % 4096 == 0) requireMemory();
    }
    void addNormal(const Vec3& normal) { m_normals.push_back(Vec3f(m_lines.notFinite() ? kUnusable : normal)); }
    void addFace(std::span<const tinyobj::index_t> indices);
    void beginObject(std::string name);

    /// Passes the objects to the assembler, each with only the vertices that it uses.
    void assemble();

private:
    void requireMemory() const {
        // The data as read, and a copy for the object being assembled.
        m_job.assembler.requireMemory(2 * m_positions.size() * sizeof(Vec3) + m_normals.size() * sizeof(Vec3f) +
                                      2 * m_cornerCount * sizeof(Corner));
    }
    [[nodiscard]] RawMesh extracted(const ObjObject& object);
    uint32_t localVertex(RawMesh& mesh, const Corner& corner);

    ReadJob& m_job;
    const ObjLines& m_lines;
    std::vector<Vec3> m_positions;
    std::vector<Vec3f> m_normals;
    std::vector<ObjObject> m_objects;
    size_t m_cornerCount = 0;

    // For the object being assembled: the vertices made from each position of the file, as a linked list.
    struct Copy {
        uint32_t normal = kNoVertex;
        uint32_t next = kNoVertex;
    };
    std::vector<uint32_t> m_firstCopy;  ///< by position
    std::vector<uint8_t> m_used;        ///< by position, by any object
    std::vector<Copy> m_copies;         ///< by vertex of the object
    std::vector<uint32_t> m_touched;    ///< positions whose m_firstCopy must be reset
};

/// OBJ counts from 1; negative numbers count back from what has been read so far.
uint32_t resolved(int index, size_t count) {
    if (index > 0) return static_cast<uint32_t>(index) - 1;
    const int64_t fromEnd = static_cast<int64_t>(count) + index;
    return index < 0 && fromEnd >= 0 ? static_cast<uint32_t>(fromEnd) : kNoVertex;
}

void ObjContents::addFace(std::span<const tinyobj::index_t> indices) {
    ObjObject& object = m_objects.back();
    for (const tinyobj::index_t& index : indices)
        object.corners.push_back(
            {resolved(index.vertex_index, m_positions.size()), resolved(index.normal_index, m_normals.size())});
    object.faceEnds.push_back(object.corners.size());
    m_cornerCount += indices.size();
    ++m_job.assembler.report.facesRead;
    if (m_job.assembler.report.facesRead % 4096 == 0) requireMemory();
}

void ObjContents::beginObject(std::string name) {
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.pop_back();
    if (name.empty()) name = m_job.objectName;
    if (m_objects.back().faceEnds.empty())
        m_objects.back().name = std::move(name);
    else
        m_objects.push_back({std::move(name), {}, {}});
}

/// A position that is used with several normals becomes one vertex for each normal.
uint32_t ObjContents::localVertex(RawMesh& mesh, const Corner& corner) {
    if (corner.vertex >= m_positions.size()) return kNoVertex;
    const uint32_t normal = corner.normal < m_normals.size() ? corner.normal : kNoVertex;
    // The search is limited: a position with very many normals gets some vertices twice.
    int steps = 0;
    for (uint32_t copy = m_firstCopy[corner.vertex]; copy != kNoVertex && steps < kLongestSearch;
         copy = m_copies[copy].next, ++steps)
        if (m_copies[copy].normal == normal ||
            (normal != kNoVertex && m_copies[copy].normal != kNoVertex && m_normals[m_copies[copy].normal] == m_normals[normal]))
            return copy;
    const auto made = static_cast<uint32_t>(m_copies.size());
    m_copies.push_back({normal, m_firstCopy[corner.vertex]});
    if (m_firstCopy[corner.vertex] == kNoVertex) m_touched.push_back(corner.vertex);
    m_firstCopy[corner.vertex] = made;
    m_used[corner.vertex] = 1;
    mesh.wide.push_back(m_positions[corner.vertex]);
    mesh.normals.push_back(normal != kNoVertex ? m_normals[normal] : Vec3f(0.0F));
    return made;
}

RawMesh ObjContents::extracted(const ObjObject& object) {
    RawMesh mesh;
    mesh.name = object.name;
    mesh.verticesCounted = true;
    std::vector<uint32_t> face;
    size_t corner = 0;
    inSteps(object.faceEnds.size(), m_job.progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            face.clear();
            for (; corner < object.faceEnds[i]; ++corner) face.push_back(localVertex(mesh, object.corners[corner]));
            mesh.addFace(face);
        }
    });
    const bool anyNormal = std::ranges::any_of(m_copies, [](const Copy& copy) { return copy.normal != kNoVertex; });
    if (!anyNormal) std::vector<Vec3f>().swap(mesh.normals);
    for (const uint32_t position : m_touched) m_firstCopy[position] = kNoVertex;
    m_touched.clear();
    m_copies.clear();
    return mesh;
}

void ObjContents::assemble() {
    LoadReport& report = m_job.assembler.report;
    m_firstCopy.assign(m_positions.size(), kNoVertex);
    m_used.assign(m_positions.size(), 0);
    const double share = 1.0 / static_cast<double>(m_objects.size());
    for (size_t i = 0; i < m_objects.size(); ++i) {
        m_job.assembler.add(extracted(m_objects[i]), share * static_cast<double>(i), share * static_cast<double>(i + 1));
        m_objects[i] = {};
    }
    inSteps(m_positions.size(), m_job.progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            report.unreferencedVertices += m_used[i] ? 0 : 1;
            report.nonFiniteVertices += usableCoordinates(m_positions[i]) ? 0 : 1;
        }
    });
}

std::string joined(const char** names, int count) {
    std::string name;
    for (int i = 0; i < count; ++i) name += (i > 0 ? " " : "") + std::string(names[i]);
    return name;
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* user, double x, double y, double z, double) {
        static_cast<ObjContents*>(user)->addVertex({x, y, z});
    };
    callback.normal_cb = [](void* user, double x, double y, double z) { static_cast<ObjContents*>(user)->addNormal({x, y, z}); };
    callback.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        static_cast<ObjContents*>(user)->addFace({indices, static_cast<size_t>(count)});
    };
    callback.group_cb = [](void* user, const char** names, int count) {
        static_cast<ObjContents*>(user)->beginObject(joined(names, count));
    };
    callback.object_cb = [](void* user, const char* name) { static_cast<ObjContents*>(user)->beginObject(name); };
    return callback;
}

}  // namespace

void readObj(ReadJob& job) {
    ObjLines lines(job.source);
    std::istream stream(&lines);
    stream.exceptions(std::ios::badbit);  // passes on exceptions thrown by the lines
    ObjContents contents(job, lines);
    tinyobj::LoadObjWithCallback(stream, callbacks(), &contents, nullptr);
    job.assembler.report.facesRead += lines.facesWithAbsurdIndex() + lines.facesWithoutCorners();
    job.assembler.report.degenerateFaces += lines.facesWithoutCorners();
    job.assembler.report.outOfRangeFaces += lines.facesWithAbsurdIndex();
    if (lines.unknownLines() > 0)
        job.assembler.report.remarks.push_back(
            {CULLSCOPE_TR("Lines passed over because their keyword is unknown: %1, first line %2."),
             {std::to_string(lines.unknownLines()), std::to_string(lines.firstUnknownLine())}});
    contents.assemble();
}

}  // namespace cullscope
