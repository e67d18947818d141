#include "image/decoder_process.h"

#include "image/decoder_reply.h"

#include <dlfcn.h>
#include <link.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>

extern char** environ;

namespace gw::image {
namespace {

constexpr const char* program = "gw-decode";

/// The folders in which this part of the program searches for its libraries: the module of formats
/// and the decoder are in one of them.
std::vector<std::filesystem::path> library_folders() {
    Dl_info self{};
    void* handle = nullptr;
    if (dladdr(reinterpret_cast<const void*>(&library_folders), &self))
        handle = dlopen(self.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    if (!handle) handle = dlopen(nullptr, RTLD_LAZY);
    Dl_serinfo size{};
    if (!handle || dlinfo(handle, RTLD_DI_SERINFOSIZE, &size) != 0) return {};
    const std::unique_ptr<char[]> bytes(new char[size.dls_size]);
    auto* info = reinterpret_cast<Dl_serinfo*>(bytes.get());
    *info = size;
    if (dlinfo(handle, RTLD_DI_SERINFO, info) != 0) return {};
    std::vector<std::filesystem::path> folders;
    for (unsigned int i = 0; i < info->dls_cnt; ++i)
        folders.emplace_back(info->dls_serpath[i].dls_name);
    return folders;
}

std::filesystem::path find_program() {
    for (const std::filesystem::path& folder : library_folders())
        if (::access((folder / program).c_str(), X_OK) == 0) return folder / program;
    throw Error(std::string("picture formats other than PNG need the program ") + program +
                "; expected it beside libgw_formats.so");
}

/// Standard input and output are the socket; messages of picture libraries go nowhere.
pid_t spawn(const std::filesystem::path& file, int socket) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 1, 0);
    char* const arguments[] = {const_cast<char*>(program), nullptr};
    pid_t child = -1;
    const int error = posix_spawn(&child, file.c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw Error(std::string(program) + " cannot be started: " + strerror(error));
    return child;
}

std::string end_text(int status) {
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return "decoding it takes more than " + std::to_string(decoder_seconds) +
               " s; expected a smaller picture";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return "decoding it was stopped; expected a picture file";
    return "its decoder crashed; expected an undamaged picture file";
}

}  // namespace

DecoderProcess::~DecoderProcess() { stop(); }

void DecoderProcess::start() {
    const std::filesystem::path file = find_program();
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw Error(std::string(program) + " cannot be started: " + std::strerror(errno));
    socket_ = ends[0];
    try {
        child_ = spawn(file, ends[1]);
    } catch (const Error&) {
        ::close(ends[1]);
        stop();
        throw;
    }
    ::close(ends[1]);
}

/// How the process ended.
std::string DecoderProcess::stop() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    if (child_ < 0) return {};
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return end_text(status);
}

void DecoderProcess::receive(void* data, std::size_t size) {
    char* at = static_cast<char*>(data);
    while (size > 0) {
        pollfd ready{.fd = socket_, .events = POLLIN, .revents = 0};
        const int count = ::poll(&ready, 1, decoder_patience_seconds * 1000);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) ::kill(child_, SIGKILL);
        const ssize_t got = count <= 0 ? 0 : ::recv(socket_, at, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw Error(stop());
        at += got;
        size -= std::size_t(got);
    }
}

Texels DecoderProcess::read(const std::filesystem::path& file) {
    if (child_ < 0) start();
    const std::string name = std::filesystem::absolute(file).string();
    // A process that is gone is noticed when its answer does not come.
    (void)::send(socket_, name.c_str(), name.size() + 1, MSG_NOSIGNAL);
    DecoderReply reply;
    receive(&reply, sizeof reply);
    if (reply.kind == DecoderReply::Message) {
        std::string text(std::min<std::uint64_t>(reply.bytes, 1000), ' ');
        receive(text.data(), text.size());
        throw Error(text);
    }
    check_sides(reply.width, reply.height);
    Texels texels{
        .width = reply.width, .height = reply.height, .rgba = {}, .largest = reply.largest};
    const auto count = std::size_t(reply.width) * std::size_t(reply.height) * 4;
    const auto receive_values = [&](auto values) {
        values.resize(count);
        receive(values.data(), count * sizeof values[0]);
        texels.rgba = std::move(values);
    };
    if (reply.kind == DecoderReply::Bits16)
        receive_values(std::vector<std::uint16_t>());
    else
        receive_values(std::vector<std::uint8_t>());
    return texels;
}

}  // namespace gw::image
