// Preloaded into a program that was not written for us: ends it after some frames and writes what they
// took to the file of FRAME_METER, as bench_programs prints it. Counts the calls of glXSwapBuffers and
// eglSwapBuffers that the loader binds; a program that looks them up by name is not counted.
#include <dlfcn.h>
#include <sys/resource.h>
#include <unistd.h>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr int untimed = 10;

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

void count_frame() {
    using Clock = std::chrono::steady_clock;
    static int frames = 0;
    static Clock::time_point begin;
    static double processor = 0;
    static const char* const wanted = std::getenv("FRAME_METER_FRAMES");
    static const int last = wanted != nullptr ? std::atoi(wanted) : 100;
    if (++frames == untimed) {
        begin = Clock::now();
        processor = seconds_of_process();
    }
    if (frames < untimed + last) return;
    const std::chrono::duration<double> wall = Clock::now() - begin;
    const char* const path = std::getenv("FRAME_METER");
    std::FILE* const file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) _exit(1);
    const auto get_string = next_function<const unsigned char* (*)(unsigned)>("glGetString");
    const unsigned char* const renderer = get_string != nullptr ? get_string(0x1F01) : nullptr;
    std::fprintf(file, "%.6f %.6f %d %s\n", wall.count(), seconds_of_process() - processor, last,
                 renderer != nullptr ? reinterpret_cast<const char*>(renderer) : "unknown");
    std::fclose(file);
    _exit(0);
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void glXSwapBuffers(void* display, unsigned long drawable) {
    static const auto next = next_function<void (*)(void*, unsigned long)>("glXSwapBuffers");
    next(display, drawable);
    count_frame();
}

__attribute__((visibility("default"))) unsigned eglSwapBuffers(void* display, void* surface) {
    static const auto next = next_function<unsigned (*)(void*, void*)>("eglSwapBuffers");
    const unsigned result = next(display, surface);
    count_frame();
    return result;
}

}  // extern "C"
