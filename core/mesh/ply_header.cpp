#include "core/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"

namespace cullscope {
namespace {

constexpr size_t kLongestHeader = size_t{1} << 20;

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames{{{"char", PlyType::Int8},
                                                                           {"int8", PlyType::Int8},
                                                                           {"uchar", PlyType::Uint8},
                                                                           {"uint8", PlyType::Uint8},
                                                                           {"short", PlyType::Int16},
                                                                           {"int16", PlyType::Int16},
                                                                           {"ushort", PlyType::Uint16},
                                                                           {"uint16", PlyType::Uint16},
                                                                           {"int", PlyType::Int32},
                                                                           {"int32", PlyType::Int32},
                                                                           {"uint", PlyType::Uint32},
                                                                           {"uint32", PlyType::Uint32},
                                                                           {"float", PlyType::Float32},
                                                                           {"float32", PlyType::Float32},
                                                                           {"double", PlyType::Float64},
                                                                           {"float64", PlyType::Float64}}};

/// Splits a header into lines at the kind of line end of its first line (LF, CRLF or CR), exactly: the body that follows may
/// begin with a byte that looks like a line end.
class HeaderLines {
public:
    explicit HeaderLines(ByteSource& source) : m_source(source), m_text(source.peek(kLongestHeader).substr(0, kLongestHeader)) {
        const size_t first = m_text.find_first_of("\r\n");
        if (first == std::string_view::npos) return;
        const bool both = m_text[first] == '\r' && first + 1 < m_text.size() && m_text[first + 1] == '\n';
        m_end = both ? "\r\n" : m_text.substr(first, 1);
    }

    std::string_view next() {
        const size_t end = m_end.empty() ? std::string_view::npos : m_text.find(m_end, m_position);
        if (end == std::string_view::npos)
            throwInput(CULLSCOPE_TR("%1, line %2: the PLY header has no end_header. Fetch or export the file again."),
                       {m_source.name(), std::to_string(m_line + 1)});
        const std::string_view line = m_text.substr(m_position, end - m_position);
        m_position = end + m_end.size();
        ++m_line;
        return line;
    }

    [[nodiscard]] size_t position() const { return m_position; }
    [[nodiscard]] uint64_t line() const { return m_line; }

    [[noreturn]] void refuse(std::string_view text) const {
        throwInput(
            CULLSCOPE_TR("%1, line %2: \"%3\" cannot be understood in a PLY header. Correct the line or export the file again."),
            {m_source.name(), std::to_string(m_line), shownWord(text)});
    }

private:
    ByteSource& m_source;
    std::string_view m_text;
    std::string_view m_end;
    size_t m_position = 0;
    uint64_t m_line = 0;
};

PlyType typeNamed(std::string_view name, std::string_view line, const HeaderLines& lines) {
    for (const auto& [known, type] : kTypeNames)
        if (known == name) return type;
    lines.refuse(line);
}

PlyFormat readFormat(HeaderLines& lines) {
    for (;;) {
        const std::string_view line = lines.next();
        std::string_view rest = line;
        const std::string_view keyword = takeWord(rest);
        if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
        const std::string_view format = takeWord(rest);
        const std::string_view version = takeWord(rest);
        if (keyword != "format" || version != "1.0" || !takeWord(rest).empty()) lines.refuse(line);
        if (format == "ascii") return PlyFormat::Ascii;
        if (format == "binary_little_endian") return PlyFormat::LittleEndian;
        if (format == "binary_big_endian") return PlyFormat::BigEndian;
        lines.refuse(line);
    }
}

PlyProperty readProperty(std::string_view rest, std::string_view line, const HeaderLines& lines) {
    PlyProperty property;
    std::string_view word = takeWord(rest);
    property.isList = word == "list";
    if (property.isList) {
        property.countType = typeNamed(takeWord(rest), line, lines);
        word = takeWord(rest);
        if (isReal(property.countType)) lines.refuse(line);
    }
    property.type = typeNamed(word, line, lines);
    property.name = takeWord(rest);
    if (property.name.empty() || !takeWord(rest).empty()) lines.refuse(line);
    return property;
}

PlyElement readElement(std::string_view rest, std::string_view line, const HeaderLines& lines) {
    PlyElement element;
    element.name = takeWord(rest);
    element.line = lines.line();
    int64_t count = 0;
    if (element.name.empty() || !parseInteger(takeWord(rest), count) || count < 0 || !takeWord(rest).empty()) lines.refuse(line);
    element.count = static_cast<uint64_t>(count);
    return element;
}

/// The least number of bytes of an element's rows; in text a digit and a separator for each value.
double smallestBytes(const PlyElement& element, PlyFormat format) {
    const double row = format == PlyFormat::Ascii ? 2.0 * static_cast<double>(element.properties.size())
                                                  : static_cast<double>(element.smallestRow());
    return static_cast<double>(element.count) * row;
}

void refuseImpossibleCounts(const PlyHeader& header, const ByteSource& source) {
    double needed = 0.0;
    for (const PlyElement& element : header.elements) {
        needed += smallestBytes(element, header.format);
        // The last line of a text file may have no line end.
        if (needed > static_cast<double>(source.remaining()) + 1.0)
            throwInput(
                CULLSCOPE_TR(
                    "%1, line %2 promises %3 of \"%4\", but only %5 bytes follow the header. The file was cut off or changed: "
                    "fetch it again."),
                {source.name(), std::to_string(element.line), std::to_string(element.count), shownWord(element.name),
                 std::to_string(source.remaining())});
        if (element.properties.empty() && element.count > source.size())
            throwInput(CULLSCOPE_TR("%1, line %2 promises %3 of \"%4\", which have no properties. Export the file again."),
                       {source.name(), std::to_string(element.line), std::to_string(element.count), shownWord(element.name)});
    }
}

}  // namespace

size_t plySize(PlyType type) {
    constexpr std::array<size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<size_t>(type)];
}

bool isReal(PlyType type) { return type == PlyType::Float32 || type == PlyType::Float64; }

int PlyElement::find(std::initializer_list<std::string_view> names) const {
    for (size_t i = 0; i < properties.size(); ++i)
        if (std::ranges::find(names, properties[i].name) != names.end()) return static_cast<int>(i);
    return -1;
}

uint64_t PlyElement::smallestRow() const {
    uint64_t bytes = 0;
    for (const PlyProperty& property : properties) bytes += plySize(property.isList ? property.countType : property.type);
    return bytes;
}

bool PlyElement::hasLists() const {
    return std::ranges::any_of(properties, [](const PlyProperty& property) { return property.isList; });
}

PlyHeader readPlyHeader(ByteSource& source) {
    HeaderLines lines(source);
    const std::string_view magic = lines.next();
    std::string_view rest = magic;
    if (takeWord(rest) != "ply" || !takeWord(rest).empty()) lines.refuse(magic);
    PlyHeader header;
    header.format = readFormat(lines);
    for (;;) {
        const std::string_view line = lines.next();
        rest = line;
        const std::string_view keyword = takeWord(rest);
        if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "end_header") break;
        if (keyword == "element")
            header.elements.push_back(readElement(rest, line, lines));
        else if (keyword == "property" && !header.elements.empty())
            header.elements.back().properties.push_back(readProperty(rest, line, lines));
        else
            lines.refuse(line);
    }
    source.setLineNumber(lines.line());
    source.skip(lines.position());
    refuseImpossibleCounts(header, source);
    return header;
}

}  // namespace cullscope
