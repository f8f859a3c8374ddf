// A reader of its own instead of OpenMesh's, which joins corners within a tolerance, trusts the triangle count that a file
// states, supports only one solid and cannot say where a file is wrong.
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/numbers_in_text.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_rows.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

constexpr size_t kHeaderBytes = 84;
constexpr size_t kTriangleBytes = 50;
constexpr size_t kTrianglesAtOnce = 2048;

std::string trimmed(std::string_view text) {
    const size_t begin = text.find_first_not_of(" \t\r\v\f");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r\v\f") - begin + 1));
}

/// Builds one solid; corners at exactly equal positions become one vertex.
template <typename Position>
class SolidBuilder {
public:
    SolidBuilder(ReadJob& job, std::vector<Position> RawMesh::*positions)
        : m_job(job), m_positions(positions), m_welder(job.progress) {
        begin(job.objectName);
    }

    void begin(const std::string& name) {
        m_mesh = {};
        m_mesh.name = name.empty() ? m_job.objectName : name;
        m_welder = Welder<Position>(m_job.progress);
    }
    uint32_t vertex(const Position& position) {
        std::vector<Position>& positions = m_mesh.*m_positions;
        const auto next = static_cast<uint32_t>(positions.size());
        const uint32_t found = m_welder.findOrAdd(position, next, [&](uint32_t i) { return positions[i]; });
        if (found == next) positions.push_back(position);
        return found;
    }
    void addFace(std::span<const uint32_t> corners) {
        m_mesh.addFace(corners);
        if (++m_job.assembler.report.facesRead % 4096 == 0) m_job.assembler.requireMemory(2 * m_mesh.bytes());
    }
    void end() {
        if (!m_mesh.triangles.empty() || !m_mesh.polygonEnds.empty()) m_job.assembler.add(std::move(m_mesh));
        begin({});
    }

private:
    ReadJob& m_job;
    std::vector<Position> RawMesh::*m_positions;
    RawMesh m_mesh;
    Welder<Position> m_welder;
};

void readBinary(ReadJob& job) {
    ByteSource& source = job.source;
    const std::string_view header = source.peek(kHeaderBytes);
    if (header.size() < kHeaderBytes)
        throwInput(CULLSCOPE_TR("%1 ends at byte %2, within the header of a binary STL. The file was cut off: fetch it again."),
                   {source.name(), std::to_string(source.size())});
    uint32_t claimed = 0;
    std::memcpy(&claimed, header.data() + 80, sizeof(claimed));
    source.skip(kHeaderBytes);
    const uint64_t room = source.remaining() / kTriangleBytes;
    if (claimed > room)
        throwInput(CULLSCOPE_TR("%1, byte 80 promises %2 triangles, but the file has room for %3. The file is no STL or was cut "
                                "off: fetch it again."),
                   {source.name(), std::to_string(claimed), std::to_string(room)});
    SolidBuilder<Vec3f> solid(job, &RawMesh::narrow);
    for (uint64_t done = 0; done < claimed;) {
        const uint64_t count = std::min<uint64_t>(kTrianglesAtOnce, claimed - done);
        const char* bytes = source.peek(count * kTriangleBytes).data();
        for (uint64_t i = 0; i < count; ++i, bytes += kTriangleBytes) {
            std::array<Vec3f, 3> corners;
            std::memcpy(corners.data(), bytes + sizeof(Vec3f), sizeof(corners));  // after the facet's normal
            solid.addFace(std::array{solid.vertex(corners[0]), solid.vertex(corners[1]), solid.vertex(corners[2])});
        }
        source.skip(count * kTriangleBytes);
        done += count;
    }
    if (source.remaining() > 0)
        job.assembler.report.remarks.push_back(
            {CULLSCOPE_TR("Bytes after the end of the mesh that were passed over: %1."), {std::to_string(source.remaining())}});
    solid.end();
}

class TextStl {
public:
    explicit TextStl(ReadJob& job) : m_job(job), m_rows(job.source, '\0'), m_solid(job, &RawMesh::wide) {}

    void read() {
        while (m_rows.nextRow()) {
            while (m_rows.hasMore()) readStatement();
        }
        if (m_inFacet) m_rows.refuseEnd();
        m_solid.end();
    }

private:
    void readStatement() {
        const std::string_view word = m_rows.word();
        const auto is = [&](std::string_view keyword) {
            return word.size() == keyword.size() && startsWithIgnoringCase(word, keyword);
        };
        if (is("solid")) {
            m_solid.end();
            m_solid.begin(trimmed(m_rows.restOfRow()));
        } else if (is("endsolid")) {
            m_rows.restOfRow();
            m_solid.end();
        } else if (is("facet")) {
            m_rows.restOfRow();  // the normal of the line is ignored: it follows from the corners
            m_inFacet = true;
        } else if (is("vertex") && m_inFacet) {
            const double x = m_rows.real();
            const double y = m_rows.real();
            m_corners.push_back(m_solid.vertex({x, y, m_rows.real()}));
        } else if (is("endfacet") && m_inFacet) {
            m_solid.addFace(m_corners);
            m_corners.clear();
            m_inFacet = false;
        } else if (!is("outer") && !is("loop") && !is("endloop")) {
            throwInput(
                CULLSCOPE_TR("%1, line %2: \"%3\" cannot stand here in an STL file. Correct the line or export the file again."),
                {m_job.source.name(), std::to_string(m_job.source.lineNumber()), shownWord(word)});
        }
    }

    ReadJob& m_job;
    TextRows m_rows;
    SolidBuilder<Vec3> m_solid;
    std::vector<uint32_t> m_corners;
    bool m_inFacet = false;
};

/// Binary files may begin with "solid" too; they are recognised by their size or by a zero byte.
bool isText(ByteSource& source) {
    const std::string_view start = source.peek(1024).substr(0, 1024);
    const size_t first = start.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && startsWithIgnoringCase(start.substr(first), "solid") &&
           !hasSizeOfBinaryStl(source) && start.find('\0') == std::string_view::npos;
}

}  // namespace

void readStl(ReadJob& job) {
    if (isText(job.source))
        TextStl(job).read();
    else
        readBinary(job);
}

}  // namespace cullscope
