#include "core/image/picture_file.h"

#include <cassert>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/picture_formats_module.h"
#include "core/image/picture_pixels.h"
#include "core/scene/camera.h"

namespace cullscope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kOurPrefix = "cullscope:";

std::string lowerCaseExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

PictureFormat formatOf(const std::filesystem::path& path) {
    const std::string extension = lowerCaseExtension(path);
    if (path == "-" || extension == ".png") return PictureFormat::Png;
    if (extension == ".jpg" || extension == ".jpeg") return PictureFormat::Jpeg;
    if (extension == ".tif" || extension == ".tiff") return PictureFormat::Tiff;
    if (extension == ".exr") return PictureFormat::Exr;
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
    const PictureFormat format = formatOf(path);
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

[[noreturn]] void refuseToRead(const std::filesystem::path& path, const PictureFormatFailure& failure) {
    if (failure.kind == PictureFormatFailure::Kind::Size)
        throwInput(CULLSCOPE_TR("%1 is %2x%3 pixels large or no flat picture: pictures of 1 to 16384 pixels a side are read."),
                   {path.string(), std::to_string(failure.width), std::to_string(failure.height)});
    throwInput(CULLSCOPE_TR("%1 is no picture that can be read: %2"), {path.string(), failure.reason});
}

PictureFileContent contentOf(const std::filesystem::path& path) {
    try {
        return pictureFormats().read(path.string(), kOurPrefix, kMostPixels);
    } catch (const PictureFormatFailure& failure) {
        refuseToRead(path, failure);
    }
}

}  // namespace

Picture readPicture(const std::filesystem::path& path) {
    PictureFileContent content = contentOf(path);
    const auto fromTheBottom = [&](const auto& rows) { return upsideDown(rows, content.height); };
    Picture picture;
    picture.size = {content.width, content.height};
    picture.rgba = fromTheBottom(content.bytes.empty() ? straightFromLinear(content.linear) : content.bytes);
    if (!content.depth.empty()) picture.depth = fromTheBottom(content.depth);
    if (!content.triangle.empty()) picture.triangle = fromTheBottom(content.triangle);
    picture.dotsPerInch = content.dotsPerInch;
    picture.metadata = std::move(content.texts);
    const Json json = Json::parse(content.description, nullptr, false);
    if (json.is_object())
        for (const auto& [name, text] : json.items())
            if (name.starts_with(kOurPrefix) && text.is_string()) picture.metadata.emplace_back(name, text.get<std::string>());
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
