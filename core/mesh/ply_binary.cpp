#include "core/mesh/ply_binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"

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

/// The offset in the row of three consecutive float properties; -1 where they are not.
int floatsSideBySide(const PlyElement& element, const int* place) {
    int offset = 0;
    for (int i = 0; i < place[0]; ++i) offset += static_cast<int>(plySize(element.properties[i].type));
    for (int i = 0; i < 3; ++i)
        if (place[i] != place[0] + i || element.properties[place[i]].type != PlyType::Float32) return -1;
    return offset;
}

bool hasUsualLayout(const PlyElement& element, bool bigEndian) {
    size_t lists = 0;
    bool usual = !bigEndian && element.name == "face";
    for (const PlyProperty& property : element.properties) {
        if (!property.isList) continue;
        ++lists;
        usual = usual && useOfList(element, property) == PlyListUse::Face && plySize(property.countType) == 1 &&
                plySize(property.type) == 4;
    }
    return usual && lists == 1;
}

}  // namespace

const char* PlyBinaryBody::need(uint64_t bytes, const PlyElement& element, uint64_t row) {
    const std::string_view view = m_source.peek(bytes);
    if (view.size() < bytes)
        throwInput(CULLSCOPE_TR("%1 ends at byte %2, within number %3 of the %4 of \"%5\" that it promises. The file was cut "
                                "off: fetch it again."),
                   {m_source.name(), std::to_string(m_source.size()), std::to_string(row + 1), std::to_string(element.count),
                    shownWord(element.name)});
    return view.data();
}

void PlyBinaryBody::readVertexRow(const PlyElement& element, const char* row) {
    m_row.clear();
    for (const PlyProperty& property : element.properties) {
        m_row.push_back(scalarAt(row, property.type, m_bigEndian));
        row += plySize(property.type);
    }
    const auto value = [&](int i) { return m_row[static_cast<size_t>(m_sink.place()[i])]; };
    m_sink.addVertex({value(0), value(1), value(2)},
                     m_sink.hasNormals() ? Vec3f(Vec3(value(3), value(4), value(5))) : Vec3f(0.0F));
}

void PlyBinaryBody::readFixedVertices(const PlyElement& element) {
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

void PlyBinaryBody::readVertices(const PlyElement& element) {
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
void PlyBinaryBody::readList(const PlyElement& element, const PlyProperty& property, uint64_t row) {
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
    const PlyListUse use = useOfList(element, property);
    auto left = static_cast<uint64_t>(claimed);
    if (use == PlyListUse::Skip) return m_source.skip(left * size);
    while (left > 0) {
        const uint64_t values = std::min<uint64_t>(left, kChunk / size);
        const char* bytes = need(values * size, element, row);
        for (uint64_t i = 0; i < values; ++i, bytes += size) {
            const double value = scalarAt(bytes, property.type, m_bigEndian);
            if (use == PlyListUse::Face)
                m_sink.addCorner(vertexNumber(value));
            else
                m_sink.addStripValue(value);
        }
        m_source.skip(values * size);
        left -= values;
    }
    if (use == PlyListUse::Face)
        m_sink.endFace();
    else
        m_sink.endStrip();
}

void PlyBinaryBody::readRow(const PlyElement& element, uint64_t row) {
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
bool PlyBinaryBody::readTriangleRows(const PlyElement& element, uint64_t& row) {
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

void PlyBinaryBody::readLists(const PlyElement& element) {
    if (!element.hasLists()) return m_source.skip(element.count * element.smallestRow());
    if (element.name == "face") m_sink.beginFaces(std::min(element.count, m_source.remaining() / 4));
    const bool usual = hasUsualLayout(element, m_bigEndian);
    for (uint64_t row = 0; row < element.count;) {
        if (usual && readTriangleRows(element, row)) continue;
        readRow(element, row++);
    }
}

}  // namespace cullscope
