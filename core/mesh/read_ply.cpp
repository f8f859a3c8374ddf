// A reader of its own instead of OpenMesh's, which converts doubles to float, supports no triangle strips, allocates by the
// counts that a header states, and cannot say where a file is wrong.
#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"
#include "core/mesh/ply_binary.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/ply_sink.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_rows.h"

namespace cullscope {
namespace {

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
        const PlyListUse use = useOfList(element, property);
        for (int64_t i = 0; i < claimed; ++i) {
            if (use == PlyListUse::Skip)
                (void)m_rows.word();
            else if (use == PlyListUse::Face)
                m_sink.addCorner(vertexNumber(static_cast<double>(m_rows.integer())));
            else
                m_sink.addStripValue(static_cast<double>(m_rows.integer()));
        }
        if (use == PlyListUse::Face) m_sink.endFace();
        if (use == PlyListUse::Strip) m_sink.endStrip();
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
        PlyBinaryBody body(job, sink, header.format == PlyFormat::BigEndian);
        readElements(header, sink, body);
        if (job.source.remaining() > 0)
            job.assembler.report.remarks.push_back({CULLSCOPE_TR("Bytes after the end of the mesh that were passed over: %1."),
                                                    {std::to_string(job.source.remaining())}});
    }
    job.assembler.add(std::move(mesh));
}

}  // namespace cullscope
