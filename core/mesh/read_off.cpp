// A reader of its own instead of OpenMesh's, which converts coordinates to float, trusts the counts that a file states and cannot
// say where a file is wrong.
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_rows.h"

namespace cullscope {
namespace {

struct OffHeader {
    bool normals = false;
    bool binary = false;
    uint64_t vertices = 0;
    uint64_t faces = 0;
};

uint32_t vertexNumber(int64_t value) {
    return value >= 0 && value < int64_t{kNoVertex} ? static_cast<uint32_t>(value) : kNoVertex;
}

bool takeLetter(std::string_view& word, std::string_view letters) {
    if (!word.starts_with(letters)) return false;
    word.remove_prefix(letters.size());
    return true;
}

void refuseImpossibleCounts(const ByteSource& source, const OffHeader& header, uint64_t vertexBytes, uint64_t faceBytes) {
    const double needed = static_cast<double>(header.vertices) * static_cast<double>(vertexBytes) +
                          static_cast<double>(header.faces) * static_cast<double>(faceBytes);
    if (needed <= static_cast<double>(source.remaining()) + 1.0) return;
    throwInput(
        CULLSCOPE_TR(
            "%1 promises %2 vertices and %3 faces, but only %4 bytes follow. The file was cut off or changed: fetch it again."),
        {source.name(), std::to_string(header.vertices), std::to_string(header.faces), std::to_string(source.remaining())});
}

uint64_t readCount(TextRows& rows) {
    const std::string_view word = rows.word();
    int64_t count = 0;
    if (!parseInteger(word, count) || count < 0) rows.refuseNumber(word);
    return static_cast<uint64_t>(count);
}

/// The header [ST][C][N][4][n]OFF [BINARY], then the counts. All of the first line but "OFF" may be missing, in old files also
/// "OFF".
OffHeader readHeader(ReadJob& job, TextRows& rows) {
    OffHeader header;
    if (!rows.nextRow()) rows.refuseEnd();
    std::string_view line = rows.rest();
    std::string_view word = takeWord(line);
    if (word.ends_with("OFF")) {
        takeLetter(word, "ST");
        takeLetter(word, "C");
        header.normals = takeLetter(word, "N");
        if (word != "OFF")
            throwInput(CULLSCOPE_TR("%1 is an OFF file of another number of dimensions than three. Export a plain OFF file."),
                       {job.source.name()});
        (void)rows.word();
        if (takeWord(line) == "BINARY") {
            header.binary = true;
            return header;
        }
    }
    header.vertices = readCount(rows);
    header.faces = readCount(rows);
    rows.restOfRow();  // the number of edges is unused and often missing
    return header;
}

void readText(ReadJob& job, TextRows& rows, const OffHeader& header) {
    refuseImpossibleCounts(job.source, header, 6, 2);
    RawMesh mesh;
    mesh.name = job.objectName;
    job.assembler.requireMemory(header.vertices * (sizeof(Vec3) + (header.normals ? sizeof(Vec3f) : 0)));
    mesh.wide.reserve(header.vertices);
    for (uint64_t vertex = 0; vertex < header.vertices; ++vertex) {
        if (!rows.nextRow()) rows.refuseEnd();
        const auto triple = [&] {
            const double x = rows.real();
            const double y = rows.real();
            return Vec3(x, y, rows.real());
        };
        mesh.wide.push_back(triple());
        if (header.normals) mesh.normals.push_back(Vec3f(triple()));
    }
    std::vector<uint32_t> corners;
    for (uint64_t face = 0; face < header.faces; ++face) {
        if (!rows.nextRow()) rows.refuseEnd();
        const std::string_view word = rows.word();
        int64_t count = 0;
        if (!parseInteger(word, count) || count < 0) rows.refuseNumber(word);
        corners.clear();
        for (int64_t corner = 0; corner < count; ++corner) corners.push_back(vertexNumber(rows.integer()));
        mesh.addFace(corners);
        if (++job.assembler.report.facesRead % 4096 == 0) job.assembler.requireMemory(2 * mesh.bytes());
    }
    job.assembler.add(std::move(mesh));
}

/// The body of a binary file: 32-bit numbers. Geomview writes them big-endian with a count of colour components after every face;
/// pmp-library in the machine's byte order and without. The counts show which of both wrote a file.
class BinaryOff {
public:
    BinaryOff(ReadJob& job, OffHeader& header) : m_job(job), m_source(job.source), m_header(header) {}

    void read() {
        const std::string_view counts = need(12);
        m_swap = !plausible(counts.data());
        m_header.vertices = integer(counts.data());
        m_header.faces = integer(counts.data() + 4);
        m_source.skip(12);
        const uint64_t vertexBytes = m_header.normals ? 24 : 12;
        refuseImpossibleCounts(m_source, m_header, vertexBytes, 4);
        RawMesh mesh;
        mesh.name = m_job.objectName;
        mesh.narrow.reserve(m_header.vertices);
        for (uint64_t vertex = 0; vertex < m_header.vertices; ++vertex) {
            const std::string_view bytes = need(vertexBytes);
            mesh.narrow.push_back(triple(bytes.data()));
            if (m_header.normals) mesh.normals.push_back(triple(bytes.data() + 12));
            m_source.skip(vertexBytes);
        }
        // Little-endian files are written by pmp-library; so are those whose size is exactly that of triangles without colours.
        const bool colours = m_swap && m_source.remaining() != 16 * m_header.faces;
        for (uint64_t face = 0; face < m_header.faces; ++face) readFace(mesh, colours);
        m_job.assembler.add(std::move(mesh));
    }

private:
    std::string_view need(uint64_t bytes) {
        const std::string_view view = m_source.peek(bytes);
        if (view.size() < bytes)
            throwInput(
                CULLSCOPE_TR("%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again."),
                {m_source.name(), std::to_string(m_source.size())});
        return view;
    }
    [[nodiscard]] uint32_t integer(const char* bytes) const {
        uint32_t value = 0;
        std::memcpy(&value, bytes, sizeof(value));
        return m_swap ? __builtin_bswap32(value) : value;
    }
    [[nodiscard]] Vec3f triple(const char* bytes) const {
        Vec3f value;
        for (int axis = 0; axis < 3; ++axis) {
            const uint32_t bits = integer(bytes + 4 * axis);
            std::memcpy(&value[axis], &bits, sizeof(bits));
        }
        return value;
    }
    /// Whether the file is large enough for the vertices and faces of its counts, read in this machine's byte order.
    [[nodiscard]] bool plausible(const char* counts) const {
        return 12.0 * integer(counts) + 4.0 * integer(counts + 4) <= static_cast<double>(m_source.size());
    }
    /// Reads a count of following words; throws Error(Input) where the rest of the file is too short for it.
    uint32_t countOfWords() {
        const uint32_t count = integer(need(4).data());
        const uint64_t at = m_source.position();
        m_source.skip(4);
        if (uint64_t{4} * count > m_source.remaining())
            throwInput(
                CULLSCOPE_TR(
                    "%1, byte %2 promises %3 values, but %4 bytes are left. The file was cut off or changed: fetch it again."),
                {m_source.name(), std::to_string(at), std::to_string(count), std::to_string(m_source.remaining())});
        return count;
    }
    void readFace(RawMesh& mesh, bool colours) {
        m_corners.clear();
        for (uint32_t left = countOfWords(); left > 0; --left) {
            m_corners.push_back(integer(need(4).data()));
            m_source.skip(4);
        }
        mesh.addFace(m_corners);
        if (++m_job.assembler.report.facesRead % 4096 == 0) m_job.assembler.requireMemory(2 * mesh.bytes());
        if (colours) m_source.skip(uint64_t{4} * countOfWords());
    }

    ReadJob& m_job;
    ByteSource& m_source;
    OffHeader& m_header;
    bool m_swap = false;
    std::vector<uint32_t> m_corners;
};

}  // namespace

void readOff(ReadJob& job) {
    TextRows rows(job.source, '#');
    OffHeader header = readHeader(job, rows);
    if (header.binary)
        BinaryOff(job, header).read();
    else
        readText(job, rows, header);
}

}  // namespace cullscope
