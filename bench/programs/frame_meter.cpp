// Preloaded into a program that was not written for us: ends it after some frames and writes what they
// took to the file of FRAME_METER, as bench_programs prints it, and the last frame's pixels to that of
// FRAME_METER_PICTURE. Counts the calls of glXSwapBuffers and eglSwapBuffers that the loader binds; a
// program that looks them up by name is not counted. The program sees a clock that a frame moves by
// 1/30 s, and always the same process number. So what it shows at random is the same each time.
#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr int untimed = 10;

/// Microseconds of the program's clock. A look at it takes one, so that no program waits for ever.
std::atomic<long long> program_clock = 1'000'000'000LL * 1'000'000;

template <class Function>
Function next_function(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

double seconds_of_process() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::FILE* file_of(const char* variable) {
    const char* const path = std::getenv(variable);
    return path != nullptr ? std::fopen(path, "wb") : nullptr;
}

/// Writes the back buffer where the viewport is, as a PPM file.
void write_picture() {
    const auto get_integers = next_function<void (*)(unsigned, int*)>("glGetIntegerv");
    const auto read_pixels =
        next_function<void (*)(int, int, int, int, unsigned, unsigned, void*)>("glReadPixels");
    const auto pixel_store = next_function<void (*)(unsigned, int)>("glPixelStorei");
    constexpr unsigned viewport = 0x0BA2, pack_alignment = 0x0D05, rgb = 0x1907, bytes = 0x1401;
    std::FILE* const file = file_of("FRAME_METER_PICTURE");
    if (file == nullptr) return;
    int at[4] = {};
    get_integers(viewport, at);
    const std::size_t row = 3 * std::size_t(at[2]);
    std::vector<unsigned char> pixels(row * std::size_t(at[3]));
    pixel_store(pack_alignment, 1);
    read_pixels(at[0], at[1], at[2], at[3], rgb, bytes, pixels.data());
    std::fprintf(file, "P6\n%d %d\n255\n", at[2], at[3]);
    for (int y = at[3] - 1; y >= 0; --y)
        std::fwrite(pixels.data() + std::size_t(y) * row, 1, row, file);
    std::fclose(file);
}

/// Call before the buffers are exchanged, so that the picture is that of a frame.
void count_frame() {
    using Clock = std::chrono::steady_clock;
    static int frames = 0;
    static Clock::time_point begin;
    static double processor = 0;
    static const char* const wanted = std::getenv("FRAME_METER_FRAMES");
    static const int last = wanted != nullptr ? std::atoi(wanted) : 100;
    program_clock += 1'000'000 / 30;
    if (frames++ == untimed) {
        begin = Clock::now();
        processor = seconds_of_process();
    }
    if (frames <= untimed + last) return;
    const std::chrono::duration<double> wall = Clock::now() - begin;
    const double used = seconds_of_process() - processor;
    write_picture();
    std::FILE* const file = file_of("FRAME_METER");
    if (file == nullptr) _exit(1);
    const auto get_string = next_function<const unsigned char* (*)(unsigned)>("glGetString");
    const unsigned char* const renderer = get_string != nullptr ? get_string(0x1F01) : nullptr;
    std::fprintf(file, "%.6f %.6f %d %s\n", wall.count(), used, last,
                 renderer != nullptr ? reinterpret_cast<const char*>(renderer) : "unknown");
    std::fclose(file);
    _exit(0);
}

}  // namespace

extern "C" {

#define GW_EXPORTED __attribute__((visibility("default")))

GW_EXPORTED void glXSwapBuffers(void* display, unsigned long drawable) {
    static const auto next = next_function<void (*)(void*, unsigned long)>("glXSwapBuffers");
    count_frame();
    next(display, drawable);
}

GW_EXPORTED unsigned eglSwapBuffers(void* display, void* surface) {
    static const auto next = next_function<unsigned (*)(void*, void*)>("eglSwapBuffers");
    count_frame();
    return next(display, surface);
}

GW_EXPORTED int gettimeofday(timeval* time, void*) {
    const long long now = ++program_clock;
    *time = {now / 1'000'000, now % 1'000'000};
    return 0;
}

GW_EXPORTED time_t time(time_t* time) {
    const time_t now = ++program_clock / 1'000'000;
    if (time != nullptr) *time = now;
    return now;
}

GW_EXPORTED pid_t getpid() { return 1991; }

}  // extern "C"
