#include "core/mesh/file_format.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/load.h"
#include "core/mesh/numbers_in_text.h"

namespace cullscope {
namespace {

void refuseWrapped(std::string_view start, const std::string& name) {
    if (packingOf(start) != Packing::None)
        throwInput(CULLSCOPE_TR("%1 is compressed twice. Unpack it once: xz -dk \"%1\" or gzip -dk \"%1\"."), {name});
    if (start.starts_with("PK\x03\x04") || start.starts_with("BZh") || start.starts_with("\x28\xB5\x2F\xFD"))
        throwInput(CULLSCOPE_TR("%1 is an archive or compressed. Unpack it first."), {name});
    if (start.starts_with("version https://git-lfs"))
        throwInput(CULLSCOPE_TR("%1 is a Git LFS pointer, not the mesh itself. Fetch the mesh with: git lfs pull."), {name});
}

/// Whether the text starts with a UTF-16 byte order mark, or every second byte of its start is zero.
bool isUtf16(std::string_view start) {
    if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) return true;
    const std::string_view sample = start.substr(0, 64);
    if (sample.size() < 8) return false;
    const auto zeroFrom = [&](size_t first) {
        for (size_t i = 0; i < sample.size(); ++i)
            if ((sample[i] == '\0') != (i % 2 == first)) return false;
        return true;
    };
    return zeroFrom(0) || zeroFrom(1);
}

bool beginsOff(std::string_view start) {
    std::string_view rest = start.substr(0, start.find_first_of("\r\n"));
    std::string_view word = takeWord(rest);
    if (word.starts_with("ST")) word.remove_prefix(2);
    if (word.starts_with("C")) word.remove_prefix(1);
    if (word.starts_with("N")) word.remove_prefix(1);
    if (word.starts_with("4") || word.starts_with("n")) word.remove_prefix(1);
    return word == "OFF";
}

bool beginsPly(std::string_view start) {
    return start.size() > 3 && start.starts_with("ply") && (start[3] == '\n' || start[3] == '\r');
}

bool beginsTextStl(std::string_view start) {
    return startsWithIgnoringCase(start, "solid") &&
           (start.find("facet") != std::string_view::npos || start.find("FACET") != std::string_view::npos);
}

}  // namespace

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = withoutPacking(path).extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool hasSizeOfBinaryStl(ByteSource& source) {
    const std::string_view start = source.peek(84);
    if (start.size() < 84 || source.position() != 0) return false;
    uint32_t triangles = 0;
    std::memcpy(&triangles, start.data() + 80, sizeof(triangles));
    return source.size() == 84 + uint64_t{50} * triangles;
}

void skipByteOrderMark(ByteSource& source) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (source.position() == 0 && source.peek(kMark.size()).starts_with(kMark)) source.skip(kMark.size());
}

MeshFormat formatOf(const std::filesystem::path& path, ByteSource& source) {
    const std::string extension = extensionOf(path);
    if (!hasSizeOfBinaryStl(source)) skipByteOrderMark(source);
    const std::string_view start = source.peek(1024).substr(0, 1024);
    refuseWrapped(start, source.name());
    if (isUtf16(start)) throwInput(CULLSCOPE_TR("%1 is UTF-16 text. Save it as UTF-8 or ASCII."), {source.name()});
    if (beginsPly(start)) return MeshFormat::Ply;
    if (beginsOff(start)) return MeshFormat::Off;
    if (beginsTextStl(start) && !hasSizeOfBinaryStl(source)) return MeshFormat::Stl;
    if (extension == "om" ||
        (start.size() > 16 && start.starts_with("OM") && (start[2] == 'T' || start[2] == 'Q' || start[2] == 'P') &&
         extension != "obj" && extension != "off" && extension != "stl" && extension != "ply"))
        return MeshFormat::Om;
    if (extension == "obj") return MeshFormat::Obj;
    if (extension == "ply") return MeshFormat::Ply;
    if (extension == "stl") return MeshFormat::Stl;
    if (extension == "off") return MeshFormat::Off;
    if (hasSizeOfBinaryStl(source)) return MeshFormat::Stl;
    std::string known;
    for (const std::string& readable : readableMeshExtensions()) known += (known.empty() ? "." : ", .") + readable;
    throwInput(CULLSCOPE_TR("%1 is none of the mesh formats that are read (%2). Export the mesh in one of them."),
               {source.name(), known});
}

}  // namespace cullscope
