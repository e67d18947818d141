#include "gl/record/recorder.h"

#include "gl/context/drawable.h"
#include "gl/context/settings.h"
#include "gl/record/recording.h"
#include "gl/record/screenshot.h"
#include "gl/record/statistics.h"
#include "gw/error.h"

#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gw::gl {

namespace {

/// Tells all listeners, one call at a time. After the last frame of GW_FRAMES it ends the program.
class Listeners : public FrameLog {
public:
    Listeners(std::vector<std::unique_ptr<FrameLog>> listeners, std::uint64_t last)
        : listeners_(std::move(listeners)), last_(last) {}

    void open(Drawable& drawable) override {
        const std::lock_guard lock(mutex_);
        for (const auto& l : listeners_) l->open(drawable);
    }
    void begin_frame(Drawable& drawable) override {
        const std::lock_guard lock(mutex_);
        for (const auto& l : listeners_) l->begin_frame(drawable);
    }
    void executed(Drawable& drawable, const Execution& execution) override {
        const std::lock_guard lock(mutex_);
        for (const auto& l : listeners_) l->executed(drawable, execution);
    }
    void end_frame(Drawable& drawable) override {
        const std::lock_guard lock(mutex_);
        for (const auto& l : listeners_) l->end_frame(drawable);
        if (drawable.frame() == last_) end_program();
    }
    void close(Drawable& drawable) override {
        const std::lock_guard lock(mutex_);
        for (const auto& l : listeners_) l->close(drawable);
    }

private:
    /// Without the program's exit handlers: they may draw, or wait for threads that draw. The lock
    /// stops those meanwhile.
    [[noreturn]] void end_program() {
        listeners_.clear();
        std::fflush(stdout);
        std::fflush(stderr);
        ::_exit(0);
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<FrameLog>> listeners_;
    std::uint64_t last_;
};

/// Adds what `make` makes of the variable's value, if it is set.
template <class Make>
void add_listener(std::vector<std::unique_ptr<FrameLog>>& to, const char* variable, Make make) {
    const char* const value = std::getenv(variable);
    if (value == nullptr) return;
    try {
        to.push_back(make(value));
    } catch (const Error& error) {
        report_ignored(variable, value, error.what());
    }
}

void start() {
    const FrameRange frames = read_frame_range();
    std::vector<std::unique_ptr<FrameLog>> all;
    add_listener(all, "GW_RECORD", [&](const char* file) {
        auto recording = std::make_unique<Recording>(file, settings().profile, frames);
        calls_are_kept = true;
        return recording;
    });
    add_listener(all, "GW_STATS",
                 [&](const char* file) { return std::make_unique<Statistics>(file, frames); });
    add_listener(all, "GW_SCREENSHOT",
                 [&](const char* file) { return std::make_unique<Screenshot>(file, frames); });
    if (all.empty() && frames.last == FrameRange{}.last) return;
    set_frame_log(std::make_unique<Listeners>(std::move(all), frames.last));
}

}  // namespace

void start_recording() {
    static const bool started = (start(), true);
    static_cast<void>(started);
}

}  // namespace gw::gl
