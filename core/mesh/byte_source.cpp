#include "core/mesh/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/memory_limit.h"

namespace cullscope {
namespace {

/// Small enough that even slow text is parsed within a few milliseconds, between two checks for a stop request.
constexpr size_t kBlock = size_t{256} << 10;

}  // namespace

ByteSource::ByteSource(const std::filesystem::path& path, const Progress& progress, bool hash, uint64_t memoryLimit)
    : m_name(path.string()), m_progress(progress) {
    // O_NONBLOCK: opening a pipe that no process writes to would otherwise block forever.
    m_file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (m_file < 0)
        throwInput(CULLSCOPE_TR("%1 cannot be opened: %2. Check the path and the permissions."), {m_name, systemReason(errno)});
    struct stat status {};
    const bool known = fstat(m_file, &status) == 0;
    if (!known || !S_ISREG(status.st_mode) || status.st_size == 0) {
        close(m_file);
        if (known && S_ISDIR(status.st_mode)) throwInput(CULLSCOPE_TR("%1 is a folder. Name a mesh file inside it."), {m_name});
        if (known && S_ISREG(status.st_mode)) throwInput(CULLSCOPE_TR("%1 is empty. Fetch or export the file again."), {m_name});
        throwInput(CULLSCOPE_TR("%1 is not a regular file. Save the mesh in a file and name that."), {m_name});
    }
    m_size = static_cast<uint64_t>(status.st_size);
    try {
        unpackIfPacked(memoryLimit > 0 ? memoryLimit : memoryToPlanWith());
        m_buffer.resize(nextBlock());
    } catch (...) {
        close(m_file);
        throw;
    }
    if (hash) m_hash.emplace();
}

void ByteSource::unpackIfPacked(uint64_t memoryLimit) {
    std::array<char, 6> start{};
    const ssize_t got = pread(m_file, start.data(), start.size(), 0);
    const Packing packing = packingOf({start.data(), static_cast<size_t>(std::max<ssize_t>(got, 0))});
    if (packing == Packing::None) return;
    constexpr double kUnpackingShare = 0.4;
    m_size = unpackedSize(m_file, m_name, packing, m_size, memoryLimit, m_progress.part(0.0, kUnpackingShare));
    m_progress = m_progress.part(kUnpackingShare, 1.0);
    if (m_size == 0) throwInput(CULLSCOPE_TR("%1 is empty. Fetch or export the file again."), {m_name});
    lseek(m_file, 0, SEEK_SET);
    m_unpacker = std::make_unique<Unpacker>(m_file, m_name, packing, memoryLimit, m_progress);
}

ByteSource::~ByteSource() { close(m_file); }

size_t ByteSource::nextBlock() const {
    const uint64_t left = m_size > m_readBytes ? m_size - m_readBytes : 0;
    return static_cast<size_t>(std::min<uint64_t>(kBlock, left + 1));
}

bool ByteSource::refill(size_t wanted) {
    if (m_atEnd) return false;
    m_progress.check();
    if (m_begin > 0) {
        std::memmove(m_buffer.data(), m_buffer.data() + m_begin, m_end - m_begin);
        m_end -= m_begin;
        m_begin = 0;
    }
    // The buffer grows with what has been read, never by more than a file of that many bytes needs.
    const size_t block = nextBlock();
    if (m_buffer.size() < std::min(wanted, m_end + block) || m_end == m_buffer.size()) m_buffer.resize(m_end + block);
    char* const to = m_buffer.data() + m_end;
    const size_t most = std::min(kBlock, m_buffer.size() - m_end);
    const size_t got = m_unpacker ? m_unpacker->read(to, most) : readBlock(m_file, m_name, m_readBytes, to, most);
    m_atEnd = got == 0;
    if (m_hash && got > 0) m_hash->addValues(std::span<const char>(to, got));
    m_end += got;
    m_readBytes += got;
    if (m_tells && got > 0)
        m_progress.tell(std::min(1.0, static_cast<double>(m_readBytes) / static_cast<double>(m_size)),
                        CULLSCOPE_TR("Reading the file"));
    return !m_atEnd;
}

std::string_view ByteSource::peek(size_t wanted) {
    wanted = std::min(wanted, kLongestLine);
    while (m_end - m_begin < wanted && refill(wanted)) {
    }
    return {m_buffer.data() + m_begin, m_end - m_begin};
}

void ByteSource::skip(uint64_t count) {
    while (count > m_end - m_begin) {
        count -= m_end - m_begin;
        m_begin = m_end;
        if (!refill(1)) return;
    }
    m_begin += static_cast<size_t>(count);
}

void ByteSource::decideLineEnd() {
    const std::string_view start = peek(kBlock);
    const bool macintosh = start.find('\n') == std::string_view::npos && start.find('\r') != std::string_view::npos;
    m_lineEnd = macintosh ? '\r' : '\n';
}

bool ByteSource::line(std::string_view& text) {
    if (m_lineEnd == '\0') decideLineEnd();
    size_t searched = 0;
    const char* end = nullptr;
    for (;;) {
        const char* from = m_buffer.data() + m_begin;
        end = static_cast<const char*>(std::memchr(from + searched, m_lineEnd, m_end - m_begin - searched));
        if (end != nullptr) break;
        searched = m_end - m_begin;
        if (searched > kLongestLine)
            throwInput(CULLSCOPE_TR("%1, line %2 is longer than %3 MB. Check that the file is a mesh in a text format."),
                       {m_name, std::to_string(m_lineNumber + 1), std::to_string(kLongestLine >> 20)});
        if (!refill(searched + 1)) break;
    }
    if (end == nullptr && searched == 0) return false;
    const size_t length = end != nullptr ? static_cast<size_t>(end - (m_buffer.data() + m_begin)) : searched;
    text = {m_buffer.data() + m_begin, length};
    m_begin += length + (end != nullptr ? 1 : 0);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    ++m_lineNumber;
    return true;
}

std::string ByteSource::rest() {
    std::string bytes;
    bytes.reserve(remaining());
    while (const size_t got = peek(1).size()) {
        bytes.append(m_buffer.data() + m_begin, got);
        m_begin += got;
    }
    return bytes;
}

std::string ByteSource::sha256() {
    m_tells = false;
    do {
        m_begin = m_end;
    } while (refill(1));
    return m_hash ? m_hash->hexadecimal() : std::string();
}

}  // namespace cullscope
