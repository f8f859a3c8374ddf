#pragma once

#include <streambuf>
#include <string>

#include "core/mesh/byte_source.h"

namespace cullscope {

/// Hands tinyobjloader an OBJ file line by line, and only lines that it reads rightly. Its number parsers turn what they cannot
/// read (words, NaN, missing coordinates) silently into 0 and overflow on long integers, and its material code opens
/// files that the mesh names; so `v`, `vn` and `f` lines are checked here first, and of the others only `o` and `g` go through.
/// One line is in the buffer at a time: in a callback the members below speak of that callback's line.
class ObjLines : public std::streambuf {
public:
    explicit ObjLines(ByteSource& source) : m_source(source) {}

    /// The vertex or normal of this line is written as NaN, infinite, or with an exponent that no double has.
    [[nodiscard]] bool notFinite() const { return m_notFinite; }
    /// Faces that were not handed on because an index has more digits than any file has vertices.
    [[nodiscard]] size_t facesWithAbsurdIndex() const { return m_facesWithAbsurdIndex; }
    [[nodiscard]] size_t facesWithoutCorners() const { return m_facesWithoutCorners; }
    /// Lines that begin with no keyword of the format, and the first of them.
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
