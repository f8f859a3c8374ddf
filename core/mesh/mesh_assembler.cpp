#include "core/mesh/mesh_assembler.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/memory_limit.h"
#include "core/base/terminal_text.h"
#include "core/mesh/edges.h"
#include "core/mesh/face_checks.h"
#include "core/mesh/float_offsets.h"
#include "core/mesh/normals.h"
#include "core/mesh/steps.h"

namespace cullscope {
namespace {

/// Smaller objects would become zero in single precision.
constexpr double kSmallestExtent = 1e-30;

template <typename Value>
void keepOnly(std::vector<Value>& values, const std::vector<uint32_t>& newNumber) {
    if (values.empty()) return;
    size_t kept = 0;
    for (size_t i = 0; i < values.size(); ++i)
        if (newNumber[i] != kNoVertex) values[kept++] = values[i];
    values.resize(kept);
}

/// Removes the vertices that no face uses.
void dropUnusedVertices(RawMesh& raw, const Progress& progress) {
    std::vector<uint32_t> newNumber(raw.vertexCount(), kNoVertex);
    inSteps(raw.triangles.size(), progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) newNumber[raw.triangles[i]] = 0;
    });
    uint32_t used = 0;
    for (uint32_t& number : newNumber)
        if (number != kNoVertex) number = used++;
    if (used == newNumber.size()) return;
    progress.check();
    keepOnly(raw.wide, newNumber);
    keepOnly(raw.narrow, newNumber);
    keepOnly(raw.normals, newNumber);
    inSteps(raw.triangles.size(), progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) raw.triangles[i] = newNumber[raw.triangles[i]];
    });
}

template <typename Position>
Box3 boundsOf(std::span<const Position> positions, const Progress& progress) {
    Box3 bounds;
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) bounds.add(Vec3(positions[i]));
    });
    return bounds;
}

bool makeUnit(Vec3f& normal) {
    const Vec3 wide(normal);
    const double length = glm::length(wide);
    if (!std::isfinite(length) || length < 1e-30) return false;
    normal = Vec3f(wide / length);
    return true;
}

/// Normalises the file's normals and computes those that are unusable. Returns how many were computed.
size_t completeNormals(TriangleMesh::Data& data, const Progress& progress) {
    std::vector<uint32_t> missing;
    inSteps(data.normals.size(), progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (!makeUnit(data.normals[i])) missing.push_back(static_cast<uint32_t>(i));
    });
    if (!data.normals.empty() && missing.empty()) return 0;
    std::vector<Vec3f> made = areaWeightedNormals(data.positions, data.indices, progress);
    if (data.normals.empty()) {
        data.normals = std::move(made);
        return data.normals.size();
    }
    for (const uint32_t vertex : missing) data.normals[vertex] = made[vertex];
    return missing.size();
}

}  // namespace

MeshAssembler::MeshAssembler(std::string fileName, const LoadOptions& options, const Progress& progress)
    : m_fileName(std::move(fileName)),
      m_memoryLimit(options.memoryLimitBytes > 0 ? options.memoryLimitBytes : memoryToPlanWith()),
      m_progress(progress) {}

void MeshAssembler::requireMemory(uint64_t bytes) const {
    const uint64_t needed = bytes + m_bytesMade;
    if (needed <= m_memoryLimit) return;
    throwInput(
        CULLSCOPE_TR(
            "%1 needs about %2 MB of memory, more than the %3 MB allowed. Simplify the mesh, split the file, or allow more."),
        {m_fileName, std::to_string((needed >> 20) + 1), std::to_string(m_memoryLimit >> 20)});
}

bool MeshAssembler::add(RawMesh raw, double from, double to) {
    const Progress progress = m_progress.part(from, to);
    progress.check();
    progress.tell(0.0, CULLSCOPE_TR("Checking the mesh"));
    // The largest vertex index is 2^31 - 2, because an edge's entry needs one more bit (EdgeBuckets).
    if (raw.vertexCount() >= (size_t{1} << 31))
        throwInput(CULLSCOPE_TR("%1 has more than 2,147,483,647 vertices in one object. Split the object."), {m_fileName});
    const bool analyse = raw.triangles.size() / 3 + raw.polygonEnds.size() <= kOptionalAnalysisLimit;
    requireMemory(raw.bytes() + raw.vertexCount() * (2 * sizeof(Vec3f) + 2) + (analyse ? raw.triangles.size() * 16 : 0));

    if (raw.normals.size() != raw.vertexCount()) std::vector<Vec3f>().swap(raw.normals);
    dropUnusableFaces(raw, report, progress);
    if (analyse) dropDuplicateFaces(raw, report, progress);
    m_fannedPolygons += triangulatePolygons(raw, progress);
    if (raw.triangles.empty()) return false;
    dropUnusedVertices(raw, progress);

    const Box3 bounds = raw.wide.empty() ? boundsOf(std::span<const Vec3f>(raw.narrow), progress)
                                         : boundsOf(std::span<const Vec3>(raw.wide), progress);
    if (bounds.diagonal() < kSmallestExtent)
        throwInput(CULLSCOPE_TR("%1: the object \"%2\" is smaller than 1e-30. Scale it up."),
                   {m_fileName, terminalText(raw.name)});
    TriangleMesh::Data data;
    data.origin = raw.origin.value_or(originForFloats(raw, bounds));
    report.bentByRounding += trianglesBentByRounding(raw, data.origin, progress);
    data.positions = takeOffsets(raw, data.origin, progress);
    data.normals = std::move(raw.normals);
    data.indices = std::move(raw.triangles);
    progress.check();
    progress.tell(0.5, CULLSCOPE_TR("Checking the mesh"));
    const bool hadNormals = !data.normals.empty();
    const size_t made = completeNormals(data, progress);
    report.normalsMade += made;
    if (hadNormals) m_unusableNormals += made;
    if (analyse) report.nonManifoldEdges += countEdges(data.positions, data.indices, progress).nonManifold;
    report.analysed = report.analysed && analyse;
    report.trianglesMade += data.indices.size() / 3;

    nameUniquely(raw.name);
    data.name = raw.name;
    progress.check();
    auto mesh = std::make_shared<const TriangleMesh>(std::move(data));
    m_bytesMade += mesh->bytes();
    m_objects.push_back({std::move(raw.name), std::move(mesh)});
    return true;
}

void MeshAssembler::nameUniquely(std::string& name) {
    const std::string wanted = name;
    for (auto found = m_nextNumber.find(name); found != m_nextNumber.end(); found = m_nextNumber.find(name))
        name = wanted + " (" + std::to_string(m_nextNumber[wanted]++) + ")";
    m_nextNumber.emplace(name, 2);
}

std::vector<LoadedObject> MeshAssembler::finish() {
    if (m_objects.empty()) {
        if (report.facesRead == 0)
            throwInput(CULLSCOPE_TR("%1 holds no faces. Export the mesh with its faces, not only points or lines."),
                       {m_fileName});
        throwInput(
            CULLSCOPE_TR("%1 holds no usable face: all %2 are without area, out of range or not finite. Export the mesh again."),
            {m_fileName, std::to_string(report.facesRead)});
    }
    if (m_unusableNormals > 0)
        report.remarks.push_back({CULLSCOPE_TR("Normals made from the faces because some were missing or unusable: %1."),
                                  {std::to_string(m_unusableNormals)}});
    if (m_fannedPolygons > 0)
        report.remarks.push_back(
            {CULLSCOPE_TR("Polygons with so many corners that they were cut as fans, which may cover too much: %1."),
             {std::to_string(m_fannedPolygons)}});
    if (!report.analysed)
        report.remarks.push_back(
            {CULLSCOPE_TR("Duplicate faces and non-manifold edges were not looked for: the mesh has more than %1 faces."),
             {std::to_string(kOptionalAnalysisLimit)}});
    return std::move(m_objects);
}

}  // namespace cullscope
