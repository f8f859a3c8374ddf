#pragma once

#include <string>

namespace cullscope {

/// A file's path from the root, made with the present working folder. Where that folder is gone the path stays as it is: it can
/// be removed while a program runs, and then no relative path names a file any more.
[[nodiscard]] std::string absoluteFile(const std::string& file);

/// A specification with its files by absolute paths; words such as `bunny`, and an empty one, stay.
[[nodiscard]] std::string withAbsoluteFiles(const std::string& specification);

}  // namespace cullscope
