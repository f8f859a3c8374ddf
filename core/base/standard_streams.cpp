#include "core/base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace cullscope {

void keepStandardStreams() {
    std::signal(SIGPIPE, SIG_IGN);
    // open returns the lowest free number. Standard output is opened for reading, so that data written to it are not lost
    // silently.
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
        if (fcntl(descriptor, F_GETFD) < 0)
            static_cast<void>(open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_RDWR) == descriptor);
}

}  // namespace cullscope
