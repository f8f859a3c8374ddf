#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/image/view_picture.h"
#include "core/scene/section.h"
#include "core/visibility/parameters.h"

namespace cullscope {

/// Pairs of name and text in a picture's file (Picture::metadata).
using PictureMetadata = std::vector<std::pair<std::string, std::string>>;

/// The content of a picture and the figures measured for it.
struct PictureSubject {
    std::string scene;  ///< a specification
    std::vector<std::filesystem::path> modelFolders;
    std::string hidden;  ///< objects left out, as in "3,7-9"; empty: none
    std::string strategy;
    ParameterSet parameters;
    Camera culling;
    Camera viewing;  ///< the culling camera, or an observer's
    Viewport cullingSize, size;
    ViewLook look;
    std::optional<Section> section;  ///< that the picture is cut by
    DrawStyle style;
    std::string picture;           ///< id of the strategy's picture in place of the scene; empty: the scene
    std::string pictureColouring;  ///< with `picture`
    std::optional<uint64_t> submittedTriangles;
    std::optional<uint64_t> missedPixels;
    /// × with its 95 % interval.
    struct Ratio {
        double ratio = 0.0;
        std::array<double, 2> ci95{};
        std::string baseline;
    };
    std::optional<Ratio> ratioToSameSides;  ///< as in result files
    std::optional<Viewport> figuresSize;    ///< the size at which the last two were measured
};

/// Everything that repeats the picture, and its figures: "scene", "strategy", "eye", … "parameter:KEY" behind the prefix. What is
/// not known, and an observer's camera without an observer view, is left out, as are model folders and style. Numbers read back
/// as the very same.
[[nodiscard]] PictureMetadata subjectMetadata(const PictureSubject& subject, std::string_view prefix = "cullscope:");

/// "cullscope:version", "cullscope:commit" and "cullscope:gl_renderer" of the program that drew the picture.
[[nodiscard]] PictureMetadata programMetadata(std::string_view glRenderer);

/// "WIDTHxHEIGHT".
[[nodiscard]] std::string sizeText(const Viewport& size);

}  // namespace cullscope
