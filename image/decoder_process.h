// Picture files that are not PNG, decoded by another process: gw-decode, with limits of memory and
// time (docs/decisions/010). A decoder that crashes does not take the command with it. Internal to
// image/.
#pragma once

#include "image/texels.h"

#include <sys/types.h>

#include <filesystem>

namespace gw::image {

/// Starts the process for the first file, and again after a crash. The destructor ends it.
class DecoderProcess {
public:
    DecoderProcess() = default;
    ~DecoderProcess();
    DecoderProcess(const DecoderProcess&) = delete;
    DecoderProcess& operator=(const DecoderProcess&) = delete;

    /// Throws Error "what; expected what" without the file's name.
    Texels read(const std::filesystem::path& file);

private:
    void start();
    std::string stop();
    void receive(void* data, std::size_t size);

    pid_t child_ = -1;
    int socket_ = -1;
};

}  // namespace gw::image
