#include "core/mesh/unpacker.h"

#include <lzma.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <new>
#include <span>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// Of the compressed file at once; between two of them a stop request is looked for. Highly compressed, they make some megabytes.
constexpr size_t kPackedBlock = size_t{16} << 10;

}  // namespace

/// One of both libraries: takes compressed bytes and makes content until one of both ends.
class Unpacker::Decoder {
public:
    enum class Result { Going, Finished, Damaged, CutOff, TooMuchMemory };

    virtual ~Decoder() = default;
    /// Advances both spans. `last`: after these bytes the file ends.
    virtual Result decode(std::span<const char>& packed, std::span<char>& content, bool last) = 0;
};

namespace {

class GzipDecoder : public Unpacker::Decoder {
public:
    GzipDecoder() {
        constexpr int kGzipOnly = 16;
        if (inflateInit2(&m_stream, MAX_WBITS + kGzipOnly) != Z_OK) throw std::bad_alloc();
    }
    ~GzipDecoder() override { inflateEnd(&m_stream); }
    GzipDecoder(const GzipDecoder&) = delete;
    GzipDecoder& operator=(const GzipDecoder&) = delete;

    Result decode(std::span<const char>& packed, std::span<char>& content, bool last) override {
        if (m_betweenMembers) {
            // Zeros may fill up the last block of a tape; everything else begins another member.
            while (!packed.empty() && packed.front() == 0) packed = packed.subspan(1);
            if (packed.empty()) return last ? Result::Finished : Result::Going;
            inflateReset(&m_stream);
            m_betweenMembers = false;
        }
        m_stream.next_in = reinterpret_cast<z_const Bytef*>(const_cast<char*>(packed.data()));  // zlib does not write there
        m_stream.avail_in = static_cast<unsigned>(packed.size());
        m_stream.next_out = reinterpret_cast<unsigned char*>(content.data());
        m_stream.avail_out = static_cast<unsigned>(content.size());
        const int result = inflate(&m_stream, Z_NO_FLUSH);
        const bool moved = m_stream.avail_in < packed.size() || m_stream.avail_out < content.size();
        packed = packed.last(m_stream.avail_in);
        content = content.last(m_stream.avail_out);
        if (result == Z_MEM_ERROR) return Result::TooMuchMemory;
        if (result == Z_STREAM_END) m_betweenMembers = true;
        if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) return Result::Damaged;
        return moved || !last ? Result::Going : Result::CutOff;
    }

private:
    z_stream m_stream{};
    bool m_betweenMembers = false;
};

class XzDecoder : public Unpacker::Decoder {
public:
    explicit XzDecoder(uint64_t memoryLimit) {
        if (lzma_stream_decoder(&m_stream, memoryLimit, LZMA_CONCATENATED) != LZMA_OK) throw std::bad_alloc();
    }
    ~XzDecoder() override { lzma_end(&m_stream); }
    XzDecoder(const XzDecoder&) = delete;
    XzDecoder& operator=(const XzDecoder&) = delete;

    Result decode(std::span<const char>& packed, std::span<char>& content, bool last) override {
        m_stream.next_in = reinterpret_cast<const uint8_t*>(packed.data());
        m_stream.avail_in = packed.size();
        m_stream.next_out = reinterpret_cast<unsigned char*>(content.data());
        m_stream.avail_out = content.size();
        const lzma_ret result = lzma_code(&m_stream, last ? LZMA_FINISH : LZMA_RUN);
        const bool moved = m_stream.avail_in < packed.size() || m_stream.avail_out < content.size();
        packed = packed.last(m_stream.avail_in);
        content = content.last(m_stream.avail_out);
        switch (result) {
            case LZMA_OK:
                return Result::Going;
            case LZMA_STREAM_END:
                return Result::Finished;
            case LZMA_MEM_ERROR:
            case LZMA_MEMLIMIT_ERROR:
                return Result::TooMuchMemory;
            case LZMA_BUF_ERROR:
                return moved || !last ? Result::Going : Result::CutOff;
            default:
                return Result::Damaged;
        }
    }

private:
    lzma_stream m_stream = LZMA_STREAM_INIT;
};

std::unique_ptr<Unpacker::Decoder> decoderFor(Packing packing, uint64_t memoryLimit) {
    if (packing == Packing::Xz) return std::make_unique<XzDecoder>(memoryLimit);
    return std::make_unique<GzipDecoder>();
}

[[noreturn]] void refuseTooLarge(const std::string& name, uint64_t limit) {
    throwInput(CULLSCOPE_TR("%1 unpacks to more than the %2 MB that may be used on this machine. Simplify the mesh or split the "
                            "file."),
               {name, std::to_string(limit >> 20)});
}

}  // namespace

Packing packingOf(std::string_view start) {
    if (start.starts_with("\x1F\x8B\x08")) return Packing::Gzip;
    if (start.starts_with(std::string_view("\xFD"
                                           "7zXZ\0",
                                           6)))
        return Packing::Xz;
    return Packing::None;
}

const std::vector<std::string>& packedExtensions() {
    static const std::vector<std::string> kExtensions{"gz", "xz"};
    return kExtensions;
}

std::filesystem::path withoutPacking(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension.empty() || std::ranges::find(packedExtensions(), extension.substr(1)) == packedExtensions().end()) return path;
    return path.parent_path() / path.stem();
}

size_t readBlock(int file, const std::string& name, uint64_t position, char* to, size_t most) {
    ssize_t got = 0;
    do {
        got = read(file, to, most);
    } while (got < 0 && errno == EINTR);
    if (got < 0)
        throwInput(CULLSCOPE_TR("%1 cannot be read after byte %2: %3. Copy the file again."),
                   {name, std::to_string(position), systemReason(errno)});
    return static_cast<size_t>(got);
}

Unpacker::Unpacker(int file, std::string name, Packing packing, uint64_t memoryLimit, const Progress& progress)
    : m_file(file),
      m_name(std::move(name)),
      m_progress(progress),
      m_packed(kPackedBlock),
      m_decoder(decoderFor(packing, memoryLimit)) {}

Unpacker::~Unpacker() = default;

void Unpacker::refill() {
    m_progress.check();
    const size_t got = readBlock(m_file, m_name, m_fetched, m_packed.data(), m_packed.size());
    m_atEnd = got == 0;
    m_fetched += got;
    m_left = std::span<const char>(m_packed).first(got);
}

size_t Unpacker::read(char* to, size_t most) {
    std::span<char> content(to, most);
    while (!m_finished && content.size() == most && most > 0) {
        if (m_left.empty() && !m_atEnd) refill();
        switch (m_decoder->decode(m_left, content, m_atEnd)) {
            case Decoder::Result::Going:
                break;
            case Decoder::Result::Finished:
                m_finished = true;
                break;
            case Decoder::Result::Damaged:
                throwInput(CULLSCOPE_TR("%1, byte %2: the compressed data are damaged. Fetch the file again."),
                           {m_name, std::to_string(packedBytes())});
            case Decoder::Result::CutOff:
                throwInput(CULLSCOPE_TR("%1 ends at byte %2, within its compressed data. The file was cut off: fetch it again."),
                           {m_name, std::to_string(packedBytes())});
            case Decoder::Result::TooMuchMemory:
                throwInput(CULLSCOPE_TR("%1, byte %2: unpacking the file takes more memory than may be used on this machine. "
                                        "Compress it anew by a lower level, such as xz -6."),
                           {m_name, std::to_string(packedBytes())});
        }
    }
    return most - content.size();
}

uint64_t unpackedSize(int file, const std::string& name, Packing packing, uint64_t packedSize, uint64_t limit,
                      const Progress& progress) {
    Unpacker unpacker(file, name, packing, limit, progress);
    std::vector<char> block(size_t{256} << 10);
    uint64_t size = 0;
    while (const size_t got = unpacker.read(block.data(), block.size())) {
        size += got;
        if (size > limit) refuseTooLarge(name, limit);
        progress.check();
        progress.tell(std::min(1.0, double(unpacker.packedBytes()) / double(packedSize)), CULLSCOPE_TR("Unpacking the file"));
    }
    return size;
}

}  // namespace cullscope
