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

/// Everything that a view's picture depends on.
struct PictureRequest {
    std::string scene;  ///< a specification
    std::vector<std::filesystem::path> modelFolders;
    std::string strategy;
    ParameterSet parameters;
    std::string hidden;                   ///< objects left out, as in "3,7-9"; empty: none
    Camera camera;                        ///< the culling camera
    std::optional<Camera> observer;       ///< the camera that looks; none: the culling camera
    std::optional<Viewport> cullingSize;  ///< of the culling camera's picture; none: `size`
    Viewport size;
    ViewLook look;    ///< with boxes, bands and kernel only where the strategy has some
    DrawStyle style;  ///< of 8 bits a channel
};

/// The words of the `cullbench render` command that repeats a picture exactly from any folder: files by absolute paths.
/// Parameters at their defaults are left out.
[[nodiscard]] QStringList cullbenchArguments(const PictureRequest& request, const QString& output);

/// The same as one line, quoted for a POSIX shell, with the program's name.
[[nodiscard]] QString cullbenchCommand(const PictureRequest& request);

}  // namespace cullscope::ui
