#pragma once

#include <streambuf>
#include <string>

#include "core/mesh/byte_source.h"

namespace cullscope {

/// Passes an OBJ file to tinyobjloader line by line, and only the lines that it reads correctly. Its number parsers turn words,
/// NaN and missing coordinates silently into 0 and overflow on long integers, and its material code opens files that the mesh
/// names. So `v`, `vn` and `f` lines are checked here first, and of the others only `o` and `g` are passed on. The buffer holds
/// one line at a time: in a callback the members below describe that callback's line.
class ObjLines : public std::streambuf {
public:
    explicit ObjLines(ByteSource& source) : m_source(source) {}

    /// Whether the vertex or normal of this line contains NaN, infinity, or an exponent outside of double's range.
    [[nodiscard]] bool notFinite() const { return m_notFinite; }
    /// Faces that were dropped because an index has more digits than any file has vertices.
    [[nodiscard]] size_t facesWithAbsurdIndex() const { return m_facesWithAbsurdIndex; }
    [[nodiscard]] size_t facesWithoutCorners() const { return m_facesWithoutCorners; }
    /// The number of lines that begin with no keyword of the format, and the first such line.
    [[nodiscard]] size_t unknownLines() const { return m_unknownLines; }
    [[nodiscard]] uint64_t firstUnknownLine() const { return m_firstUnknownLine; }

protected:
    int_type underflow() override;

private:
    [[nodiscard]] bool readLogicalLine();
    [[nodiscard]] bool admitted();
    void checkNumbers(std::string_view rest);
    [[nodiscard]] bool checkFace(std::string_view rest);

    ByteSource& m_source;
    std::string m_line;
    uint64_t m_firstLine = 0;  ///< of the logical line
    bool m_notFinite = false;
    size_t m_facesWithAbsurdIndex = 0;
    size_t m_facesWithoutCorners = 0;
    size_t m_unknownLines = 0;
    uint64_t m_firstUnknownLine = 0;
};

}  // namespace cullscope
