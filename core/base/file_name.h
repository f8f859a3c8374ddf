#pragma once

#include <filesystem>
#include <string_view>

namespace cullscope {

/// The first name of a pattern such as "{scene}-{strategy}-{n:04}.png" that no file in `folder` has, with the folder before it.
/// {n} is the least number from 1 that gives one, {n:04} the same with at least four digits. What a file system or another
/// program could take amiss in a name (slashes, colons, quotes, a leading dot …) becomes "-" or "_", long names are cut, so that
/// the file always lies in `folder`. Throws Error(Usage) for an unknown field, naming the known ones, and where a pattern
/// without {n} names a file that exists.
[[nodiscard]] std::filesystem::path nextFileName(const std::filesystem::path& folder, std::string_view pattern,
                                                 std::string_view scene, std::string_view strategy);

}  // namespace cullscope
