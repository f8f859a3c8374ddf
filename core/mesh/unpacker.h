#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"

namespace cullscope {

/// How a file as a whole is compressed.
enum class Packing { None, Gzip, Xz };

/// By the first bytes of a file.
[[nodiscard]] Packing packingOf(std::string_view start);

/// Extensions of files that are so compressed, lower case without a dot.
[[nodiscard]] const std::vector<std::string>& packedExtensions();

/// The path without the extension of a compressed file: "a.obj" of "a.obj.xz", whose format and name follow from it. Other paths
/// as they are.
[[nodiscard]] std::filesystem::path withoutPacking(const std::filesystem::path& path);

/// Reads up to `most` bytes of a file after `position`, for the message; 0 at its end. Throws Error(Input).
[[nodiscard]] size_t readBlock(int file, const std::string& name, uint64_t position, char* to, size_t most);

/// The content of a compressed file as a stream. zlib and liblzma check the sums of what they unpack; libarchive, which reads
/// both formats, does not check those of gzip. Members that follow each other in a file are one content. Throws Error(Input),
/// with the byte of the compressed file, where it is damaged or cut off, and where unpacking it needs more than `memoryLimit`
/// bytes; Error(Interrupted) on a stop request.
class Unpacker {
public:
    /// `file`: a descriptor that stands at the begin and stays the caller's.
    Unpacker(int file, std::string name, Packing packing, uint64_t memoryLimit, const Progress& progress);
    ~Unpacker();
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;

    /// Writes up to `most` bytes of the content; 0 only at its end.
    [[nodiscard]] size_t read(char* to, size_t most);
    /// Bytes of the compressed file that were taken.
    [[nodiscard]] uint64_t packedBytes() const { return m_fetched - m_left.size(); }

    class Decoder;

private:
    void refill();

    int m_file;
    std::string m_name;
    Progress m_progress;
    std::vector<char> m_packed;
    std::span<const char> m_left;  ///< of m_packed, not yet decoded
    uint64_t m_fetched = 0;
    bool m_atEnd = false;  ///< of the compressed file
    bool m_finished = false;
    std::unique_ptr<Decoder> m_decoder;
};

/// Unpacks a whole file and returns the size of its content, without keeping it. So damage is found before anything is made of
/// the content, and its size is known as that of a file is. Throws as above, and Error(Input) above `limit` bytes.
[[nodiscard]] uint64_t unpackedSize(int file, const std::string& name, Packing packing, uint64_t packedSize, uint64_t limit,
                                    const Progress& progress);

}  // namespace cullscope
