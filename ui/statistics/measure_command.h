#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope::ui {

/// Where a measured scene comes from.
struct SceneOrigin {
    std::string specification;  ///< as `cullbench` takes it
    std::vector<std::filesystem::path> modelFolders;
};

/// The `cullbench measure` command that repeats an experiment from any folder, as one line for a POSIX shell. The camera path
/// goes by its name, which is a built-in one or a file's.
[[nodiscard]] QString measureCommand(const MeasureRequest& request, const SceneOrigin& origin);

}  // namespace cullscope::ui
