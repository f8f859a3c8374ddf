#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/image/view_picture.h"
#include "core/scene/camera.h"
#include "core/visibility/parameters.h"

namespace cullscope::ui {

/// All inputs of a view's picture.
struct PictureRequest {
    std::string scene;  ///< a specification
    std::vector<std::filesystem::path> modelFolders;
    std::string strategy;
    ParameterSet parameters;
    std::string hidden;                   ///< numbers of the hidden objects, such as "3,7-9"; empty: none
    Camera camera;                        ///< the culling camera
    std::optional<Camera> observer;       ///< the viewing camera; none: the culling camera
    std::optional<Viewport> cullingSize;  ///< picture size of the culling camera; none: `size`
    Viewport size;
    ViewLook look;    ///< without the boxes, bands and kernel that the strategy does not have
    DrawStyle style;  ///< colours of 8 bits a channel
};

/// The arguments of `cullbench` (`render` and its options) that repeat a picture exactly from any folder: files have absolute
/// paths. Parameters with default values are omitted.
[[nodiscard]] QStringList cullbenchArguments(const PictureRequest& request, const QString& output);

/// The whole command as one line, quoted for a POSIX shell.
[[nodiscard]] QString cullbenchCommand(const PictureRequest& request);

}  // namespace cullscope::ui
