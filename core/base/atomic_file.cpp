#include "core/base/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>

#include "core/base/error.h"

namespace cullscope {
namespace {

std::filesystem::path temporaryBeside(const std::filesystem::path& path) {
    std::filesystem::path temporary = path;
    temporary.replace_filename("." + path.stem().string() + "." + std::to_string(getpid()) + ".part" + path.extension().string());
    return temporary;
}

}  // namespace

void writeFileAtomicallyByName(const std::filesystem::path& path,
                               const std::function<void(const std::filesystem::path&)>& write) {
    const std::filesystem::path temporary = temporaryBeside(path);
    try {
        write(temporary);
        std::filesystem::rename(temporary, path);
    } catch (const std::filesystem::filesystem_error& failure) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. Choose another place or free some space."),
                   {path.string(), failure.code().message()});
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw;
    }
}

void writeFileAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    if (path == "-") {
        write(std::cout);
        std::cout.flush();
        return;
    }
    writeFileAtomicallyByName(path, [&](const std::filesystem::path& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary);
        if (out) write(out);
        out.close();
        if (!out)
            throw std::filesystem::filesystem_error("write", path,
                                                    std::error_code(errno != 0 ? errno : EIO, std::generic_category()));
    });
}

}  // namespace cullscope
