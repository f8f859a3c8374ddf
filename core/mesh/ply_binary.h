#pragma once

#include <vector>

#include "core/mesh/byte_source.h"
#include "core/mesh/ply_sink.h"

namespace cullscope {

/// Reads the elements of a binary PLY file behind its header, of either byte order.
class PlyBinaryBody {
public:
    PlyBinaryBody(ReadJob& job, PlySink& sink, bool bigEndian) : m_source(job.source), m_sink(sink), m_bigEndian(bigEndian) {}

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

}  // namespace cullscope
