#include "gl/record/recorder.h"

#include "gl/drawable/background.h"
#include "gl/drawable/drawable.h"
#include "gl/drawable/settings.h"
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
/// Never destroyed: other threads draw while the program ends.
class Listeners : public FrameLog {
public:
    Listeners(std::vector<std::unique_ptr<FrameLog>> listeners, std::uint64_t last)
        : listeners_(std::move(listeners)), last_(last) {}

    void open(Drawable& drawable) override {
        tell([&](FrameLog& listener) { listener.open(drawable); });
    }
    void begin_frame(Drawable& drawable) override {
        tell([&](FrameLog& listener) { listener.begin_frame(drawable); });
    }
    void executed(Drawable& drawable, const Execution& execution) override {
        tell([&](FrameLog& listener) { listener.executed(drawable, execution); });
    }
    void end_frame(Drawable& drawable) override {
        if (is_child()) return;
        const std::lock_guard lock(mutex_);
        tell([&](FrameLog& listener) { listener.end_frame(drawable); });
        if (drawable.frame() == last_) end_program();
    }
    void close(Drawable& drawable) override {
        tell([&](FrameLog& listener) { listener.close(drawable); });
    }

    /// Ends the files. A program whose signal handler exits may be in the middle of one: that one
    /// stays as it is, cut short.
    void end() {
        if (is_child()) return;
        std::unique_lock lock(mutex_, std::defer_lock);
        if (!other_threads_are_gone) lock.lock();
        if ((lock.owns_lock() || lock.try_lock()) && !tells_) listeners_.clear();
    }

private:
    /// The files are the parent's.
    bool is_child() const { return process_ != getpid(); }
    template <class Call>
    void tell(Call call) {
        if (is_child()) return;
        const std::lock_guard lock(mutex_);
        tells_ = true;
        for (const auto& listener : listeners_) call(*listener);
        tells_ = false;
    }
    /// Without the program's exit handlers: they may draw, or wait for threads that draw. The lock
    /// stops those meanwhile.
    [[noreturn]] void end_program() {
        listeners_.clear();
        std::fflush(stdout);
        std::fflush(stderr);
        ::_exit(0);
    }

    const pid_t process_ = getpid();
    std::recursive_mutex mutex_;
    bool tells_ = false;
    std::vector<std::unique_ptr<FrameLog>> listeners_;
    std::uint64_t last_;
};

Listeners* started = nullptr;

/// After the program's exit handlers, which may draw.
const struct AtExit {
    ~AtExit() {
        if (started != nullptr) started->end();
    }
} at_exit;

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
    auto listeners = std::make_unique<Listeners>(std::move(all), frames.last);
    started = listeners.get();
    set_frame_log(std::move(listeners));
}

}  // namespace

void start_recording() {
    static const bool started = (start(), true);
    static_cast<void>(started);
}

}  // namespace gw::gl
