#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/byte_source.h"

namespace cullscope {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

[[nodiscard]] size_t plySize(PlyType type);
[[nodiscard]] bool isReal(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::Uint8;
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    uint64_t line = 0;  ///< line of the header, for messages
    std::vector<PlyProperty> properties;

    /// The index of the first property with one of the names; -1 where there is none.
    [[nodiscard]] int find(std::initializer_list<std::string_view> names) const;
    /// The least number of bytes of a row in a binary file: lists may be empty.
    [[nodiscard]] uint64_t smallestRow() const;
    [[nodiscard]] bool hasLists() const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
};

/// Reads the header and leaves `source` at the first byte after it. Throws Error(Input) for counts that the rest of the file is
/// too short for.
[[nodiscard]] PlyHeader readPlyHeader(ByteSource& source);

}  // namespace cullscope
