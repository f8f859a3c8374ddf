#pragma once

#include <QStringList>
#include <filesystem>
#include <vector>

#include "core/image/picture_metadata.h"

namespace cullscope::ui {

/// The words with which a command about a scene begins, from any folder: files and folders by absolute paths.
[[nodiscard]] QStringList sceneWords(const QString& command, const std::string& scene,
                                     const std::vector<std::filesystem::path>& modelFolders);

/// The words of the `cullbench render` command that repeats a picture of the scene exactly from any folder. Parameters at their
/// defaults are left out.
[[nodiscard]] QStringList cullbenchArguments(const PictureSubject& picture, const QString& output);

/// Words of a `cullbench` command as one line for a POSIX shell, quoted where they must be, with the program's name.
[[nodiscard]] QString shellLine(const QStringList& arguments);

/// The `cullbench render` command that repeats a picture, as such a line.
[[nodiscard]] QString cullbenchCommand(const PictureSubject& picture);

}  // namespace cullscope::ui
