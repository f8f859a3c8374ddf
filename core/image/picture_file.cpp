#include "core/image/picture_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>
#include <optional>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/image/jpeg_scans.h"
#include "core/image/picture_formats_module.h"
#include "core/image/picture_pixels.h"
#include "core/image/stated_lengths.h"
#include "core/scene/camera.h"

namespace cullscope {
namespace {

constexpr std::string_view kOurPrefix = "cullscope:";

std::string lowerCaseExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The format that a file's name says; none where it ends in another way.
std::optional<PictureFormat> formatByName(const std::filesystem::path& path) {
    const std::string extension = lowerCaseExtension(path);
    if (extension == ".png") return PictureFormat::Png;
    if (extension == ".jpg" || extension == ".jpeg") return PictureFormat::Jpeg;
    if (extension == ".tif" || extension == ".tiff") return PictureFormat::Tiff;
    if (extension == ".exr") return PictureFormat::Exr;
    return std::nullopt;
}

PictureFormat formatToWrite(const std::filesystem::path& path) {
    if (path == "-") return PictureFormat::Png;
    if (const auto format = formatByName(path)) return *format;
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

[[noreturn]] void refuseToWrite(const std::filesystem::path& path, const PictureFormatFailure& failure) {
    switch (failure.kind) {
        case PictureFormatFailure::Kind::System:
            throwUsage(CULLSCOPE_TR("The picture cannot be made: %1."), {systemReason(failure.code)});
        case PictureFormatFailure::Kind::NoSpace:
            throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. Choose another place or free some space."),
                       {path.string(), systemReason(failure.code)});
        case PictureFormatFailure::Kind::NoMemory:
            throwUsage(CULLSCOPE_TR("There is no memory for this picture: choose a smaller size."), {});
        case PictureFormatFailure::Kind::Library:
        case PictureFormatFailure::Kind::Size:
            break;
    }
    throwUsage(CULLSCOPE_TR("%1 cannot be written: %2"), {path.string(), failure.reason});
}

/// The picture encoded in the format of the file name's extension.
std::vector<unsigned char> encoded(const std::filesystem::path& path, const Picture& picture, const Vec3f& background) {
    const PictureFormat format = formatToWrite(path);
    const int height = picture.size.height;
    PictureFileContent content;
    content.width = picture.size.width;
    content.height = height;
    content.dotsPerInch = picture.dotsPerInch;
    if (format == PictureFormat::Jpeg || format == PictureFormat::Tiff)
        content.description = described(path, picture);
    else
        content.texts = picture.metadata;
    if (format == PictureFormat::Exr) {
        content.linear = upsideDown(linearPremultiplied(picture.rgba), height);
        if (!picture.depth.empty()) content.depth = upsideDown(picture.depth, height);
        if (!picture.triangle.empty()) content.triangle = upsideDown(picture.triangle, height);
    } else {
        content.bytes = upsideDown(format == PictureFormat::Jpeg ? flattened(picture.rgba, background) : picture.rgba, height);
    }
    try {
        return pictureFormats().encoded(format, content);
    } catch (const PictureFormatFailure& failure) {
        refuseToWrite(path, failure);
    }
}

}  // namespace

void requirePictureFormat(const std::filesystem::path& path) { (void)formatToWrite(path); }

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

[[noreturn]] void refuseToRead(const std::filesystem::path& path, const PictureFormatFailure& failure) {
    if (failure.kind == PictureFormatFailure::Kind::Size)
        throwInput(CULLSCOPE_TR("%1 is %2x%3 pixels large or no flat picture: pictures of 1 to 16384 pixels a side are read."),
                   {path.string(), std::to_string(failure.width), std::to_string(failure.height)});
    throwInput(CULLSCOPE_TR("%1 is no picture that can be read: %2"), {path.string(), failure.reason});
}

/// Whether a file begins as its format says: PNG and JPEG by their signatures, TIFF in both byte orders and sizes of its offsets,
/// EXR by its number.
bool beginsAs(PictureFormat format, std::string_view bytes) {
    using namespace std::string_view_literals;
    const auto begins = [&](std::initializer_list<std::string_view> signatures) {
        return std::any_of(signatures.begin(), signatures.end(), [&](std::string_view each) { return bytes.starts_with(each); });
    };
    switch (format) {
        case PictureFormat::Png:
            return begins({"\x89PNG\r\n\x1a\n"sv});
        case PictureFormat::Jpeg:
            return begins({"\xff\xd8\xff"sv});
        case PictureFormat::Tiff:
            return begins({"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv});
        case PictureFormat::Exr:
            return begins({"\x76\x2f\x31\x01"sv});
    }
    return false;
}

/// Nothing that Cullscope writes has several scans; of other programs' files the usual sizes are read.
void refuseLargeScans(const std::filesystem::path& path) {
    constexpr int64_t kMostPixelsKeptWhole = int64_t{1} << 24;
    const std::optional<Viewport> size = sizeKeptWhole(path);
    if (size && int64_t{size->width} * size->height > kMostPixelsKeptWhole)
        throwInput(
            CULLSCOPE_TR("%1 is no picture that can be read: a progressive JPEG of %2x%3 pixels takes memory for all of them "
                         "before the first is known. Save it without progressive coding."),
            {path.string(), std::to_string(size->width), std::to_string(size->height)});
}

/// The format of a file, by its name and its first bytes, which must agree: the reader of another format must not see it.
PictureFormat formatToRead(const std::filesystem::path& path) {
    constexpr std::array kNames{"PNG", "JPEG", "TIFF", "EXR"};
    std::ifstream in(path, std::ios::binary);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {path.string()});
    const std::optional<PictureFormat> format = formatByName(path);
    if (!format)
        throwInput(CULLSCOPE_TR("%1 is no picture that can be read: its name ends neither in .png, .jpg, .tif nor .exr."),
                   {path.string()});
    std::array<char, 8> first{};
    in.read(first.data(), first.size());
    if (!beginsAs(*format, {first.data(), static_cast<size_t>(in.gcount())}))
        throwInput(CULLSCOPE_TR("%1 is no picture that can be read: its name says %2, and it does not begin as such a file does. "
                                "Give it the ending of what it is."),
                   {path.string(), kNames[static_cast<size_t>(*format)]});
    if (*format == PictureFormat::Jpeg) refuseLargeScans(path);
    if (statesWrongLength(*format, path))
        refuseToRead(path, {PictureFormatFailure::Kind::Library, "it states a length that what follows has not."});
    return *format;
}

PictureFileContent contentOf(const std::filesystem::path& path, PictureFormats::Part part) {
    const PictureFormat format = formatToRead(path);
    try {
        return pictureFormats().read(format, path.string(), kOurPrefix, kMostPixels, part);
    } catch (const PictureFormatFailure& failure) {
        refuseToRead(path, failure);
    }
}

/// The texts under their own names, and those of the description of a JPEG or TIFF.
std::vector<std::pair<std::string, std::string>> metadataOf(PictureFileContent& content) {
    std::vector<std::pair<std::string, std::string>> metadata = std::move(content.texts);
    const Json json = Json::parse(content.description, nullptr, false);
    if (json.is_object())
        for (const auto& [name, text] : json.items())
            if (name.starts_with(kOurPrefix) && text.is_string()) metadata.emplace_back(name, text.get<std::string>());
    return metadata;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> readPictureMetadata(const std::filesystem::path& path) {
    PictureFileContent content = contentOf(path, PictureFormats::Part::Header);
    return metadataOf(content);
}

Picture readPicture(const std::filesystem::path& path) {
    PictureFileContent content = contentOf(path, PictureFormats::Part::All);
    const auto fromTheBottom = [&](const auto& rows) { return upsideDown(rows, content.height); };
    Picture picture;
    picture.size = {content.width, content.height};
    picture.rgba = fromTheBottom(content.bytes.empty() ? straightFromLinear(content.linear) : content.bytes);
    if (!content.depth.empty()) picture.depth = fromTheBottom(content.depth);
    if (!content.triangle.empty()) picture.triangle = fromTheBottom(content.triangle);
    picture.dotsPerInch = content.dotsPerInch;
    picture.metadata = metadataOf(content);
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
