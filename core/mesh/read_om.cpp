// A reader of its own instead of OpenMesh's, which terminates the program by assertions on a file's content (dimensions of a
// chunk, lengths of names), allocates custom properties by lengths that the file states, and builds half-edges. Format:
// OpenMesh's OMFormat.hh.
#include <array>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/readers.h"
#include "core/mesh/steps.h"

namespace cullscope {
namespace {

constexpr size_t kValuesAtOnce = 8192;

/// Constants of the format.
struct Entity {
    enum : unsigned { Vertex = 0, Mesh = 1, Face = 2, Edge = 4, Halfedge = 6, Sentinel = 7 };
};
struct Type {
    enum : unsigned { Position = 0, Normal = 1, Status = 3, Custom = 6, Topology = 7 };
};

/// A chunk's header of 16 bits.
struct Chunk {
    bool named = false;
    unsigned entity = 0;
    unsigned type = 0;
    bool isFloat = false;
    unsigned dimensions = 1;
    unsigned scalarBytes = 1;
    unsigned integerBytes = 1;  ///< of topology, whose header may still carry the float bit of an earlier chunk

    explicit Chunk(uint16_t bits)
        : named((bits >> 1 & 1) != 0),
          entity(bits >> 2 & 7),
          type(bits >> 5 & 15),
          isFloat((bits >> 10 & 1) != 0),
          dimensions((bits >> 11 & 7) + 1),
          scalarBytes((isFloat ? 4U : 1U) << (bits >> 14 & 3)),
          integerBytes(1U << (bits >> 14 & 3)) {}
};

class OmReader {
public:
    explicit OmReader(ReadJob& job) : m_job(job), m_source(job.source) {}

    void read() {
        readHeader();
        m_mesh.name = m_job.objectName;
        while (m_source.remaining() > 0) {
            const Chunk chunk(static_cast<uint16_t>(unsignedValue(2)));
            if (chunk.entity == Entity::Sentinel) break;
            readChunk(chunk);
        }
        walkFaces();
        m_job.assembler.add(std::move(m_mesh));
    }

private:
    [[noreturn]] void refuse() const {
        throwInput(CULLSCOPE_TR("%1, byte %2 cannot stand here in an OM file. The file was changed: fetch or export it again."),
                   {m_source.name(), std::to_string(m_source.position())});
    }
    const char* need(uint64_t bytes) {
        const std::string_view view = m_source.peek(bytes);
        if (view.size() < bytes)
            throwInput(
                CULLSCOPE_TR("%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again."),
                {m_source.name(), std::to_string(m_source.size())});
        return view.data();
    }
    /// A little-endian number of up to eight bytes.
    uint64_t unsignedValue(unsigned bytes) {
        uint64_t value = 0;
        std::memcpy(&value, need(bytes), bytes);
        m_source.skip(bytes);
        return value;
    }
    /// Calls `visit` with each of `count` integers; negative and too large ones are kNoVertex.
    template <typename Visit>
    void readIntegers(uint64_t count, unsigned bytes, Visit&& visit);
    template <typename Visit>
    void readVectors(uint64_t count, const Chunk& chunk, Visit&& visit);

    void readHeader();
    void readChunk(const Chunk& chunk);
    void skipCustom();
    void readFaceCorners(const Chunk& chunk);
    void readHalfedges(const Chunk& chunk);
    void walkFaces();
    [[nodiscard]] uint64_t countOf(unsigned entity) const;

    ReadJob& m_job;
    ByteSource& m_source;
    RawMesh m_mesh;
    char m_kind = 'T';
    unsigned m_majorVersion = 0;
    unsigned m_version = 0;
    uint64_t m_vertices = 0;
    uint64_t m_faces = 0;
    uint64_t m_edges = 0;
    std::vector<uint32_t> m_next;   ///< by half-edge: the next half-edge of its face
    std::vector<uint32_t> m_to;     ///< by half-edge: the vertex it points to
    std::vector<uint32_t> m_first;  ///< by face: one of its half-edges
};

template <typename Visit>
void OmReader::readIntegers(uint64_t count, unsigned bytes, Visit&& visit) {
    const uint64_t largest = bytes == 8 ? ~uint64_t{0} : (uint64_t{1} << (8 * bytes)) - 1;
    while (count > 0) {
        const uint64_t now = std::min<uint64_t>(count, kValuesAtOnce);
        const char* at = need(now * bytes);
        for (uint64_t i = 0; i < now; ++i, at += bytes) {
            uint64_t value = 0;
            std::memcpy(&value, at, bytes);
            visit(value > largest / 2 || value >= kNoVertex ? kNoVertex : static_cast<uint32_t>(value));
        }
        m_source.skip(now * bytes);
        count -= now;
    }
}

template <typename Visit>
void OmReader::readVectors(uint64_t count, const Chunk& chunk, Visit&& visit) {
    if (!chunk.isFloat || chunk.dimensions != 3 || chunk.scalarBytes > 8) refuse();
    const unsigned bytes = 3 * chunk.scalarBytes;
    while (count > 0) {
        const uint64_t now = std::min<uint64_t>(count, kValuesAtOnce);
        const char* at = need(now * bytes);
        for (uint64_t i = 0; i < now; ++i, at += bytes) {
            Vec3f narrow(0.0F);
            Vec3 wide(0.0);
            if (chunk.scalarBytes == 4)
                std::memcpy(&narrow, at, bytes);
            else
                std::memcpy(&wide, at, bytes);
            visit(chunk.scalarBytes == 4 ? Vec3(narrow) : wide);
        }
        m_source.skip(now * bytes);
        count -= now;
    }
}

void OmReader::readHeader() {
    const char* header = need(16);
    m_kind = header[2];
    m_version = static_cast<unsigned char>(header[3]);
    m_majorVersion = m_version >> 5;
    if (header[0] != 'O' || header[1] != 'M' || (m_kind != 'T' && m_kind != 'Q' && m_kind != 'P'))
        throwInput(CULLSCOPE_TR("%1 is no OM file: it does not begin with OMT, OMQ or OMP. Export the mesh again."),
                   {m_source.name()});
    m_source.skip(4);
    m_vertices = unsignedValue(4);
    m_faces = unsignedValue(4);
    m_edges = unsignedValue(4);
    // A vertex takes three floats, a face and an edge a few bytes each.
    if (12.0 * static_cast<double>(m_vertices) + static_cast<double>(m_faces) > static_cast<double>(m_source.remaining()) ||
        (m_majorVersion >= 2 && 6.0 * static_cast<double>(m_edges) > static_cast<double>(m_source.remaining())))
        throwInput(
            CULLSCOPE_TR(
                "%1 promises %2 vertices, %3 faces and %4 edges, but only %5 bytes follow. The file was cut off or changed: "
                "fetch it again."),
            {m_source.name(), std::to_string(m_vertices), std::to_string(m_faces), std::to_string(m_edges),
             std::to_string(m_source.remaining())});
    m_job.assembler.requireMemory(m_vertices * (sizeof(Vec3) + sizeof(Vec3f)) + m_edges * 16 + m_faces * 16);
}

uint64_t OmReader::countOf(unsigned entity) const {
    switch (entity) {
        case Entity::Vertex:
            return m_vertices;
        case Entity::Face:
            return m_faces;
        case Entity::Edge:
            return m_edges;
        case Entity::Halfedge:
            return 2 * m_edges;
        default:
            return 1;
    }
}

void OmReader::skipCustom() {
    constexpr unsigned kFirstVersionWithTypes = 2U << 5 | 2U;
    if (m_version >= kFirstVersionWithTypes) m_source.skip(unsignedValue(1));
    const uint64_t bytes = unsignedValue(4);
    if (bytes > m_source.remaining()) refuse();
    m_source.skip(bytes);
}

void OmReader::readChunk(const Chunk& chunk) {
    if (chunk.named) m_source.skip(unsignedValue(1));
    if (chunk.type == Type::Custom) return skipCustom();
    if (chunk.entity == Entity::Vertex && chunk.type == Type::Position && m_mesh.wide.empty()) {
        m_mesh.wide.reserve(m_vertices);
        return readVectors(m_vertices, chunk, [&](const Vec3& position) { m_mesh.wide.push_back(position); });
    }
    if (chunk.entity == Entity::Vertex && chunk.type == Type::Normal && m_mesh.normals.empty())
        return readVectors(m_vertices, chunk, [&](const Vec3& normal) { m_mesh.normals.push_back(Vec3f(normal)); });
    if (chunk.entity == Entity::Halfedge && chunk.type == Type::Topology && m_to.empty()) return readHalfedges(chunk);
    if (chunk.entity == Entity::Face && chunk.type == Type::Topology && m_first.empty()) {
        if (m_majorVersion < 2) return readFaceCorners(chunk);
        return readIntegers(m_faces, chunk.integerBytes, [&](uint32_t halfedge) { m_first.push_back(halfedge); });
    }
    const uint64_t element = chunk.type == Type::Status     ? 4
                             : chunk.type == Type::Topology ? chunk.integerBytes
                                                            : chunk.dimensions * chunk.scalarBytes;
    if (element * countOf(chunk.entity) > m_source.remaining()) refuse();
    m_source.skip(element * countOf(chunk.entity));
}

/// Before version 2: the corners of every face, preceded by their number in files of polygons.
void OmReader::readFaceCorners(const Chunk& chunk) {
    std::vector<uint32_t> corners;
    for (uint64_t face = 0; face < m_faces; ++face) {
        const uint64_t count = m_kind == 'P' ? unsignedValue(2) : (m_kind == 'T' ? 3 : 4);
        corners.clear();
        readIntegers(count, chunk.integerBytes, [&](uint32_t corner) { corners.push_back(corner); });
        m_mesh.addFace(corners);
        ++m_job.assembler.report.facesRead;
    }
}

/// Since version 2: for every half-edge the next one, the vertex it points to, and its face (not needed here).
void OmReader::readHalfedges(const Chunk& chunk) {
    m_next.reserve(2 * m_edges);
    m_to.reserve(2 * m_edges);
    size_t place = 0;
    readIntegers(6 * m_edges, chunk.integerBytes, [&](uint32_t value) {
        if (place == 0) m_next.push_back(value);
        if (place == 1) m_to.push_back(value);
        place = (place + 1) % 3;
    });
}

void OmReader::walkFaces() {
    std::vector<bool> walked(m_to.size());
    std::vector<uint32_t> corners;
    const auto walk = [&](uint32_t first) {
        corners.clear();
        uint32_t halfedge = first;
        do {
            // In a valid file a half-edge belongs to one face; the check also ends walks around a face that would not terminate.
            if (halfedge >= m_to.size() || walked[halfedge])
                throwInput(
                    CULLSCOPE_TR("%1: the edges of face %2 do not close up. The file was changed: fetch or export it again."),
                    {m_source.name(), std::to_string(m_job.assembler.report.facesRead + 1)});
            walked[halfedge] = true;
            corners.push_back(m_to[halfedge]);
            halfedge = m_next[halfedge];
        } while (halfedge != first);
        m_mesh.addFace(corners);
        ++m_job.assembler.report.facesRead;
    };
    inSteps(m_first.size(), m_job.progress, [&](size_t begin, size_t end) {
        for (size_t face = begin; face < end; ++face) walk(m_first[face]);
    });
}

}  // namespace

void readOm(ReadJob& job) { OmReader(job).read(); }

}  // namespace cullscope
