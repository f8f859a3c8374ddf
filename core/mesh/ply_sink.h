#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/readers.h"

namespace cullscope {

/// A vertex index of the file; kNoVertex for negative and too large ones.
[[nodiscard]] inline uint32_t vertexNumber(double value) {
    return value >= 0.0 && value < 4294967295.0 ? static_cast<uint32_t>(value) : kNoVertex;
}

/// The destination of the values of the element being read: positions and normals of vertices, corners of faces, strips.
class PlySink {
public:
    PlySink(ReadJob& job, RawMesh& mesh) : m_job(job), m_mesh(mesh) {}

    void beginVertices(const PlyElement& element) {
        m_place = {element.find({"x"}),  element.find({"y"}),  element.find({"z"}),
                   element.find({"nx"}), element.find({"ny"}), element.find({"nz"})};
        for (int axis = 0; axis < 3; ++axis)
            if (m_place[axis] < 0 || element.properties[m_place[axis]].isList)
                throwInput(CULLSCOPE_TR("%1, line %2: the vertices have no x, y and z. Export the file again."),
                           {m_job.source.name(), std::to_string(element.line)});
        m_hasNormals = std::all_of(m_place.begin() + 3, m_place.end(),
                                   [&](int place) { return place >= 0 && !element.properties[place].isList; });
        m_wide = std::any_of(m_place.begin(), m_place.begin() + 3, [&](int place) {
            const PlyType type = element.properties[place].type;
            return type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::Uint32;
        });
        m_job.assembler.requireMemory(element.count * (sizeof(Vec3f) + (m_wide ? sizeof(Vec3) : sizeof(Vec3f))));
        if (m_wide)
            m_mesh.wide.reserve(element.count);
        else
            m_mesh.narrow.reserve(element.count);
        if (m_hasNormals) m_mesh.normals.reserve(element.count);
    }
    [[nodiscard]] const std::array<int, 6>& place() const { return m_place; }
    [[nodiscard]] bool hasNormals() const { return m_hasNormals; }
    [[nodiscard]] bool isWide() const { return m_wide; }

    void addVertex(const Vec3& position, const Vec3f& normal) {
        if (m_wide)
            m_mesh.wide.push_back(position);
        else
            m_mesh.narrow.push_back(Vec3f(position));
        if (m_hasNormals) m_mesh.normals.push_back(normal);
    }

    /// `rows`: the number of faces that the file has room for.
    void beginFaces(uint64_t rows) {
        m_job.assembler.requireMemory(m_mesh.bytes() + rows * 3 * sizeof(uint32_t));
        m_mesh.triangles.reserve(rows * 3);
    }
    void addCorner(uint32_t vertex) { m_corners.push_back(vertex); }
    void endFace() {
        m_mesh.addFace(m_corners);
        m_corners.clear();
        ++m_job.assembler.report.facesRead;
    }
    void addTriangle(uint32_t a, uint32_t b, uint32_t c) {
        m_mesh.triangles.insert(m_mesh.triangles.end(), {a, b, c});
        ++m_job.assembler.report.facesRead;
    }

    /// One number of a triangle strip: every second triangle is reversed, a negative number begins a new strip. Triangles with a
    /// repeated corner only join parts of a strip and are not counted as faces.
    void addStripValue(double value) {
        if (value < 0.0) {
            m_stripLength = 0;
            return;
        }
        const uint32_t vertex = vertexNumber(value);
        if (m_stripLength >= 2 && m_strip[0] != m_strip[1] && m_strip[1] != vertex && m_strip[0] != vertex) {
            const bool turned = m_stripLength % 2 == 1;
            addTriangle(m_strip[turned ? 1 : 0], m_strip[turned ? 0 : 1], vertex);
        }
        m_strip = {m_strip[1], vertex};
        ++m_stripLength;
    }
    void endStrip() { m_stripLength = 0; }

private:
    ReadJob& m_job;
    RawMesh& m_mesh;
    std::array<int, 6> m_place{};
    bool m_hasNormals = false;
    bool m_wide = false;
    std::vector<uint32_t> m_corners;
    std::array<uint32_t, 2> m_strip{};
    size_t m_stripLength = 0;
};

/// The use of a list property of an element.
enum class PlyListUse { Skip, Face, Strip };

[[nodiscard]] inline PlyListUse useOfList(const PlyElement& element, const PlyProperty& property) {
    const bool indices = property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
    if (indices && element.name == "face") return PlyListUse::Face;
    return indices && element.name == "tristrips" ? PlyListUse::Strip : PlyListUse::Skip;
}

}  // namespace cullscope
