#include "core/image/formats/picture_formats.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>

#include "core/image/formats/encoded_in_memory.h"

namespace cullscope {
namespace {

constexpr const char* kDepthChannel = "depth.Z";
constexpr const char* kTriangleChannel = "triangle.ID";

OIIO::ImageSpec specificationOf(PictureFormat format, const PictureFileContent& content) {
    OIIO::ImageSpec spec(content.width, content.height, format == PictureFormat::Jpeg ? 3 : 4, OIIO::TypeDesc::UINT8);
    spec.attribute("Software", "Cullscope " CULLSCOPE_VERSION);
    // EXR readers expect linear colours. (TIFF needs the attribute too: without it, OpenImageIO writes a broken EXIF part.)
    spec.attribute("oiio:ColorSpace", format == PictureFormat::Exr ? "Linear" : "sRGB");
    if (format == PictureFormat::Png || format == PictureFormat::Tiff) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == PictureFormat::Jpeg) {
        spec.attribute("Compression", "jpeg:95");
        // Chroma subsampling would smear thin coloured lines into their neighbourhood.
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (content.dotsPerInch > 0.0) {
        spec.attribute("XResolution", static_cast<float>(content.dotsPerInch));
        spec.attribute("YResolution", static_cast<float>(content.dotsPerInch));
        spec.attribute("ResolutionUnit", "in");
    }
    if (!content.description.empty()) spec.attribute("ImageDescription", content.description);
    for (const auto& [name, text] : content.texts) spec.attribute(name, text);
    return spec;
}

/// The pixels of an EXR: four half floats of colour, then depth and triangle if the picture has them, packed.
std::vector<std::byte> exrPixels(const PictureFileContent& content, OIIO::ImageSpec& spec) {
    spec.format = OIIO::TypeDesc::HALF;
    spec.channelnames = {"R", "G", "B", "A"};
    spec.channelformats.assign(4, OIIO::TypeDesc::HALF);
    size_t stride = 4 * sizeof(uint16_t);
    const auto addChannel = [&](const char* name, OIIO::TypeDesc type) {
        spec.channelnames.emplace_back(name);
        spec.channelformats.push_back(type);
        stride += sizeof(uint32_t);
    };
    if (!content.depth.empty()) addChannel(kDepthChannel, OIIO::TypeDesc::FLOAT);
    if (!content.triangle.empty()) addChannel(kTriangleChannel, OIIO::TypeDesc::UINT32);
    spec.nchannels = static_cast<int>(spec.channelnames.size());

    const size_t count = content.linear.size() / 4;
    std::vector<uint16_t> halves(content.linear.size());
    OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, content.linear.data(), OIIO::TypeDesc::HALF, halves.data(),
                               static_cast<int>(halves.size()));
    std::vector<std::byte> packed(count * stride);
    for (size_t pixel = 0; pixel < count; ++pixel) {
        std::byte* place = packed.data() + pixel * stride;
        place = std::copy_n(reinterpret_cast<const std::byte*>(&halves[4 * pixel]), 4 * sizeof(uint16_t), place);
        if (!content.depth.empty())
            place = std::copy_n(reinterpret_cast<const std::byte*>(&content.depth[pixel]), sizeof(float), place);
        if (!content.triangle.empty())
            std::copy_n(reinterpret_cast<const std::byte*>(&content.triangle[pixel]), sizeof(uint32_t), place);
    }
    return packed;
}

[[noreturn]] void refuse(const std::string& reason) {
    throw PictureFormatFailure{PictureFormatFailure::Kind::Library, firstLine(reason)};
}

std::vector<int> colourChannels(const OIIO::ImageSpec& spec) {
    const int red = spec.channelindex("R");
    const int green = spec.channelindex("G");
    const int blue = spec.channelindex("B");
    if (red >= 0 && green >= 0 && blue >= 0) return {red, green, blue};
    return spec.nchannels < 3 ? std::vector{0, 0, 0} : std::vector{0, 1, 2};
}

/// Channels [first, last], converted to `type`, interleaved by pixel, rows from the top.
template <typename Value>
std::vector<Value> readChannels(OIIO::ImageInput& input, int first, int last, OIIO::TypeDesc type) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto count = static_cast<size_t>(last + 1 - first);
    std::vector<Value> values(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) * count);
    if (!input.read_image(0, 0, first, last + 1, type, values.data())) refuse(input.geterror());
    return values;
}

template <typename Value>
std::vector<Value> readColours(OIIO::ImageInput& input, OIIO::TypeDesc type, Value opaque) {
    std::vector<int> channels = colourChannels(input.spec());
    const int alpha = input.spec().alpha_channel;
    if (alpha >= 0) channels.push_back(alpha);
    // All of them in one read, from the first to the last: many formats decode all channels at each read.
    const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
    const std::vector<Value> read = readChannels<Value>(input, *first, *last, type);
    const auto stride = static_cast<size_t>(*last + 1 - *first);
    std::vector<Value> colours(read.size() / stride * 4, opaque);
    for (size_t pixel = 0; pixel < colours.size() / 4; ++pixel)
        for (size_t c = 0; c < channels.size(); ++c)
            colours[4 * pixel + c] = read[stride * pixel + static_cast<size_t>(channels[c] - *first)];
    return colours;
}

void readPixels(OIIO::ImageInput& input, PictureFileContent& content) {
    // Straight alpha is read without rounding loss; files of floats are linear and multiplied by alpha.
    if (input.spec().format.is_floating_point())
        content.linear = readColours<float>(input, OIIO::TypeDesc::FLOAT, 1.0F);
    else
        content.bytes = readColours<uint8_t>(input, OIIO::TypeDesc::UINT8, 255);
    if (const int channel = input.spec().channelindex(kDepthChannel); channel >= 0)
        content.depth = readChannels<float>(input, channel, channel, OIIO::TypeDesc::FLOAT);
    if (const int channel = input.spec().channelindex(kTriangleChannel); channel >= 0)
        content.triangle = readChannels<uint32_t>(input, channel, channel, OIIO::TypeDesc::UINT32);
}

/// The ending without its dot, by which OpenImageIO chooses the format. Given the name of a file it would open that file to
/// choose.
const char* endingOf(PictureFormat format) {
    constexpr std::array kEndings{"png", "jpg", "tif", "exr"};
    return kEndings[static_cast<size_t>(format)];
}

class OpenImageIoFormats final : public PictureFormats {
public:
    [[nodiscard]] std::vector<unsigned char> encoded(PictureFormat format, const PictureFileContent& content) const override {
        OIIO::ImageSpec spec = specificationOf(format, content);
        std::vector<std::byte> exr;
        if (format == PictureFormat::Exr) exr = exrPixels(content, spec);
        const auto output = OIIO::ImageOutput::create(endingOf(format));
        if (!output) refuse(OIIO::geterror());
        return encodedInMemory(*output, spec, [&] {
            return format == PictureFormat::Exr ? output->write_image(OIIO::TypeDesc::UNKNOWN, exr.data())
                                                : output->write_image(OIIO::TypeDesc::UINT8, content.bytes.data());
        });
    }

    [[nodiscard]] PictureFileContent read(PictureFormat format, const std::string& path, std::string_view prefix, int mostPixels,
                                          Part part) const override {
        // Not by ImageInput::open(), which tries all of the library's readers in turn until one of them takes the file.
        const auto input = OIIO::ImageInput::create(endingOf(format));
        if (!input) refuse(OIIO::geterror());
        OIIO::ImageSpec wishes, spec;
        wishes.attribute("oiio:UnassociatedAlpha", 1);
        if (!input->open(path, spec, wishes)) refuse(input->geterror());
        if (spec.width < 1 || spec.height < 1 || spec.width > mostPixels || spec.height > mostPixels || spec.depth > 1 ||
            spec.deep)
            throw PictureFormatFailure{PictureFormatFailure::Kind::Size, {}, 0, spec.width, spec.height};
        PictureFileContent content;
        content.width = spec.width;
        content.height = spec.height;
        if (part == Part::All) readPixels(*input, content);
        for (const auto& attribute : spec.extra_attribs)
            if (const std::string name = attribute.name().string(); name.starts_with(prefix))
                content.texts.emplace_back(name, attribute.get_string());
        content.description = spec.get_string_attribute("ImageDescription");
        const bool centimetres = spec.get_string_attribute("ResolutionUnit") == "cm";
        content.dotsPerInch = static_cast<double>(spec.get_float_attribute("XResolution")) * (centimetres ? 2.54 : 1.0);
        return content;
    }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const PictureFormats* cullscopePictureFormats() {
    static const OpenImageIoFormats kFormats;
    return &kFormats;
}

}  // namespace cullscope
