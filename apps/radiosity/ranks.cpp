#include "apps/radiosity/ranks.h"

#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "gw/error.h"

#include <fmt/format.h>

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <thread>
#include <utility>

namespace gw::apps {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds patience{60}, greeting{5};
constexpr std::size_t most_processes = 4096, most_bytes = std::size_t{1} << 32;

class Socket {
public:
    explicit Socket(int descriptor = -1) : descriptor_(descriptor) {}
    Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    Socket& operator=(Socket&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~Socket() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    bool is_open() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }

    /// False if the other side is gone.
    bool send(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t n = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) return false;
            bytes.remove_prefix(std::size_t(n));
        }
        return true;
    }
    bool receive(char* to, std::size_t size) const {
        while (size > 0) {
            const ssize_t n = ::recv(descriptor_, to, size, 0);
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) return false;
            to += n;
            size -= std::size_t(n);
        }
        return true;
    }

    /// A length in 8 bytes, and so many bytes.
    bool send_text(std::string_view text) const {
        std::array<char, 8> size;
        for (std::size_t i = 0; i < 8; ++i) size[i] = char(std::uint64_t{text.size()} >> 8 * i);
        return send({size.data(), size.size()}) && send(text);
    }
    std::optional<std::string> receive_text(std::size_t most = most_bytes) const {
        std::array<char, 8> bytes;
        if (!receive(bytes.data(), bytes.size())) return std::nullopt;
        std::uint64_t size = 0;
        for (std::size_t i = 0; i < 8; ++i)
            size |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
        if (size > most) return std::nullopt;
        std::string text(size, '\0');
        if (!receive(text.data(), text.size())) return std::nullopt;
        return text;
    }

    /// From now on, sends at once, and notices a machine that is gone.
    void set_for_talk() const {
        const int on = 1;
        setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        setsockopt(descriptor_, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
    }
    void set_limit(std::chrono::seconds limit) const {
        const timeval time{limit.count(), 0};
        setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
    }

private:
    int descriptor_;
};

std::string system_fault() { return std::strerror(errno); }

std::optional<std::size_t> number_in(const char* name) {
    const char* const text = std::getenv(name);
    std::size_t value = 0;
    if (!text) return std::nullopt;
    const char* const end = text + std::strlen(text);
    const auto [at, fault] = std::from_chars(text, end, value);
    return fault == std::errc() && at == end && at != text ? std::optional(value) : std::nullopt;
}

/// Variables of a launcher; `local`: how many of its processes are on this machine.
struct Launcher {
    const char *number, *count, *local;
};
constexpr std::array launchers{
    Launcher{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_SIZE"},
    Launcher{"PMI_RANK", "PMI_SIZE", "MPI_LOCALNRANKS"},
    Launcher{"SLURM_PROCID", "SLURM_NTASKS", nullptr},
};

std::string secret() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
        throw Error("no random numbers: " + system_fault() + "; expected some");
    std::string text;
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
}

/// Where process 0 waits.
struct Meeting {
    std::string host, port, secret;
};

std::filesystem::path meeting_file(const std::filesystem::path& folder) {
    return folder / ".ranks";
}

/// Readable by its owner only; complete as soon as it is there.
void put_meeting(const Meeting& meeting, const std::filesystem::path& folder) {
    const std::filesystem::path file = meeting_file(folder), part = folder / ".ranks.part";
    const auto refuse = [&] {
        throw Error(file.string(), 0, system_fault() + "; expected a folder to write into");
    };
    ::unlink(part.c_str());
    const mode_t before = ::umask(077);
    std::ofstream out(part);
    ::umask(before);
    out << meeting.host << ' ' << meeting.port << ' ' << meeting.secret << '\n';
    out.close();
    if (!out || ::rename(part.c_str(), file.c_str()) != 0) refuse();
}

/// None if there is none, or one that is no longer good.
std::optional<Meeting> meeting_in(const std::filesystem::path& folder) {
    std::ifstream in(meeting_file(folder));
    Meeting meeting;
    if (!(in >> meeting.host >> meeting.port >> meeting.secret)) return std::nullopt;
    return meeting;
}

Socket connected(const Meeting& meeting) {
    addrinfo hints{}, *list = nullptr;
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(meeting.host.c_str(), meeting.port.c_str(), &hints, &list) != 0)
        return Socket();
    Socket found;
    for (const addrinfo* a = list; a && !found.is_open(); a = a->ai_next) {
        Socket socket(::socket(a->ai_family, a->ai_socktype | SOCK_CLOEXEC, a->ai_protocol));
        if (socket.is_open() && ::connect(socket.descriptor(), a->ai_addr, a->ai_addrlen) == 0)
            found = std::move(socket);
    }
    freeaddrinfo(list);
    return found;
}

class Exchange : public radiosity::RowExchange {
public:
    Exchange(const Rank& rank, std::vector<Socket> sockets)
        : rank_(rank), sockets_(std::move(sockets)) {}

    std::size_t rank() const override { return rank_.number; }
    std::size_t processes() const override { return rank_.count; }

    std::vector<std::string> exchange(const std::string& mine) override {
        return rank_.number == 0 ? collect(mine) : ask(mine);
    }

private:
    /// Process 0 has a socket to each other one.
    std::vector<std::string> collect(const std::string& mine) {
        std::vector<std::string> all{mine};
        for (std::size_t i = 1; i < rank_.count; ++i) {
            auto text = sockets_[i].receive_text();
            if (!text) lose(i);
            all.push_back(std::move(*text));
        }
        for (std::size_t i = 1; i < rank_.count; ++i)
            for (std::size_t k = 0; k < rank_.count; ++k)
                if (k != i && !sockets_[i].send_text(all[k])) lose(i);
        return all;
    }

    std::vector<std::string> ask(const std::string& mine) {
        const Socket& socket = sockets_.front();
        if (!socket.send_text(mine)) lose(0);
        std::vector<std::string> all;
        for (std::size_t k = 0; k < rank_.count; ++k) {
            auto text = k == rank_.number ? std::optional(mine) : socket.receive_text();
            if (!text) lose(0);
            all.push_back(std::move(*text));
        }
        return all;
    }

    [[noreturn]] void lose(std::size_t number) const {
        throw Error(fmt::format("process {} of {} has ended; expected all to go on", number + 1,
                                rank_.count));
    }

    Rank rank_;
    std::vector<Socket> sockets_;
};

Socket listening(bool one_machine) {
    Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(one_machine ? INADDR_LOOPBACK : INADDR_ANY);
    if (!socket.is_open() ||
        ::bind(socket.descriptor(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(socket.descriptor(), 128) != 0)
        throw Error("no socket for other processes: " + system_fault() + "; expected one");
    return socket;
}

std::string port_of(const Socket& socket) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(socket.descriptor(), reinterpret_cast<sockaddr*>(&address), &size);
    return std::to_string(ntohs(address.sin_port));
}

std::string host_name(bool one_machine) {
    std::array<char, 256> name{};
    if (one_machine || ::gethostname(name.data(), name.size() - 1) != 0) return "127.0.0.1";
    return name.data();
}

/// "SECRET NUMBER COUNT WORK". None if a stranger says it.
struct Greeting {
    std::size_t number = 0, count = 0;
    std::string work;
};
std::optional<Greeting> greeting_from(const std::string& text, const std::string& secret) {
    if (!text.starts_with(secret + " ")) return std::nullopt;
    Greeting g;
    const char* at = text.data() + secret.size() + 1;
    const char* const end = text.data() + text.size();
    for (std::size_t* const number : {&g.number, &g.count}) {
        const auto [after, fault] = std::from_chars(at, end, *number);
        if (fault != std::errc() || after == end || *after != ' ') return std::nullopt;
        at = after + 1;
    }
    g.work.assign(at, end);
    return g;
}

std::string fault_of(const Greeting& g, const Rank& rank, const std::string& work,
                     const std::vector<Socket>& sockets) {
    if (g.count != rank.count)
        return fmt::format("is one of {}; expected one of {}", g.count, rank.count);
    if (g.number == 0 || g.number >= rank.count || sockets[g.number].is_open())
        return "is there twice; expected another number for each";
    if (g.work != work)
        return "has another scene, version, state or options; expected the same for all";
    return "";
}

std::vector<Socket> wait_for_others(const Rank& rank, const std::filesystem::path& folder,
                                    const std::string& work) {
    const Socket listener = listening(rank.one_machine);
    const Meeting meeting{host_name(rank.one_machine), port_of(listener), secret()};
    put_meeting(meeting, folder);
    std::vector<Socket> sockets(rank.count);
    const auto until = Clock::now() + patience;
    for (std::size_t missing = rank.count - 1; missing > 0;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
        pollfd waiting{listener.descriptor(), POLLIN, 0};
        if (left <= 0 || ::poll(&waiting, 1, int(left)) == 0) {
            std::filesystem::remove(meeting_file(folder));
            throw Error(fmt::format("{} of {} processes have not come; expected them within {} s",
                                    missing, rank.count, patience.count()));
        }
        Socket socket(::accept4(listener.descriptor(), nullptr, nullptr, SOCK_CLOEXEC));
        if (!socket.is_open()) continue;
        socket.set_for_talk();
        socket.set_limit(greeting);
        const auto text = socket.receive_text(1 << 16);
        const auto g = text ? greeting_from(*text, meeting.secret) : std::nullopt;
        if (!g) continue;
        const std::string fault = fault_of(*g, rank, work, sockets);
        socket.send_text(fault);
        if (!fault.empty()) {
            std::filesystem::remove(meeting_file(folder));
            throw Error(fmt::format("process {} of {} {}", g->number + 1, rank.count, fault));
        }
        socket.set_limit({});
        sockets[g->number] = std::move(socket);
        --missing;
    }
    std::filesystem::remove(meeting_file(folder));
    return sockets;
}

/// A file of an earlier launch leads nowhere, so it is read again.
Socket first_process(const Rank& rank, const std::filesystem::path& folder,
                     const std::string& work) {
    const auto until = Clock::now() + patience;
    while (Clock::now() < until) {
        if (const auto meeting = meeting_in(folder)) {
            Socket socket = connected(*meeting);
            socket.set_for_talk();
            if (socket.is_open() && socket.send_text(fmt::format("{} {} {} {}", meeting->secret,
                                                                 rank.number, rank.count, work)))
                if (const auto answer = socket.receive_text(1 << 16)) {
                    if (answer->empty()) return socket;
                    throw Error(
                        fmt::format("process {} of {} {}", rank.number + 1, rank.count, *answer));
                }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    throw Error(folder.string(), 0,
                fmt::format("process 1 of {} does not wait there; expected it within {} s",
                            rank.count, patience.count()));
}

}  // namespace

Rank rank_from(const std::string& word) {
    const auto checked = [&](Rank rank) {
        if (rank.number < rank.count && rank.count <= most_processes) return rank;
        throw UsageError(fmt::format("--rank '{}': process {} of {}; expected 1 to 4096 of them",
                                     word, rank.number + 1, rank.count));
    };
    if (word == "mpi") {
        for (const Launcher& by : launchers) {
            const auto number = number_in(by.number), count = number_in(by.count);
            if (!number || !count) continue;
            const auto local = by.local ? number_in(by.local) : std::nullopt;
            return checked({*number, *count, local == count});
        }
        throw UsageError(
            "--rank mpi: no launcher says which process this is; expected mpirun, "
            "srun, or --rank I/N");
    }
    const std::size_t bar = word.find('/');
    if (bar == word.npos) throw UsageError("--rank '" + word + "': expected mpi, or I/N as 1/4");
    const int count = whole_number_from("--rank", word.substr(bar + 1), 1, int(most_processes));
    return {std::size_t(whole_number_from("--rank", word.substr(0, bar), 1, count)) - 1,
            std::size_t(count), true};
}

std::shared_ptr<radiosity::RowExchange> meet(const Rank& rank, const std::filesystem::path& folder,
                                             const std::string& work) {
    if (rank.count == 1) return nullptr;
    std::vector<Socket> sockets;
    if (rank.number == 0)
        sockets = wait_for_others(rank, folder, work);
    else
        sockets.push_back(first_process(rank, folder, work));
    return std::make_shared<Exchange>(rank, std::move(sockets));
}

}  // namespace gw::apps
