#include "core/image/formats/encoded_in_memory.h"

#include <OpenImageIO/filesystem.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>

#include "core/image/formats/picture_formats.h"

namespace cullscope {
namespace {

using Kind = PictureFormatFailure::Kind;

/// The target that OpenImageIO writes to in place of a file.
class MemoryProxy final : public OIIO::Filesystem::IOVecOutput {
public:
    size_t pwrite(const void* bytes, size_t size, int64_t offset) override {
        // C code calls this: no exception may pass through it.
        try {
            if (!m_full) return IOVecOutput::pwrite(bytes, size, offset);
        } catch (const std::bad_alloc&) {
            m_full = true;
        }
        return 0;
    }
    [[nodiscard]] bool full() const { return m_full; }

private:
    bool m_full = false;
};

/// A file in memory with a path, whose size the system may limit.
class NamedMemory {
public:
    NamedMemory() : m_descriptor(memfd_create("picture", MFD_CLOEXEC)) {
        if (m_descriptor < 0) throw PictureFormatFailure{Kind::System, {}, errno};
    }
    ~NamedMemory() { close(m_descriptor); }
    NamedMemory(const NamedMemory&) = delete;
    NamedMemory& operator=(const NamedMemory&) = delete;

    [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }
    /// The reason why it cannot grow: an `errno`; 0 where it can.
    [[nodiscard]] int refusal() const {
        constexpr off_t kMore = 1 << 20;
        return posix_fallocate(m_descriptor, size(), kMore);
    }
    [[nodiscard]] std::vector<unsigned char> contents() const {
        std::vector<unsigned char> bytes(static_cast<size_t>(size()));
        for (size_t done = 0; done < bytes.size();) {
            const ssize_t count = pread(m_descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
            if (count <= 0) throw PictureFormatFailure{Kind::System, {}, count < 0 ? errno : EIO};
            done += static_cast<size_t>(count);
        }
        return bytes;
    }

private:
    [[nodiscard]] off_t size() const {
        struct stat status {};
        return fstat(m_descriptor, &status) == 0 ? status.st_size : 0;
    }

    int m_descriptor;
};

[[noreturn]] void refuseForLibrary(const OIIO::ImageOutput& output) {
    throw PictureFormatFailure{Kind::Library, firstLine(output.geterror())};
}

bool written(OIIO::ImageOutput& output, const std::string& name, const OIIO::ImageSpec& spec,
             const std::function<bool()>& writePixels) {
    return output.open(name, spec) && writePixels() && output.close() && !output.has_error();
}

/// Whether a file has all rows and the expected description. The TIFF library does not report every failed write.
bool wholeFile(const std::string& name, const OIIO::ImageSpec& spec) {
    const auto input = OIIO::ImageInput::open(name);
    if (!input || input->spec().get_string_attribute("ImageDescription") != spec.get_string_attribute("ImageDescription")) {
        (void)OIIO::geterror();
        return false;
    }
    constexpr int kRows = 64;
    std::vector<unsigned char> rows(static_cast<size_t>(kRows) * spec.scanline_bytes());
    for (int y = 0; y < spec.height; y += kRows)
        if (!input->read_scanlines(0, 0, y, std::min(y + kRows, spec.height), 0, 0, spec.nchannels, spec.format, rows.data())) {
            (void)input->geterror();
            return false;
        }
    return true;
}

/// Encodes into a named file: the TIFF library reads back what it has written, which OpenImageIO supports for named files only.
std::vector<unsigned char> encodedByName(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                         const std::function<bool()>& writePixels) {
    const NamedMemory file;
    if (written(output, file.name(), spec, writePixels) && wholeFile(file.name(), spec)) return file.contents();
    if (const int reason = file.refusal(); reason != 0) throw PictureFormatFailure{Kind::NoSpace, {}, reason};
    refuseForLibrary(output);
}

std::vector<unsigned char> encodedByProxy(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                          const std::function<bool()>& writePixels) {
    MemoryProxy file;
    output.set_ioproxy(&file);
    const bool done = written(output, "picture", spec, writePixels);
    if (file.full()) throw PictureFormatFailure{Kind::NoMemory};
    if (!done) refuseForLibrary(output);
    return std::move(file.buffer());
}

}  // namespace

std::string firstLine(const std::string& text) { return text.substr(0, text.find_first_of("\r\n")); }

std::vector<unsigned char> encodedInMemory(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                           const std::function<bool()>& writePixels) {
    const bool tiff = std::string_view(output.format_name()) == "tiff";
    return (tiff ? encodedByName : encodedByProxy)(output, spec, writePixels);
}

}  // namespace cullscope
