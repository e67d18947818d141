// gw-gl-recordings: random programs of several OSMesa contexts, sizes and orders of MakeCurrent are
// recorded (GW_RECORD) and replayed on both machines. The pixels that each program got are the oracle.
// Each program runs in a process of its own. Exit 0: all agree; 1: an error; 2: usage; 3: a difference.
#include "tests/gl/peer/steps.h"

#include "gw/machine.h"
#include "inspect/recording/stream.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace gw::gl_peer {
namespace {

/// The last pixels of a window of the recording, R, G, B, A, bottom row first. Empty: the program
/// resized or destroyed it without looking.
struct SeenWindow {
    int width = 0, height = 0;
    std::vector<GLubyte> pixels;
};

const std::vector<StepKind>& step_kinds() {
    static const std::vector<StepKind> all = [] {
        std::vector<StepKind> out{{"shape", draw_shape},
                                  {"inner shape", draw_inner_shape},
                                  {"textured shape", draw_textured_shape},
                                  {"lit shape", draw_lit_shape},
                                  {"rectangle", draw_rectangle},
                                  {"copy", draw_copy},
                                  {"surface", draw_surface},
                                  {"accumulation", accumulate},
                                  {"copy to texture", copy_to_texture},
                                  {"feedback", feed_back},
                                  {"read", read_rectangle}};
        for (const auto group :
             {transform_steps(), rasterization_steps(), size_steps(), lighting_steps(),
              texture_steps(), fragment_steps(), pixel_steps()})
            out.insert(out.end(), group.begin(), group.end());
        return out;
    }();
    return all;
}

/// A random program.
class Program {
public:
    Program(const Gl& gl, std::uint64_t seed) : gl_(gl), random_(seed), drawers_(3) {}

    std::vector<SeenWindow> run() {
        draw_to_another();
        for (int i = random_.between(8, 40); i > 0; --i) step();
        leave();
        for (Drawer& drawer : drawers_) {
            if (drawer.context == nullptr) continue;
            bind(drawer);
            leave();
            gl_.destroy_context(drawer.context);
        }
        return std::move(seen_);
    }

private:
    struct Drawer {
        OSMesaContext context = nullptr;
        std::vector<GLubyte> memory;
        int width = 0, height = 0;
        std::size_t window = 0;  ///< in seen_
    };

    void step() {
        const int what = random_.below(100);
        if (what < 15) return draw_to_another();
        if (what < 18) return destroy_one();
        if (what < 25) return gl_.Finish();
        Random random(random_.next());
        Results ignored;
        random_.pick(step_kinds()).play(gl_, random, ignored);
    }

    /// Another context, or the same; often of another size, and often in other memory.
    void draw_to_another() {
        leave();
        Drawer& drawer = drawers_[std::size_t(random_.below(int(drawers_.size())))];
        const bool is_new = drawer.context == nullptr;
        if (is_new) drawer.context = gl_.create_context(OSMESA_RGBA, 24, 8, 16, nullptr);
        if (is_new || random_.chance(40)) {
            const int width = random_.pick({1, 10, 20, 48, 48, 65});
            resize(drawer, width, random_.pick({3, 5, 10, 40, 40, 66}));
        }
        if (random_.chance(30)) drawer.memory = std::vector<GLubyte>(drawer.memory.size());
        bind(drawer);
    }
    void resize(Drawer& drawer, int width, int height) {
        drawer.memory.assign(std::size_t(4 * width * height), 0);
        if (width == drawer.width && height == drawer.height) return;
        drawer.width = width;
        drawer.height = height;
        drawer.window = seen_.size();
        seen_.push_back({width, height, {}});
    }
    void bind(Drawer& drawer) {
        if (!gl_.make_current(drawer.context, drawer.memory.data(), GL_UNSIGNED_BYTE, drawer.width,
                              drawer.height))
            throw std::runtime_error("the context cannot be made current");
        current_ = &drawer;
    }
    /// Before another context, size or memory. Often the program looks at what it has drawn.
    void leave() {
        if (current_ == nullptr) return;
        std::vector<GLubyte>& pixels = seen_[current_->window].pixels;
        pixels.clear();
        if (random_.chance(70)) {
            gl_.Finish();
            pixels = current_->memory;
        }
        current_ = nullptr;
    }
    void destroy_one() {
        Drawer& drawer = *current_;
        leave();
        gl_.destroy_context(drawer.context);
        drawer = {};
        draw_to_another();
    }

    const Gl& gl_;
    Random random_;
    std::vector<Drawer> drawers_;
    Drawer* current_ = nullptr;
    std::vector<SeenWindow> seen_;
};

void write_numbers(std::ostream& out, std::initializer_list<std::size_t> numbers) {
    for (const std::size_t number : numbers) out << number << ' ';
}

/// The program of a new process: draws, and writes what it saw.
int draw(const std::string& library, std::uint64_t seed, const std::string& file) {
    const Gl gl = load(library);
    std::ofstream out(file);
    for (const SeenWindow& window : Program(gl, seed).run()) {
        write_numbers(
            out, {std::size_t(window.width), std::size_t(window.height), window.pixels.size()});
        for (const GLubyte byte : window.pixels) write_numbers(out, {byte});
    }
    return out ? 0 : 1;
}

std::vector<SeenWindow> read_seen(const std::string& file) {
    std::ifstream in(file);
    std::vector<SeenWindow> out;
    SeenWindow window;
    for (std::size_t size = 0; in >> window.width >> window.height >> size;) {
        window.pixels.resize(size);
        for (GLubyte& byte : window.pixels) {
            int value = 0;
            in >> value;
            byte = GLubyte(value);
        }
        out.push_back(window);
    }
    return out;
}

/// Runs this program as `draw LIBRARY SEED FILE`, recorded to `recording`. Returns its exit code.
int record(const std::string& library, std::uint64_t seed, const std::string& file,
           const std::string& recording) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        setenv("GW_RECORD", recording.c_str(), 1);
        alarm(60);
        const std::string number = std::to_string(seed);
        execl("/proc/self/exe", "draw", "draw", library.c_str(), number.c_str(), file.c_str(),
              nullptr);
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Planes replayed(Machine& machine, const inspect::Recording& recording) {
    for (const CommandList& list : recording.lists) machine.execute(list);
    return machine.planes();
}

/// Why a window of the recording is not the program's; empty: it is.
std::string difference(const SeenWindow& seen, const inspect::Recording& recording) {
    const int width = recording.width, height = recording.height;
    if (width != seen.width || height != seen.height)
        return fmt::format("{} x {}; the program's is {} x {}", width, height, seen.width,
                           seen.height);
    const auto reference = make_reference(recording.profile, width, height),
               fast = make_fast(recording.profile, width, height);
    const Planes planes = replayed(*reference, recording);
    if (planes != replayed(*fast, recording)) return "the machines differ";
    for (std::size_t i = 0; i < seen.pixels.size(); ++i)
        if (planes.color[i / 4][i % 4] != seen.pixels[i])
            return fmt::format("pixel {} {}, channel {}: {}; the program got {}",
                               i / 4 % std::size_t(width), i / 4 / std::size_t(width), i % 4,
                               planes.color[i / 4][i % 4], seen.pixels[i]);
    return "";
}

/// Why the recording of a program is wrong; empty: it is right. Counts the windows and those seen.
std::string wrong_recording(const std::string& library, std::uint64_t seed,
                            const std::string& folder, std::size_t& windows, std::size_t& looked) {
    const std::string file = folder + "/seen.txt", recording = folder + "/recording.gwt";
    if (const int code = record(library, seed, file, recording); code != 0)
        return fmt::format("the program ended with {}", code);
    const std::vector<SeenWindow> seen = read_seen(file);
    const inspect::Stream stream = inspect::read_recordings(recording);
    if (!stream.cut.empty()) return stream.cut;
    if (stream.windows.size() != seen.size())
        return fmt::format("{} windows; the program's are {}", stream.windows.size(), seen.size());
    windows += seen.size();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        looked += seen[i].pixels.empty() ? 0 : 1;
        const std::string found = difference(seen[i], stream.windows[i].recording);
        if (!found.empty()) return fmt::format("window '{}': {}", stream.windows[i].name, found);
    }
    return "";
}

int check(const std::string& library, std::uint64_t first, std::uint64_t end,
          const std::string& folder) {
    std::filesystem::create_directories(folder);
    std::size_t windows = 0, looked = 0;
    int wrong = 0;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        std::string found;
        try {
            found = wrong_recording(library, seed, folder, windows, looked);
        } catch (const std::exception& error) {
            found = error.what();
        }
        if (found.empty()) continue;
        ++wrong;
        fmt::print("program {}: {}\n", seed, found);
    }
    fmt::print("{} programs, {} windows, {} of them seen by the program; {} recordings are wrong\n",
               end - first, windows, looked, wrong);
    return wrong == 0 && looked > 0 ? 0 : 3;
}

}  // namespace
}  // namespace gw::gl_peer

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    try {
        if (arguments.size() == 4 && arguments[0] == "draw")
            return gw::gl_peer::draw(arguments[1], std::stoull(arguments[2]), arguments[3]);
        if (arguments.size() == 4)
            return gw::gl_peer::check(arguments[0], std::stoull(arguments[1]),
                                      std::stoull(arguments[2]), arguments[3]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gw-gl-recordings: {}\n", error.what());
        return 1;
    }
    fmt::print(stderr, "usage: gw-gl-recordings LIBRARY FIRST END FOLDER\n");
    return 2;
}
