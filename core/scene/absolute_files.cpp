#include "core/scene/absolute_files.h"

#include <filesystem>
#include <system_error>

#include "core/scene/scene_source.h"

namespace cullscope {

std::string absoluteFile(const std::string& file) {
    std::error_code failure;
    const std::filesystem::path path = std::filesystem::absolute(file, failure);
    return failure ? file : path.lexically_normal().string();
}

std::string withAbsoluteFiles(const std::string& specification) {
    // An empty specification must not become a folder's path.
    return specification.empty() ? std::string() : withFiles(specification, absoluteFile);
}

}  // namespace cullscope
