#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/sha256.h"
#include "core/mesh/unpacker.h"

namespace cullscope {

/// A file read once from front to back through one buffer. Counts bytes and lines for error messages, reports progress, checks
/// for a stop request before every block, and hashes the bytes read. Of a file that is compressed with gzip or xz these are the
/// bytes of its content: size, positions and hash are those of the unpacked file. It is unpacked twice, first to check it and to
/// know its size, so that no content is kept in memory or on disk.
class ByteSource {
public:
    /// The longest line of a text file that is accepted: a polygon of a million corners, yet short enough to be parsed between
    /// two checks for a stop request.
    static constexpr size_t kLongestLine = size_t{8} << 20;

    /// Opens a regular, non-empty file. Throws Error(Input) for any other, and for a compressed one that is damaged or unpacks to
    /// more than `memoryLimit` bytes (0: memoryToPlanWith).
    ByteSource(const std::filesystem::path& path, const Progress& progress, bool hash, uint64_t memoryLimit = 0);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    /// The path as the user gave it.
    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] uint64_t size() const { return m_size; }
    /// Offset of the next byte.
    [[nodiscard]] uint64_t position() const { return m_readBytes - (m_end - m_begin); }
    [[nodiscard]] uint64_t remaining() const { return m_size > position() ? m_size - position() : 0; }
    /// Number of the line that `line` returned last, from 1.
    [[nodiscard]] uint64_t lineNumber() const { return m_lineNumber; }
    void setLineNumber(uint64_t number) { m_lineNumber = number; }

    /// All buffered bytes from the current position: at least `wanted` (up to kLongestLine) unless the file ends earlier. Valid
    /// until the next call.
    [[nodiscard]] std::string_view peek(size_t wanted);
    /// Skips `count` bytes, buffered or not.
    void skip(uint64_t count);
    /// Reads the next line without its end (LF, CRLF, or CR where the file has no LF); false at the end of the file.
    [[nodiscard]] bool line(std::string_view& text);

    /// The bytes from the current position to the end of the file, which the caller knows to fit into memory.
    [[nodiscard]] std::string rest();

    /// Reads the rest of the file and returns the hash of the whole file; empty where no hash was requested.
    [[nodiscard]] std::string sha256();

private:
    /// The bytes to read at once: a block, or of a small file what is left of it and one more, which finds its end.
    [[nodiscard]] size_t nextBlock() const;
    bool refill(size_t wanted);
    void unpackIfPacked(uint64_t memoryLimit);
    void decideLineEnd();

    std::string m_name;
    Progress m_progress;
    int m_file = -1;
    std::unique_ptr<Unpacker> m_unpacker;  ///< null where the file is not compressed
    uint64_t m_size = 0;
    uint64_t m_readBytes = 0;
    uint64_t m_lineNumber = 0;
    std::vector<char> m_buffer;
    size_t m_begin = 0;
    size_t m_end = 0;
    bool m_atEnd = false;
    bool m_tells = true;    ///< reports progress; false for bytes that are only hashed after the mesh is made
    char m_lineEnd = '\0';  ///< \0: not yet known
    std::optional<Sha256> m_hash;
};

}  // namespace cullscope
