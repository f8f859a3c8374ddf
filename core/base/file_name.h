#pragma once

#include <filesystem>
#include <string_view>

namespace cullscope {

/// The first file name of a pattern such as "{scene}-{strategy}-{n:04}.png" that no file in `folder` has, as a path in `folder`.
/// {n} is the smallest number from 1 for which no such file exists, {n:04} the same with at least four digits. Characters that a
/// file system or another program may reject or misread (slashes, colons, quotes, a leading dot …) become "-" or "_", and long
/// names are cut, so that the file always lies in `folder`. Throws Error(Usage) for an unknown field, naming the known ones, and
/// where a pattern without {n} names a file that exists.
[[nodiscard]] std::filesystem::path nextFileName(const std::filesystem::path& folder, std::string_view pattern,
                                                 std::string_view scene, std::string_view strategy);

}  // namespace cullscope
