// gw-gl-fuzz: random programs of OpenGL 1.1 on two libraries of OSMesa, compared after every step.
// Each program runs in a process of its own, so that a library that ends it is found too.
// Exit 0: differences are within the bounds; 1: an error; 2: usage; 3: a difference or a crash.
#include "tests/gl/peer/steps.h"
#include "tests/gl/peer/trace.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <stdexcept>
#include <string_view>

namespace gw::gl_peer {
namespace {

struct Suite {
    const char* name;
    std::vector<std::span<const StepKind>> states;
    std::vector<StepKind> draws;
};

const std::vector<Suite>& suites() {
    static const std::vector<Suite> all{
        {"shapes", {transform_steps(), rasterization_steps()}, {{"shape", draw_shape}}},
        {"sizes", {size_steps()}, {{"inner shape", draw_inner_shape}}},
        {"lights", {transform_steps(), lighting_steps()}, {{"lit shape", draw_lit_shape}}},
        {"textures",
         {texture_steps(), texture_steps(), transform_steps()},
         {{"textured shape", draw_textured_shape}, {"read texture", read_texture}}},
        {"units", {unit_steps()}, {{"shape", draw_shape}}},
        {"fragments", {fragment_steps()}, {{"shape", draw_shape}}},
        {"surfaces", {transform_steps()}, {{"surface", draw_surface}}},
        {"rectangles",
         {pixel_steps()},
         {{"rectangle", draw_rectangle}, {"copy", draw_copy}, {"read", read_rectangle}}},
        // Mesa copies to textures without transfer.
        {"copies",
         {texture_steps(), transform_steps()},
         {{"copy to texture", copy_to_texture}, {"rectangle", draw_rectangle}}},
        {"accumulation", {transform_steps()}, {{"accumulation", accumulate}}},
        {"feedback", {transform_steps(), rasterization_steps()}, {{"feedback", feed_back}}},
        {"selection", {transform_steps(), rasterization_steps()}, {{"selection", select}}},
        {"queries",
         {transform_steps(), rasterization_steps(), lighting_steps(), texture_steps(),
          fragment_steps(), pixel_steps()},
         {{"queries", ask}}}};
    return all;
}

struct Step {
    StepKind kind;
    std::uint64_t seed;
};

/// Each program ends with a step that draws.
std::vector<Step> make_program(const Suite& suite, std::uint64_t index) {
    std::uint64_t seed = index;
    for (const char c : std::string_view(suite.name)) seed = seed * 1000003 + std::uint64_t(c);
    Random random(seed);
    std::vector<Step> out;
    for (int i = random.between(4, 14); i > 0; --i) {
        const auto& group = suite.states[std::size_t(random.below(int(suite.states.size())))];
        const bool draws = i == 1 || random.chance(25);
        const StepKind kind =
            draws ? random.pick(suite.draws) : group[std::size_t(random.below(int(group.size())))];
        out.push_back({kind, random.next()});
    }
    return out;
}

/// A context of a library, and its memory.
class Window {
public:
    explicit Window(const Gl& gl) : gl_(gl), memory_(4 * window_width * window_height) {
        context_ = gl.create_context(OSMESA_RGBA, 24, 8, 16, nullptr);
        if (context_ == nullptr) throw std::runtime_error("no context");
        make_current();
        gl.Disable(GL_DITHER);
        gl.MatrixMode(GL_PROJECTION);
        gl.Ortho(-1, 1, -1, 1, 0.5, 3.5);
        gl.MatrixMode(GL_MODELVIEW);
        gl.Translatef(0, 0, -2);  // in front of the eye, where fog is the same
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
                 GL_ACCUM_BUFFER_BIT);
    }
    ~Window() { gl_.destroy_context(context_); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    const Gl& gl() const { return gl_; }
    void make_current() {
        if (!gl_.make_current(context_, memory_.data(), GL_UNSIGNED_BYTE, window_width,
                              window_height))
            throw std::runtime_error("the context cannot be made current");
    }

private:
    const Gl& gl_;
    std::vector<GLubyte> memory_;
    OSMesaContext context_ = nullptr;
};

Results played(Window& window, const Step& step) {
    window.make_current();
    Random random(step.seed);
    Results out;
    step.kind.play(window.gl(), random, out);
    return out;
}

/// What a program's process says.
struct Outcome {
    enum class Kind { Same, Different, EndedByOurs, EndedByPeer } kind = Kind::Same;
    int edge_pixels = 0, wrong_pixels = 0, pictures = 0;
    char first[400] = {};
};

void print_values(const char* library, const Results& results) {
    for (const Values& v : results.values)
        fmt::print("{} {}: {:.6g}\n", library, v.what, fmt::join(v.values, " "));
}

void run_steps(const Gl& ours, const Gl& peer, const std::vector<Step>& program, Outcome& out,
               const std::function<void()>& note) {
    Window a(ours), b(peer);
    const auto ended = [&](Outcome::Kind kind) {
        out.kind = kind;
        note();
    };
    for (const Step& step : program) {
        ended(Outcome::Kind::EndedByOurs);
        const Results mine = played(a, step);
        ended(Outcome::Kind::EndedByPeer);
        const Results theirs = played(b, step);
        const Difference d = compare(mine, theirs);
        out.edge_pixels += d.edge_pixels;
        out.wrong_pixels += d.wrong_pixels;
        out.pictures += int(mine.pictures.size());
        if (is_accepted(d)) continue;
        fmt::format_to_n(out.first, sizeof out.first - 1, "{}: {}", step.kind.name, d.first);
        return ended(Outcome::Kind::Different);
    }
    ended(Outcome::Kind::Same);
}

/// Runs a program in a new process.
Outcome run_program(const Gl& ours, const Gl& peer, const std::vector<Step>& program) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        close(ends[0]);
        Outcome out;
        const auto note = [&] {
            if (write(ends[1], &out, sizeof out) != ssize_t(sizeof out)) _exit(1);
        };
        alarm(60);
        run_steps(ours, peer, program, out, note);
        _exit(0);
    }
    close(ends[1]);
    Outcome out, next;
    out.kind = Outcome::Kind::EndedByOurs;
    while (read(ends[0], &next, sizeof next) == ssize_t(sizeof next)) out = next;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return out;
}

/// Leaves out what can be left out of a program that fails.
std::vector<Step> shrunk(const Gl& ours, const Gl& peer, std::vector<Step> program) {
    const Outcome::Kind kind = run_program(ours, peer, program).kind;
    for (std::size_t i = 0; i < program.size();) {
        std::vector<Step> less = program;
        less.erase(less.begin() + std::ptrdiff_t(i));
        if (run_program(ours, peer, less).kind == kind)
            program = std::move(less);
        else
            ++i;
    }
    return program;
}

/// The calls, and the numbers that both libraries gave. The pictures' calls are left out. In a new
/// process: a library's threads would not be in those that are made later.
void print_program(const Gl& ours, const Gl& peer, const std::vector<Step>& program) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child > 0) return void(waitpid(child, nullptr, 0));
    const Gl calls = traced(ours);
    Window a(calls), b(peer);
    for (const Step& step : program) {
        fmt::print("{}:\n", step.kind.name);
        print_values("first", played(a, step));
        print_values("second", played(b, step));
    }
    std::fflush(stdout);
    _exit(0);
}

struct Arguments {
    std::vector<std::string> suites;
    std::vector<std::uint64_t> range{0, 20};
    std::string ours, peer = GW_OSMESA_LIBRARY;
    bool shrinks = false, prints = false, keeps_going = false;
};

void print_failure(const Arguments& arguments, const Suite& suite, std::uint64_t index,
                   const Gl& ours, const Gl& peer, Outcome outcome) {
    std::vector<Step> program = make_program(suite, index);
    if (arguments.shrinks) {
        program = shrunk(ours, peer, program);
        outcome = run_program(ours, peer, program);
    }
    const char* const kinds[] = {"same", "differs", "ended in the first library",
                                 "ended in the second library"};
    fmt::print("{} {}: {}; {}\n", suite.name, index, kinds[std::size_t(outcome.kind)],
               outcome.first);
    fmt::print("    steps:");
    for (const Step& step : program) fmt::print(" {},", step.kind.name);
    fmt::print("\n");
    if (arguments.prints) print_program(ours, peer, program);
}

int run_suite(const Arguments& arguments, const Suite& suite, const Gl& ours, const Gl& peer) {
    int failed = 0, pictures = 0, edges = 0, others = 0;
    for (std::uint64_t i = arguments.range[0]; i < arguments.range[1]; ++i) {
        const Outcome outcome = run_program(ours, peer, make_program(suite, i));
        pictures += outcome.pictures;
        edges += outcome.edge_pixels;
        others += outcome.wrong_pixels;
        if (outcome.kind == Outcome::Kind::Same) continue;
        ++failed;
        print_failure(arguments, suite, i, ours, peer, outcome);
        if (!arguments.keeps_going) break;
    }
    fmt::print(
        "{:14} {} programs, {} pictures, {} pixels of edges and {} others differ; {} programs "
        "differ\n",
        suite.name, arguments.range[1] - arguments.range[0], pictures, edges, others, failed);
    std::fflush(stdout);
    return failed;
}

int run(const Arguments& arguments) {
    const Gl ours = load(arguments.ours), peer = load(arguments.peer);
    if (ours.Begin == peer.Begin) throw std::runtime_error("both libraries are the same");
    int failed = 0;
    for (const Suite& suite : suites())
        if (arguments.suites.empty() || std::find(arguments.suites.begin(), arguments.suites.end(),
                                                  suite.name) != arguments.suites.end())
            failed += run_suite(arguments, suite, ours, peer);
    return failed > 0 ? 3 : 0;
}

}  // namespace
}  // namespace gw::gl_peer

int main(int argc, char** argv) {
    CLI::App app(
        "Random programs of OpenGL 1.1 on two libraries of OSMesa, compared after every step.\n"
        "Example: gw-gl-fuzz lib/opengl/libOSMesa.so.8 --suite shapes --range 0 1000");
    gw::gl_peer::Arguments arguments;
    app.add_option("library", arguments.ours, "the libOSMesa to test")->required();
    app.add_option("--peer", arguments.peer, "the libOSMesa to compare with; default Mesa's");
    app.add_option("--suite", arguments.suites, "suites, by name; default all");
    app.add_option("--range", arguments.range, "programs LO to HI - 1; default 0 20")->expected(2);
    app.add_flag("--shrink", arguments.shrinks,
                 "leave out of failing programs what can be left out");
    app.add_flag("--print", arguments.prints,
                 "print the calls and the numbers of programs that differ");
    app.add_flag("--all", arguments.keeps_going, "go on after a program that differs");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        return gw::gl_peer::run(arguments);
    } catch (const std::exception& e) {
        fmt::print(stderr, "gw-gl-fuzz: {}\n", e.what());
        return 1;
    }
}
