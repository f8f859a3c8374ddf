#include "core/measure/picture_file.h"

#include <OpenImageIO/imageio.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope {
namespace {

/// Files hold rows from the top; this flips either way.
std::vector<uint8_t> upsideDown(const std::vector<uint8_t>& rows, const Viewport& size) {
    const size_t stride = static_cast<size_t>(size.width) * 4;
    std::vector<uint8_t> flipped(rows.size());
    for (size_t y = 0; y < static_cast<size_t>(size.height); ++y)
        std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(y * stride), stride,
                    flipped.end() - static_cast<std::ptrdiff_t>((y + 1) * stride));
    return flipped;
}

/// A file in memory: picture libraries want a name to write to, and some end the program where a disk is full.
class MemoryFile {
public:
    MemoryFile() : m_descriptor(memfd_create("picture", MFD_CLOEXEC)) {
        if (m_descriptor < 0) throwUsage(CULLSCOPE_TR("The picture cannot be made: %1."), {systemReason(errno)});
    }
    ~MemoryFile() { close(m_descriptor); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

private:
    int m_descriptor;
};

[[noreturn]] void refuseFormat(const std::filesystem::path& path) {
    throwUsage(CULLSCOPE_TR("%1: pictures are written as .png, .jpg, .tif or .exr; choose one of these endings."),
               {path.string()});
}

/// The picture as a file of the format that a name ends in.
void encode(const MemoryFile& file, const std::filesystem::path& path, const Picture& picture) {
    const std::string format = path == "-" ? "png" : path.extension().string();
    const auto output =
        format.empty() ? nullptr : OIIO::ImageOutput::create("picture" + (format[0] == '.' ? format : "." + format));
    if (!output) {
        (void)OIIO::geterror();
        refuseFormat(path);
    }
    const std::vector<uint8_t> rows = upsideDown(picture.rgba, picture.size);
    OIIO::ImageSpec spec(picture.size.width, picture.size.height, 4, OIIO::TypeDesc::UINT8);
    for (const auto& [name, text] : picture.metadata) spec.attribute(name, text);
    const bool written =
        output->open(file.name(), spec) && output->write_image(OIIO::TypeDesc::UINT8, rows.data()) && output->close();
    if (!written) throwUsage(CULLSCOPE_TR("%1 cannot be written: %2"), {path.string(), output->geterror()});
}

}  // namespace

void writePicture(const std::filesystem::path& path, const Picture& picture) {
    const MemoryFile file;
    encode(file, path, picture);
    std::ifstream encoded(file.name(), std::ios::binary);
    writeFileAtomically(path, [&](std::ostream& out) { out << encoded.rdbuf(); });
}

Picture readPicture(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) throwInput(CULLSCOPE_TR("%1 is no picture that can be read: %2"), {path.string(), OIIO::geterror()});
    const OIIO::ImageSpec& spec = input->spec();
    Picture picture;
    picture.size = {spec.width, spec.height};
    std::vector<uint8_t> channels(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                                  static_cast<size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, channels.data()))
        throwInput(CULLSCOPE_TR("%1 is no picture that can be read: %2"), {path.string(), input->geterror()});
    picture.rgba.resize(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) * 4);
    for (size_t pixel = 0; pixel < picture.rgba.size() / 4; ++pixel)
        for (size_t c = 0; c < 4; ++c) {
            const auto available = static_cast<size_t>(spec.nchannels);
            const size_t source = available < 3 && c < 3 ? 0 : c;
            picture.rgba[pixel * 4 + c] = source < available ? channels[pixel * available + source] : 255;
        }
    picture.rgba = upsideDown(picture.rgba, picture.size);
    for (const auto& attribute : spec.extra_attribs)
        if (attribute.name().find("cullscope") != std::string::npos)
            picture.metadata.emplace_back(attribute.name().string(), attribute.get_string());
    return picture;
}

}  // namespace cullscope
