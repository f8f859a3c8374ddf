#include "core/image/picture_file.h"

#include <OpenImageIO/imageio.h>

#include <cassert>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/picture_file_memory.h"
#include "core/image/picture_pixels.h"
#include "core/scene/camera.h"

namespace cullscope {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDepthChannel = "depth.Z";
constexpr const char* kTriangleChannel = "triangle.ID";

enum class Format { Png, Jpeg, Tiff, Exr };

std::string lowerCaseExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

Format formatOf(const std::filesystem::path& path) {
    const std::string extension = lowerCaseExtension(path);
    if (path == "-" || extension == ".png") return Format::Png;
    if (extension == ".jpg" || extension == ".jpeg") return Format::Jpeg;
    if (extension == ".tif" || extension == ".tiff") return Format::Tiff;
    if (extension == ".exr") return Format::Exr;
    throwUsage(CULLSCOPE_TR("%1: pictures are written as .png, .jpg, .tif or .exr; choose one of these endings."),
               {path.string()});
}

/// The metadata of JPEG and TIFF, which drop names that they do not know: all pairs as one text under a name that they keep.
std::string described(const std::filesystem::path& path, const Picture& picture) {
    Json json = Json::object();
    for (const auto& [name, text] : picture.metadata) json[name] = text;
    std::string description = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (description.size() > kMostDescriptionBytes)
        throwUsage(
            CULLSCOPE_TR("%1: what the picture shows takes %2 bytes to describe, and this format holds %3. Write a .png or "
                         ".exr file."),
            {path.string(), std::to_string(description.size()), std::to_string(kMostDescriptionBytes)});
    return description;
}

OIIO::ImageSpec specificationOf(const std::filesystem::path& path, const Picture& picture, Format format) {
    OIIO::ImageSpec spec(picture.size.width, picture.size.height, format == Format::Jpeg ? 3 : 4, OIIO::TypeDesc::UINT8);
    spec.attribute("Software", "Cullscope " CULLSCOPE_VERSION);
    // EXR readers expect linear colours. (TIFF needs the attribute too: without it, OpenImageIO writes a broken EXIF part.)
    spec.attribute("oiio:ColorSpace", format == Format::Exr ? "Linear" : "sRGB");
    if (format == Format::Png || format == Format::Tiff) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == Format::Jpeg) {
        spec.attribute("Compression", "jpeg:95");
        // Chroma subsampling would smear thin coloured lines into their neighbourhood.
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (picture.dotsPerInch > 0.0) {
        spec.attribute("XResolution", static_cast<float>(picture.dotsPerInch));
        spec.attribute("YResolution", static_cast<float>(picture.dotsPerInch));
        spec.attribute("ResolutionUnit", "in");
    }
    if (format == Format::Jpeg || format == Format::Tiff)
        spec.attribute("ImageDescription", described(path, picture));
    else
        for (const auto& [name, text] : picture.metadata) spec.attribute(name, text);
    return spec;
}

/// The pixels of an EXR: four half floats of colour, then depth and triangle if the picture has them, packed.
std::vector<std::byte> exrPixels(const Picture& picture, OIIO::ImageSpec& spec) {
    spec.format = OIIO::TypeDesc::HALF;
    spec.channelnames = {"R", "G", "B", "A"};
    spec.channelformats.assign(4, OIIO::TypeDesc::HALF);
    size_t stride = 4 * sizeof(uint16_t);
    const auto addChannel = [&](const char* name, OIIO::TypeDesc type) {
        spec.channelnames.emplace_back(name);
        spec.channelformats.push_back(type);
        stride += sizeof(uint32_t);
    };
    if (!picture.depth.empty()) addChannel(kDepthChannel, OIIO::TypeDesc::FLOAT);
    if (!picture.triangle.empty()) addChannel(kTriangleChannel, OIIO::TypeDesc::UINT32);
    spec.nchannels = static_cast<int>(spec.channelnames.size());

    const size_t count = picture.rgba.size() / 4;
    const std::vector<float> colours = linearPremultiplied(picture.rgba);
    std::vector<uint16_t> halves(colours.size());
    OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, colours.data(), OIIO::TypeDesc::HALF, halves.data(),
                               static_cast<int>(colours.size()));
    std::vector<std::byte> packed(count * stride);
    for (size_t pixel = 0; pixel < count; ++pixel) {
        std::byte* place = packed.data() + pixel * stride;
        place = std::copy_n(reinterpret_cast<const std::byte*>(&halves[4 * pixel]), 4 * sizeof(uint16_t), place);
        if (!picture.depth.empty())
            place = std::copy_n(reinterpret_cast<const std::byte*>(&picture.depth[pixel]), sizeof(float), place);
        if (!picture.triangle.empty())
            std::copy_n(reinterpret_cast<const std::byte*>(&picture.triangle[pixel]), sizeof(uint32_t), place);
    }
    return packed;
}

/// The picture encoded in the format of the file name's extension.
std::vector<unsigned char> encoded(const std::filesystem::path& path, const Picture& picture, const Vec3f& background) {
    constexpr std::array kNames{"picture.png", "picture.jpg", "picture.tif", "picture.exr"};
    const Format format = formatOf(path);
    OIIO::ImageSpec spec = specificationOf(path, picture, format);
    std::vector<std::byte> exr;
    std::vector<uint8_t> bytes;
    if (format == Format::Exr)
        exr = exrPixels(picture, spec);
    else
        bytes = format == Format::Jpeg ? flattened(picture.rgba, background) : picture.rgba;
    const auto output = OIIO::ImageOutput::create(kNames[static_cast<size_t>(format)]);
    if (!output) throwUsage(CULLSCOPE_TR("%1 cannot be written: %2"), {path.string(), firstLine(OIIO::geterror())});
    const auto write = [&] {
        return format == Format::Exr ? output->write_image(OIIO::TypeDesc::UNKNOWN, upsideDown(exr, picture.size.height).data())
                                     : output->write_image(OIIO::TypeDesc::UINT8, upsideDown(bytes, picture.size.height).data());
    };
    return encodedInMemory(*output, spec, write, path);
}

}  // namespace

void requirePictureFormat(const std::filesystem::path& path) { (void)formatOf(path); }

void writePicture(const std::filesystem::path& path, const Picture& picture, const Vec3f& background) {
    [[maybe_unused]] const size_t pixels = static_cast<size_t>(picture.size.width) * static_cast<size_t>(picture.size.height);
    assert(picture.rgba.size() == 4 * pixels);
    assert(picture.depth.empty() || picture.depth.size() == pixels);
    assert(picture.triangle.empty() || picture.triangle.size() == pixels);
    const std::vector<unsigned char> bytes = encoded(path, picture, background);
    writeFileAtomically(path, [&](std::ostream& out) {
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    });
}

namespace {

[[noreturn]] void refuseToRead(const std::filesystem::path& path, const std::string& reason) {
    throwInput(CULLSCOPE_TR("%1 is no picture that can be read: %2"), {path.string(), firstLine(reason)});
}

std::vector<int> colourChannels(const OIIO::ImageSpec& spec) {
    const int red = spec.channelindex("R");
    const int green = spec.channelindex("G");
    const int blue = spec.channelindex("B");
    if (red >= 0 && green >= 0 && blue >= 0) return {red, green, blue};
    return spec.nchannels < 3 ? std::vector{0, 0, 0} : std::vector{0, 1, 2};
}

/// Channels [first, last], converted to `type`, interleaved by pixel, rows from the bottom.
template <typename Value>
std::vector<Value> readChannels(OIIO::ImageInput& input, int first, int last, OIIO::TypeDesc type,
                                const std::filesystem::path& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto count = static_cast<size_t>(last + 1 - first);
    std::vector<Value> values(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) * count);
    if (!input.read_image(0, 0, first, last + 1, type, values.data())) refuseToRead(path, input.geterror());
    return upsideDown(values, spec.height);
}

template <typename Value>
std::vector<Value> readColours(OIIO::ImageInput& input, OIIO::TypeDesc type, Value opaque, const std::filesystem::path& path) {
    std::vector<int> channels = colourChannels(input.spec());
    const int alpha = input.spec().alpha_channel;
    if (alpha >= 0) channels.push_back(alpha);
    // All of them in one read, from the first to the last: many formats decode all channels at each read.
    const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
    const std::vector<Value> read = readChannels<Value>(input, *first, *last, type, path);
    const auto stride = static_cast<size_t>(*last + 1 - *first);
    std::vector<Value> colours(read.size() / stride * 4, opaque);
    for (size_t pixel = 0; pixel < colours.size() / 4; ++pixel)
        for (size_t c = 0; c < channels.size(); ++c)
            colours[4 * pixel + c] = read[stride * pixel + static_cast<size_t>(channels[c] - *first)];
    return colours;
}

void readMetadata(const OIIO::ImageSpec& spec, Picture& picture) {
    const auto ours = [](const std::string& name) { return name.starts_with("cullscope:"); };
    for (const auto& attribute : spec.extra_attribs)
        if (ours(attribute.name().string())) picture.metadata.emplace_back(attribute.name().string(), attribute.get_string());
    const Json json = Json::parse(std::string(spec.get_string_attribute("ImageDescription")), nullptr, false);
    if (json.is_object())
        for (const auto& [name, text] : json.items())
            if (ours(name) && text.is_string()) picture.metadata.emplace_back(name, text.get<std::string>());
    const bool centimetres = spec.get_string_attribute("ResolutionUnit") == "cm";
    picture.dotsPerInch = static_cast<double>(spec.get_float_attribute("XResolution")) * (centimetres ? 2.54 : 1.0);
}

}  // namespace

Picture readPicture(const std::filesystem::path& path) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &wishes);
    if (!input) refuseToRead(path, OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kMostPixels || spec.height > kMostPixels || spec.depth > 1 || spec.deep)
        throwInput(CULLSCOPE_TR("%1 is %2x%3 pixels large or no flat picture: pictures of 1 to 16384 pixels a side are read."),
                   {path.string(), std::to_string(spec.width), std::to_string(spec.height)});
    Picture picture;
    picture.size = {spec.width, spec.height};
    // Straight alpha is read without rounding loss; files of floats are linear and multiplied by alpha, and are converted.
    if (spec.format.is_floating_point())
        picture.rgba = straightFromLinear(readColours<float>(*input, OIIO::TypeDesc::FLOAT, 1.0F, path));
    else
        picture.rgba = readColours<uint8_t>(*input, OIIO::TypeDesc::UINT8, 255, path);
    if (const int channel = spec.channelindex(kDepthChannel); channel >= 0)
        picture.depth = readChannels<float>(*input, channel, channel, OIIO::TypeDesc::FLOAT, path);
    if (const int channel = spec.channelindex(kTriangleChannel); channel >= 0)
        picture.triangle = readChannels<uint32_t>(*input, channel, channel, OIIO::TypeDesc::UINT32, path);
    readMetadata(spec, picture);
    return picture;
}

std::vector<float> forwardDistances(const std::vector<float>& reversedDepth, const View& view) {
    std::vector<float> distances(reversedDepth.size());
    for (size_t pixel = 0; pixel < distances.size(); ++pixel)
        distances[pixel] = reversedDepth[pixel] > 0.0F ? static_cast<float>(view.distanceFromDepth(double{reversedDepth[pixel]}))
                                                       : std::numeric_limits<float>::infinity();
    return distances;
}

bool keepsDepth(const std::filesystem::path& path) { return path != "-" && lowerCaseExtension(path) == ".exr"; }

bool keepsAlpha(const std::filesystem::path& path) {
    const std::string extension = lowerCaseExtension(path);
    return path == "-" || (extension != ".jpg" && extension != ".jpeg");
}

}  // namespace cullscope
