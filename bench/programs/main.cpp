// Runs one program in a window of X11 and prints how long its frames took. Which OpenGL it draws
// with is the loader's choice: scripts/compare-peers programs runs it on both.
#include "bench/programs/program.h"
#include "bench/programs/window.h"

#include <CLI/CLI.hpp>

#include <sys/resource.h>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace gw::bench {

std::vector<Program> all_programs() {
    std::vector<Program> all;
    for (const auto& some : {vertex_programs(), list_programs(), texture_programs(),
                             fragment_programs(), pixel_programs()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

namespace {

double seconds_of_processor() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The back buffer as PPM.
void save_picture(const std::string& path) {
    std::vector<unsigned char> rgb(std::size_t(window_width * window_height * 3));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, window_width, window_height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error(path + ": cannot be written");
    std::fprintf(file, "P6\n%d %d\n255\n", window_width, window_height);
    std::fwrite(rgb.data(), 1, rgb.size(), file);
    std::fclose(file);
}

/// Prints seconds of wall time, seconds of processor time, and frames.
void run(const Program& program, int frames, const std::string& picture, const Window& window) {
    constexpr int untimed = 5;
    program.begin();
    for (int i = 0; i < untimed; ++i) program.draw(i), window.swap();
    glFinish();
    window.wait();

    const auto begin = std::chrono::steady_clock::now();
    const double processor = seconds_of_processor();
    for (int i = 0; i < frames; ++i) program.draw(untimed + i), window.swap();
    glFinish();
    window.wait();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    std::printf("%.6f %.6f %d %s\n", wall.count(), seconds_of_processor() - processor, frames,
                reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(program.name + " has OpenGL's error " + std::to_string(error));
    if (picture.empty()) return;
    program.draw(untimed + frames);
    save_picture(picture);
}

int run_command(int argc, char** argv) {
    std::string name, picture;
    int width = 640, height = 480, frames = 0;
    CLI::App app{"Times a small program's frames of OpenGL 1.1."};
    app.add_option("name", name, "the program; without it, all are listed");
    app.add_option("--width", width)->check(CLI::Range(16, 4096));
    app.add_option("--height", height)->check(CLI::Range(16, 4096));
    app.add_option("--frames", frames, "as many as are timed; 0: the program's own number");
    app.add_option("--picture", picture, "a PPM file for the last frame");
    CLI11_PARSE(app, argc, argv);
    for (const Program& program : all_programs()) {
        if (name.empty()) std::printf("%-10s %s\n", program.name.c_str(), program.what.c_str());
        if (name != program.name) continue;
        const Window window(width, height);
        run(program, frames > 0 ? frames : program.frames, picture, window);
        return 0;
    }
    if (name.empty()) return 0;
    std::fprintf(stderr, "bench_programs: no program '%s'\n", name.c_str());
    return 2;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    try {
        return gw::bench::run_command(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_programs: %s\n", error.what());
        return 1;
    }
}
