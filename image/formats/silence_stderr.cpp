#include "image/formats/silence_stderr.h"

#include <fcntl.h>
#include <unistd.h>
#include <cstdio>

namespace gw::image::oiio {

SilenceStderr::SilenceStderr() {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    std::fflush(stderr);
    kept_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (kept_ >= 0) ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
}

SilenceStderr::~SilenceStderr() {
    if (kept_ < 0) return;
    std::fflush(stderr);
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
}

}  // namespace gw::image::oiio
