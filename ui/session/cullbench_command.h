#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/scene/camera.h"
#include "core/visibility/parameters.h"

namespace cullscope::ui {

/// Everything that a view's picture depends on.
struct PictureRequest {
    std::string scene;  ///< a specification
    std::vector<std::filesystem::path> modelFolders;
    std::string strategy;
    ParameterSet parameters;
    Camera camera;
    Viewport size;
    DrawStyle style;  ///< of 8 bits a channel
};

/// The words of the `cullbench render` command that repeats a picture exactly from any folder: files by absolute paths.
/// Parameters at their defaults are left out.
[[nodiscard]] QStringList cullbenchArguments(const PictureRequest& request, const QString& output);

/// The same as one line, quoted for a POSIX shell, with the program's name.
[[nodiscard]] QString cullbenchCommand(const PictureRequest& request);

}  // namespace cullscope::ui
