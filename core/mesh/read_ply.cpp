// A reader of its own instead of OpenMesh's, which converts doubles to float, supports no triangle strips, allocates by the
// counts that a header states, and cannot say where a file is wrong.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_rows.h"

namespace cullscope {
namespace {

static_assert(std::endian::native == std::endian::little, "the fast paths copy little-endian values as they are");

constexpr size_t kChunk = size_t{128} << 10;

template <typename Value>
Value loadAs(const char* bytes, bool bigEndian) {
    std::array<char, sizeof(Value)> raw{};
    std::memcpy(raw.data(), bytes, sizeof(Value));
    if (bigEndian) std::ranges::reverse(raw);
    return std::bit_cast<Value>(raw);
}

/// Any scalar as a double, which represents all of them exactly.
double scalarAt(const char* bytes, PlyType type, bool bigEndian) {
    switch (type) {
        case PlyType::Int8:
            return loadAs<int8_t>(bytes, bigEndian);
        case PlyType::Uint8:
            return loadAs<uint8_t>(bytes, bigEndian);
        case PlyType::Int16:
            return loadAs<int16_t>(bytes, bigEndian);
        case PlyType::Uint16:
            return loadAs<uint16_t>(bytes, bigEndian);
        case PlyType::Int32:
            return loadAs<int32_t>(bytes, bigEndian);
        case PlyType::Uint32:
            return loadAs<uint32_t>(bytes, bigEndian);
        case PlyType::Float32:
            return loadAs<float>(bytes, bigEndian);
        case PlyType::Float64:
            return loadAs<double>(bytes, bigEndian);
    }
    return 0.0;
}

/// A vertex index of the file; kNoVertex for negative and too large ones.
uint32_t vertexNumber(double value) { return value >= 0.0 && value < 4294967295.0 ? static_cast<uint32_t>(value) : kNoVertex; }

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
enum class ListUse { Skip, Face, Strip };

ListUse useOfList(const PlyElement& element, const PlyProperty& property) {
    const bool indices = property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
    if (indices && element.name == "face") return ListUse::Face;
    return indices && element.name == "tristrips" ? ListUse::Strip : ListUse::Skip;
}

class BinaryBody {
public:
    BinaryBody(ReadJob& job, PlySink& sink, bool bigEndian) : m_source(job.source), m_sink(sink), m_bigEndian(bigEndian) {}

    void readVertices(const PlyElement& element);
    /// Reads faces and strips, and skips other elements.
    void readLists(const PlyElement& element);

private:
    const char* need(uint64_t bytes, const PlyElement& element, uint64_t row);
    void readVertexRow(const PlyElement& element, const char* row);
    void readFixedVertices(const PlyElement& element);
    bool readTriangleRows(const PlyElement& element, uint64_t& row);
    void readRow(const PlyElement& element, uint64_t row);
    void readList(const PlyElement& element, const PlyProperty& property, uint64_t row);

    ByteSource& m_source;
    PlySink& m_sink;
    bool m_bigEndian;
    std::vector<double> m_row;
};

const char* BinaryBody::need(uint64_t bytes, const PlyElement& element, uint64_t row) {
    const std::string_view view = m_source.peek(bytes);
    if (view.size() < bytes)
        throwInput(CULLSCOPE_TR("%1 ends at byte %2, within number %3 of the %4 of \"%5\" that it promises. The file was cut "
                                "off: fetch it again."),
                   {m_source.name(), std::to_string(m_source.size()), std::to_string(row + 1), std::to_string(element.count),
                    element.name});
    return view.data();
}

void BinaryBody::readVertexRow(const PlyElement& element, const char* row) {
    m_row.clear();
    for (const PlyProperty& property : element.properties) {
        m_row.push_back(scalarAt(row, property.type, m_bigEndian));
        row += plySize(property.type);
    }
    const auto value = [&](int i) { return m_row[static_cast<size_t>(m_sink.place()[i])]; };
    m_sink.addVertex({value(0), value(1), value(2)},
                     m_sink.hasNormals() ? Vec3f(Vec3(value(3), value(4), value(5))) : Vec3f(0.0F));
}

/// The offset in the row of three consecutive float properties; -1 where they are not.
int floatsSideBySide(const PlyElement& element, const int* place) {
    int offset = 0;
    for (int i = 0; i < place[0]; ++i) offset += static_cast<int>(plySize(element.properties[i].type));
    for (int i = 0; i < 3; ++i)
        if (place[i] != place[0] + i || element.properties[place[i]].type != PlyType::Float32) return -1;
    return offset;
}

void BinaryBody::readFixedVertices(const PlyElement& element) {
    const uint64_t stride = element.smallestRow();
    const int position = m_bigEndian ? -1 : floatsSideBySide(element, m_sink.place().data());
    const int normal = position >= 0 && m_sink.hasNormals() ? floatsSideBySide(element, m_sink.place().data() + 3) : -1;
    const bool fast = position >= 0 && !m_sink.isWide() && (normal >= 0 || !m_sink.hasNormals());
    const uint64_t rowsAtOnce = std::max<uint64_t>(1, kChunk / stride);
    for (uint64_t row = 0; row < element.count;) {
        const uint64_t rows = std::min(rowsAtOnce, element.count - row);
        const char* bytes = need(rows * stride, element, row);
        for (uint64_t i = 0; i < rows; ++i, bytes += stride) {
            if (fast)
                m_sink.addVertex(Vec3(loadAs<Vec3f>(bytes + position, false)),
                                 normal >= 0 ? loadAs<Vec3f>(bytes + normal, false) : Vec3f(0.0F));
            else
                readVertexRow(element, bytes);
        }
        m_source.skip(rows * stride);
        row += rows;
    }
}

void BinaryBody::readVertices(const PlyElement& element) {
    if (!element.hasLists()) return readFixedVertices(element);
    for (uint64_t row = 0; row < element.count; ++row) {
        m_row.clear();
        for (const PlyProperty& property : element.properties) {
            if (property.isList) {
                m_row.push_back(0.0);
                readList(element, property, row);
            } else {
                m_row.push_back(scalarAt(need(plySize(property.type), element, row), property.type, m_bigEndian));
                m_source.skip(plySize(property.type));
            }
        }
        const auto value = [&](int i) { return m_row[static_cast<size_t>(m_sink.place()[i])]; };
        m_sink.addVertex({value(0), value(1), value(2)},
                         m_sink.hasNormals() ? Vec3f(Vec3(value(3), value(4), value(5))) : Vec3f(0.0F));
    }
}

/// Reads a list in pieces, so that a long one needs no buffer of its own.
void BinaryBody::readList(const PlyElement& element, const PlyProperty& property, uint64_t row) {
    const size_t size = plySize(property.type);
    const double claimed = scalarAt(need(plySize(property.countType), element, row), property.countType, m_bigEndian);
    const uint64_t at = m_source.position();
    m_source.skip(plySize(property.countType));
    if (claimed < 0.0 || claimed * static_cast<double>(size) > static_cast<double>(m_source.remaining()))
        throwInput(
            CULLSCOPE_TR(
                "%1, byte %2: number %3 of \"%4\" promises a list of %5, but %6 bytes are left. The file was cut off or changed: "
                "fetch it again."),
            {m_source.name(), std::to_string(at), std::to_string(row + 1), shownWord(element.name),
             std::to_string(static_cast<int64_t>(claimed)), std::to_string(m_source.remaining())});
    const ListUse use = useOfList(element, property);
    auto left = static_cast<uint64_t>(claimed);
    if (use == ListUse::Skip) return m_source.skip(left * size);
    while (left > 0) {
        const uint64_t values = std::min<uint64_t>(left, kChunk / size);
        const char* bytes = need(values * size, element, row);
        for (uint64_t i = 0; i < values; ++i, bytes += size) {
            const double value = scalarAt(bytes, property.type, m_bigEndian);
            if (use == ListUse::Face)
                m_sink.addCorner(vertexNumber(value));
            else
                m_sink.addStripValue(value);
        }
        m_source.skip(values * size);
        left -= values;
    }
    if (use == ListUse::Face)
        m_sink.endFace();
    else
        m_sink.endStrip();
}

void BinaryBody::readRow(const PlyElement& element, uint64_t row) {
    for (const PlyProperty& property : element.properties) {
        if (property.isList) {
            readList(element, property, row);
        } else {
            need(plySize(property.type), element, row);
            m_source.skip(plySize(property.type));
        }
    }
}

/// The usual layout: one list with a byte for the count and 32-bit indices, and scalars before or after it. Reads as many
/// consecutive triangles as are buffered; false where the next face is no triangle.
bool BinaryBody::readTriangleRows(const PlyElement& element, uint64_t& row) {
    size_t before = 0;
    size_t after = 0;
    bool listSeen = false;
    for (const PlyProperty& property : element.properties) {
        if (property.isList)
            listSeen = true;
        else
            (listSeen ? after : before) += plySize(property.type);
    }
    const size_t stride = before + 1 + 3 * sizeof(uint32_t) + after;
    const std::string_view view = m_source.peek(std::max(stride, kChunk));
    const char* bytes = view.data();
    const char* end = bytes + view.size();
    const uint64_t first = row;
    for (; row < element.count && static_cast<size_t>(end - bytes) >= stride && bytes[before] == 3; ++row, bytes += stride) {
        const auto corners = loadAs<std::array<uint32_t, 3>>(bytes + before + 1, false);
        m_sink.addTriangle(corners[0], corners[1], corners[2]);
    }
    m_source.skip(static_cast<uint64_t>(bytes - view.data()));
    return row > first;
}

bool hasUsualLayout(const PlyElement& element, bool bigEndian) {
    size_t lists = 0;
    bool usual = !bigEndian && element.name == "face";
    for (const PlyProperty& property : element.properties) {
        if (!property.isList) continue;
        ++lists;
        usual = usual && useOfList(element, property) == ListUse::Face && plySize(property.countType) == 1 &&
                plySize(property.type) == 4;
    }
    return usual && lists == 1;
}

void BinaryBody::readLists(const PlyElement& element) {
    if (!element.hasLists()) return m_source.skip(element.count * element.smallestRow());
    if (element.name == "face") m_sink.beginFaces(std::min(element.count, m_source.remaining() / 4));
    const bool usual = hasUsualLayout(element, m_bigEndian);
    for (uint64_t row = 0; row < element.count;) {
        if (usual && readTriangleRows(element, row)) continue;
        readRow(element, row++);
    }
}

class AsciiBody {
public:
    AsciiBody(ReadJob& job, PlySink& sink) : m_job(job), m_rows(job.source, '\0'), m_sink(sink) {}

    void readVertices(const PlyElement& element) {
        for (uint64_t row = 0; row < element.count; ++row) {
            if (!m_rows.nextRow()) m_rows.refuseEnd();
            m_row.clear();
            for (const PlyProperty& property : element.properties) {
                m_row.push_back(property.isList ? 0.0 : m_rows.real());
                if (property.isList) readList(element, property);
            }
            const auto value = [&](int i) { return m_row[static_cast<size_t>(m_sink.place()[i])]; };
            m_sink.addVertex({value(0), value(1), value(2)},
                             m_sink.hasNormals() ? Vec3f(Vec3(value(3), value(4), value(5))) : Vec3f(0.0F));
        }
    }

    void readLists(const PlyElement& element) {
        if (element.name == "face") m_sink.beginFaces(std::min(element.count, m_job.source.remaining() / 6));
        for (uint64_t row = 0; row < element.count; ++row) {
            if (element.properties.empty()) return;
            if (!m_rows.nextRow()) m_rows.refuseEnd();
            for (const PlyProperty& property : element.properties) {
                if (property.isList)
                    readList(element, property);
                else
                    (void)m_rows.word();
            }
        }
    }

private:
    void readList(const PlyElement& element, const PlyProperty& property) {
        const int64_t claimed = m_rows.integer();
        if (claimed < 0 || static_cast<uint64_t>(claimed) > m_job.source.size())
            throwInput(CULLSCOPE_TR("%1, line %2: a list cannot have %3 values. Correct the line or export the file again."),
                       {m_job.source.name(), std::to_string(m_job.source.lineNumber()), std::to_string(claimed)});
        const ListUse use = useOfList(element, property);
        for (int64_t i = 0; i < claimed; ++i) {
            if (use == ListUse::Skip)
                (void)m_rows.word();
            else if (use == ListUse::Face)
                m_sink.addCorner(vertexNumber(static_cast<double>(m_rows.integer())));
            else
                m_sink.addStripValue(static_cast<double>(m_rows.integer()));
        }
        if (use == ListUse::Face) m_sink.endFace();
        if (use == ListUse::Strip) m_sink.endStrip();
    }

    ReadJob& m_job;
    TextRows m_rows;
    PlySink& m_sink;
    std::vector<double> m_row;
};

void refuseUnreadableFaces(const PlyHeader& header, const ByteSource& source) {
    for (const PlyElement& element : header.elements) {
        if (element.name != "face" && element.name != "tristrips") continue;
        const int place = element.find({"vertex_indices", "vertex_index"});
        const bool readable = place >= 0 && element.properties[place].isList && !isReal(element.properties[place].type);
        if (!readable && element.count > 0)
            throwInput(
                CULLSCOPE_TR(
                    "%1, line %2: the faces have no list of whole vertex numbers (vertex_indices). Export the file again."),
                {source.name(), std::to_string(element.line)});
    }
}

template <typename Body>
void readElements(const PlyHeader& header, PlySink& sink, Body& body) {
    bool verticesRead = false;
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex" && !verticesRead) {
            sink.beginVertices(element);
            body.readVertices(element);
            verticesRead = true;
        } else {
            body.readLists(element);
        }
    }
}

}  // namespace

void readPly(ReadJob& job) {
    const PlyHeader header = readPlyHeader(job.source);
    refuseUnreadableFaces(header, job.source);
    RawMesh mesh;
    mesh.name = job.objectName;
    PlySink sink(job, mesh);
    if (header.format == PlyFormat::Ascii) {
        AsciiBody body(job, sink);
        readElements(header, sink, body);
    } else {
        BinaryBody body(job, sink, header.format == PlyFormat::BigEndian);
        readElements(header, sink, body);
        if (job.source.remaining() > 0)
            job.assembler.report.remarks.push_back({CULLSCOPE_TR("Bytes after the end of the mesh that were passed over: %1."),
                                                    {std::to_string(job.source.remaining())}});
    }
    job.assembler.add(std::move(mesh));
}

}  // namespace cullscope
