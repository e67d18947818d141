#include "tests/peer/peer.h"

#include "gw/error.h"
#include "inspect/peer/player.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace gw::test {
namespace {

void put(std::FILE* out, const void* data, std::size_t size) { std::fwrite(data, 1, size, out); }

void get(std::FILE* in, void* data, std::size_t size) {
    if (std::fread(data, 1, size, in) != size) throw Error("the process with OpenGL ended early");
}

void put_text(std::FILE* out, const std::string& text) {
    const std::size_t size = text.size();
    put(out, &size, sizeof size);
    put(out, text.data(), size);
}

std::string get_text(std::FILE* in) {
    std::size_t size = 0;
    get(in, &size, sizeof size);
    std::string text(size, ' ');
    get(in, text.data(), size);
    return text;
}

/// Calls `each` with the vectors that a peer fills.
void for_planes(auto& p, const auto& each) {
    each(p.color.data(), p.color.size() * sizeof p.color[0]);
    each(p.depth.data(), p.depth.size() * sizeof p.depth[0]);
    each(p.stencil.data(), p.stencil.size() * sizeof p.stencil[0]);
    each(p.back.data(), p.back.size() * sizeof(Rgba));
}

/// Initial state, planes of 0: what a machine starts with.
CommandList fresh() {
    CommandList list;
    list.commands.emplace_back(SetState{});
    list.commands.emplace_back(Clear{.planes = all_planes, .depth = 0});
    return list;
}

/// What went wrong, or nothing, the planes and the results of queries.
void answer(std::FILE* out, peer::Player& player, const CommandList& list) {
    const std::size_t before = player.queries().size();
    try {
        player.play(fresh());
        player.play(list);
    } catch (const Error& error) {
        put_text(out, error.what());
        return;
    }
    put_text(out, "");
    const Planes planes = player.planes();
    for_planes(planes, [&](const void* data, std::size_t size) { put(out, data, size); });
    const std::size_t count = player.queries().size() - before;
    put(out, &count, sizeof count);
    put(out, player.queries().data() + before, count * sizeof(QueryResult));
}

void play_all(std::FILE* out, const std::vector<CommandList>& lists, int width, int height,
              const Profile& profile) {
    peer::Player player(profile, width, height);
    put_text(out, player.renderer());
    for (const CommandList& list : lists) answer(out, player, list);
}

/// The other process. Ends without the destructors and exit handlers of this one.
[[noreturn]] void child(int pipe, const std::string& driver, const std::vector<CommandList>& lists,
                        int width, int height, const Profile& profile) {
    setenv("GALLIUM_DRIVER", driver.c_str(), 1);
    std::FILE* out = fdopen(pipe, "wb");
    play_all(out, lists, width, height, profile);
    std::fclose(out);
    _exit(0);
}

Answers receive(std::FILE* in, std::size_t count, int width, int height, const Profile& profile) {
    Answers answers{.renderer = get_text(in), .planes = {}};
    for (std::size_t i = 0; i < count; ++i) {
        const std::string error = get_text(in);
        if (!error.empty()) throw Error(error);
        Planes planes(width, height);
        if (profile.color_planes == 2) planes.back.resize(planes.color.size());
        for_planes(planes, [&](void* data, std::size_t size) { get(in, data, size); });
        answers.planes.push_back(std::move(planes));
        std::size_t results = 0;
        get(in, &results, sizeof results);
        answers.queries.emplace_back(results);
        get(in, answers.queries.back().data(), results * sizeof(QueryResult));
    }
    return answers;
}

}  // namespace

Answers play(const std::string& driver, const std::vector<CommandList>& lists, int width,
             int height, const Profile& profile) {
    int ends[2];
    if (pipe(ends) != 0) throw Error("no pipe");
    const pid_t process = fork();
    if (process < 0) throw Error("no process");
    if (process == 0) {
        close(ends[0]);
        child(ends[1], driver, lists, width, height, profile);
    }
    close(ends[1]);
    std::FILE* in = fdopen(ends[0], "rb");
    Answers answers = receive(in, lists.size(), width, height, profile);
    std::fclose(in);
    waitpid(process, nullptr, 0);
    return answers;
}

std::vector<Planes> execute(const std::vector<CommandList>& lists, int width, int height,
                            const Profile& profile) {
    std::vector<Planes> planes;
    for (const CommandList& list : lists) {
        const std::unique_ptr<Machine> machine = make_reference(profile, width, height);
        machine->execute(list);
        planes.push_back(machine->planes());
    }
    return planes;
}

}  // namespace gw::test
