// gw-decode: decodes picture files for image/decoder_process.h, in a process of its own. A damaged
// file may crash a decoder or make it take all memory; then only this process ends.
#include "gw/error.h"
#include "image/decoder/read_texels.h"
#include "image/decoder_reply.h"

#include <OpenImageIO/imageio.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace gw::image {
namespace {

void limit(int what, rlim_t amount) {
    rlimit now{};
    if (getrlimit(static_cast<__rlimit_resource>(what), &now) != 0) return;
    now.rlim_cur = std::min(amount, now.rlim_max);
    setrlimit(static_cast<__rlimit_resource>(what), &now);
}

void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limit(RLIMIT_DATA, decoder_megabytes << 20);
#endif
    limit(RLIMIT_CORE, 0);
}

/// The limit is on the time since the process began.
void limit_time() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = rlim_t(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    limit(RLIMIT_CPU, seconds + decoder_seconds);
}

/// False if nobody reads any more.
bool send(const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(STDOUT_FILENO, at, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += written;
        size -= std::size_t(written);
    }
    return true;
}

bool send_message(const std::string& text) {
    const DecoderReply reply{.kind = DecoderReply::Message, .bytes = text.size()};
    return send(&reply, sizeof reply) && send(text.data(), text.size());
}

bool send_texels(const Texels& texels) {
    const auto send_values = [&](const auto& values) {
        const DecoderReply reply{.kind = std::uint32_t(8 * sizeof values[0]),
                                 .width = texels.width,
                                 .height = texels.height,
                                 .largest = texels.largest,
                                 .bytes = values.size() * sizeof values[0]};
        return send(&reply, sizeof reply) && send(values.data(), reply.bytes);
    };
    return std::visit(send_values, texels.rgba);
}

bool answer(const std::string& file) {
    try {
        return send_texels(read_texels(file));
    } catch (const Error& error) {
        return send_message(error.what());
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    } catch (const std::exception& error) {
        return send_message(std::string("it cannot be read: ") + error.what() +
                            "; expected a picture file");
    }
    return send_message("decoding it needs more than " + std::to_string(decoder_megabytes) +
                        " MB; expected a smaller picture");
}

}  // namespace
}  // namespace gw::image

int main() {
    using namespace gw::image;
    limit_memory();
    OIIO::attribute("threads", 1);
    for (std::string file; std::getline(std::cin, file, '\0');) {
        limit_time();
        if (!answer(file)) return 1;
    }
}
