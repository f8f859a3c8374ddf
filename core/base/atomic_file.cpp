#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// The end of every temporary file's name; nothing else is named so.
constexpr std::string_view kTemporaryEnding = ".cullscope-part";
/// So much of the file's own name stands in that of the temporary one, in bytes: the whole is short for every file system.
constexpr size_t kMostStemBytes = 60;

[[noreturn]] void refuse(const std::filesystem::path& path, int errorNumber) {
    throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. Choose another place or free some space."),
               {path.string(), systemReason(errorNumber != 0 ? errorNumber : EIO)});
}

/// A character device or pipe cannot be replaced by renaming a finished file onto it; it is written directly.
bool isStream(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

void writeStream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream out(path, std::ios::binary);
    if (out) write(out);
    out.close();
    if (!out) refuse(path, errno);
}

void writeStandardOutput(const std::function<void(std::ostream&)>& write) {
    errno = 0;
    write(std::cout);
    std::cout.flush();
    if (!std::cout) refuse("standard output", errno);
}

/// The file that a chain of symbolic links leads to, whether it exists or not. The links stay; the file is replaced.
std::filesystem::path behindLinks(std::filesystem::path path) {
    constexpr int kMostLinks = 40;  // as the kernel
    std::error_code failure;
    for (int links = 0; std::filesystem::is_symlink(path, failure); ++links) {
        if (links == kMostLinks) refuse(path, ELOOP);
        path = path.parent_path() / std::filesystem::read_symlink(path, failure);
    }
    return path;
}

std::filesystem::path folderOf(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// The longest beginning of a name within the limit that ends between two UTF-8 characters.
std::string beginning(const std::string& stem) {
    if (stem.size() <= kMostStemBytes) return stem;
    size_t bytes = kMostStemBytes;
    while (bytes > 0 && (static_cast<unsigned char>(stem[bytes]) & 0xC0) == 0x80) --bytes;
    return stem.substr(0, bytes);
}

/// Closes a descriptor.
class Descriptor {
public:
    explicit Descriptor(int descriptor) : m_descriptor(descriptor) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (m_descriptor >= 0) close(m_descriptor);
    }
    [[nodiscard]] int get() const { return m_descriptor; }

private:
    int m_descriptor;
};

/// A new file beside the one that it will replace. It is locked while it is written: so a file of that ending without a lock is
/// what a killed program left. Removed unless it was put in its place.
class TemporaryFile {
public:
    /// `old`: what is known of the file to be replaced; null where there is none.
    TemporaryFile(const std::filesystem::path& target, const struct stat* old)
        : m_target(target), m_descriptor(create(old != nullptr ? 0600 : 0666)) {
        if (old == nullptr) return;
        // The owner first, because a change of it takes mode bits away. Not everyone may give files to others.
        static_cast<void>(fchown(m_descriptor.get(), old->st_uid, old->st_gid) == 0);
        static_cast<void>(fchmod(m_descriptor.get(), old->st_mode & 07777) == 0);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!m_path.empty()) unlink(m_path.c_str());
    }

    void fill(const std::function<void(std::ostream&)>& write) const {
        errno = 0;
        std::ofstream out(m_path, std::ios::binary);
        if (out) write(out);
        out.close();
        if (!out) refuse(m_target, errno);
        // A full disk may be reported only here. EINVAL: this file system cannot sync.
        if (fsync(m_descriptor.get()) != 0 && errno != EINVAL) refuse(m_target, errno);
    }
    void putInPlace() {
        if (std::rename(m_path.c_str(), m_target.c_str()) != 0) refuse(m_target, errno);
        m_path.clear();
    }

private:
    /// Another program may make the same name, or may find the file between its making and its locking and remove it.
    int create(mode_t mode) {
        const std::string stem = beginning(m_target.stem().string());
        for (int number = 0;; ++number) {
            m_path = folderOf(m_target) /
                     ("." + stem + "." + std::to_string(getpid()) + "-" + std::to_string(number) + std::string(kTemporaryEnding));
            const int descriptor = open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
            if (descriptor < 0) {
                if (errno == EEXIST) continue;
                m_path.clear();
                refuse(m_target, errno);
            }
            static_cast<void>(flock(descriptor, LOCK_EX) == 0);
            struct stat made {};
            if (fstat(descriptor, &made) == 0 && made.st_nlink > 0) return descriptor;
            close(descriptor);
        }
    }

    std::filesystem::path m_target, m_path;
    Descriptor m_descriptor;
};

void removeLeftTemporaries(const std::filesystem::path& folder) {
    std::error_code failure;
    for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with('.') || !name.ends_with(kTemporaryEnding)) continue;
        const Descriptor left(open(entry->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
        if (left.get() >= 0 && flock(left.get(), LOCK_EX | LOCK_NB) == 0) unlink(entry->path().c_str());
    }
}

/// The temporary file that will replace `link`, or the file that it leads to.
TemporaryFile temporaryFor(const std::filesystem::path& link) {
    const std::filesystem::path path = behindLinks(link);
    struct stat old {};
    const bool exists = stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) refuse(link, errno);
    if (exists && !S_ISREG(old.st_mode))
        throwUsage(CULLSCOPE_TR("%1 is a folder or a device: name a file to write."), {link.string()});
    if (exists && access(path.c_str(), W_OK) != 0) refuse(link, errno);
    if (!exists && !path.has_filename())
        throwUsage(CULLSCOPE_TR("%1 is a folder or a device: name a file to write."), {link.string()});
    removeLeftTemporaries(folderOf(path));
    return {path, exists ? &old : nullptr};
}

}  // namespace

void writeFileAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    if (path == "-") return writeStandardOutput(write);
    if (isStream(path)) return writeStream(path, write);
    TemporaryFile temporary = temporaryFor(path);
    temporary.fill(write);
    temporary.putInPlace();
}

void requireWritable(const std::filesystem::path& path) {
    if (path == "-" || path.empty()) return;
    if (!isStream(path)) {
        static_cast<void>(temporaryFor(path));
    } else if (access(path.c_str(), W_OK) != 0) {
        refuse(path, errno);
    }
}

}  // namespace cullscope
