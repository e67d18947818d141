// Times kinds of calls and fragments on the OSMesa that the loader finds: bench_kinds. Prints the least
// milliseconds of processor time of each. scripts/compare-peers kinds runs it on both libraries.
#include "bench/kinds/kinds.h"

#include <GL/osmesa.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <ctime>
#include <random>

namespace gw::bench {

GLuint make_texture(GLenum target, GLenum min_filter) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GLint(min_filter));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return name;
}

const std::vector<unsigned char>& noise() {
    static const std::vector<unsigned char> bytes = [] {
        std::vector<unsigned char> out(16 * std::size_t{side} * side);
        std::minstd_rand random(1);
        // Below 64, so that floats made of them are numbers.
        for (unsigned char& byte : out) byte = static_cast<unsigned char>(random() >> 8 & 63);
        return out;
    }();
    return bytes;
}

namespace {

double milliseconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

void reset_matrices() {
    for (const GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(mode);
        glLoadIdentity();
    }
}

double least_time(const Kind& kind, int repeats) {
    constexpr int calls = 4;
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    kind.begin();
    double least = 1e9;
    for (int i = 0; i < repeats; ++i) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glFinish();
        const double start = milliseconds();
        for (int k = 0; k < calls; ++k) kind.draw();
        glFinish();
        least = std::min(least, (milliseconds() - start) / calls);
    }
    glPopAttrib();
    reset_matrices();
    return least;
}

/// Returns whether there is a kind of this name, or none is asked for.
bool run(const std::string& only, int repeats) {
    bool found = only.empty();
    for (const auto& kinds : {pixel_kinds(), fragment_kinds()})
        for (const Kind& kind : kinds) {
            if (!only.empty() && kind.name != only) continue;
            found = true;
            const double least = least_time(kind, repeats);
            fmt::print("{} {:.4f}\n", kind.name, least);
            if (const GLenum error = glGetError(); error != GL_NO_ERROR)
                fmt::print(stderr, "bench_kinds: {}: GL error {:#x}\n", kind.name, error);
        }
    return found;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    std::string only;
    int repeats = 10;
    CLI::App app{
        "Kinds of calls and fragments on the OSMesa of LD_LIBRARY_PATH, milliseconds of each.\n"
        "Example: bench_kinds --only combine-dot3"};
    app.add_option("--only", only, "the name of one kind");
    app.add_option("--repeats", repeats, "of which the least counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    std::vector<unsigned char> memory(4 * std::size_t{gw::bench::side} * gw::bench::side);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    if (context == nullptr || !OSMesaMakeCurrent(context, memory.data(), GL_UNSIGNED_BYTE,
                                                 gw::bench::side, gw::bench::side)) {
        fmt::print(stderr, "bench_kinds: OSMesa gives no context\n");
        return 1;
    }
    const bool found = gw::bench::run(only, repeats);
    OSMesaDestroyContext(context);
    if (found) return 0;
    fmt::print(stderr, "bench_kinds: --only '{}'; expected a name that bench_kinds prints\n", only);
    return 2;
}
