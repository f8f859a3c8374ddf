#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
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

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. Choose another place or free some space."), {path.string(), reason});
}

/// A character device or pipe cannot be replaced by renaming a finished file onto it; it is written directly.
bool isStream(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

/// Flushes the file to the disk: a full disk may be reported only by fsync.
void storeOnDisk(const std::filesystem::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool stored = descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL);  // EINVAL: this file system cannot sync
    const int reason = errno;
    if (descriptor >= 0) close(descriptor);
    if (!stored) throw std::filesystem::filesystem_error("write", path, std::error_code(reason, std::generic_category()));
}

void writeStream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream out(path, std::ios::binary);
    if (out) write(out);
    out.close();
    if (!out) refuse(path, systemReason(errno != 0 ? errno : EIO));
}

}  // namespace

void writeFileAtomicallyByName(const std::filesystem::path& link,
                               const std::function<void(const std::filesystem::path&)>& write) {
    std::error_code noSuchFile;
    // A symbolic link is kept: the file that it points to is replaced.
    const std::filesystem::path target = std::filesystem::canonical(link, noSuchFile);
    const std::filesystem::path path = noSuchFile ? link : target;
    if (!noSuchFile && !std::filesystem::is_regular_file(path))
        throwUsage(CULLSCOPE_TR("%1 is a folder or a device: name a file to write."), {link.string()});
    const std::filesystem::path temporary = temporaryBeside(path);
    try {
        write(temporary);
        storeOnDisk(temporary);
        std::filesystem::rename(temporary, path);
    } catch (const std::filesystem::filesystem_error& failure) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        refuse(path, systemReason(failure.code().value()));
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
        if (!std::cout) refuse("standard output", systemReason(errno != 0 ? errno : EIO));
        return;
    }
    if (isStream(path)) return writeStream(path, write);
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
