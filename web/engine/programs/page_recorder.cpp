// Records frames of a running program when its page asks: gw_record. The page gets the recording as a
// file. Compiled by Emscripten alone.
#include "gl/drawable/drawable.h"
#include "gl/drawable/frame_log.h"
#include "gl/record/recording.h"
#include "gw/error.h"

#include <emscripten.h>

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>

// The page reads the file.
EM_JS(void, gw_recorded, (const char* file), { Module.screen.recorded(UTF8ToString(file)); });

namespace gw::gl {
namespace {

constexpr const char* file = "/tmp/recording.gwt";

/// Planes above or below a window: they are recorded with it.
bool are_aside(const Drawable& drawable) {
    return drawable.shown_indices().planes != IndexPlanes::Window;
}

class PageRecorder : public FrameLog {
public:
    /// From the next frame on; a recording that is not ready begins again.
    void ask(std::uint64_t frames) {
        recording_ = nullptr;
        ended_.clear();
        wanted_ = frames;
        calls_are_kept = true;
    }

    void open(Drawable& drawable) override {
        if (recording_) recording_->open(drawable);
    }
    void begin_frame(Drawable& drawable) override {
        if (wanted_ != 0 && !recording_ && !are_aside(drawable)) begin(drawable.profile());
        if (!recording_) return;
        ended_.try_emplace(drawable.name(), 0);
        recording_->begin_frame(drawable);
    }
    void executed(Drawable& drawable, const Execution& execution) override {
        if (recording_) recording_->executed(drawable, execution);
    }
    void end_frame(Drawable& drawable) override {
        const auto ended = ended_.find(drawable.name());
        if (!recording_ || ended == ended_.end()) return;
        recording_->end_frame(drawable);
        if (++ended->second == wanted_ && !are_aside(drawable)) finish();
    }
    void close(Drawable& drawable) override {
        if (recording_) recording_->close(drawable);
    }

private:
    void begin(const Profile& profile) {
        try {
            recording_ = std::make_unique<Recording>(file, profile, FrameRange{});
        } catch (const Error& error) {
            wanted_ = 0;
            std::fprintf(stderr, "gw: %s\n", error.what());
        }
    }
    void finish() {
        recording_ = nullptr;
        wanted_ = 0;
        gw_recorded(file);
        std::remove(file);
    }

    std::uint64_t wanted_ = 0;  ///< 0: nothing is asked for
    std::unique_ptr<Recording> recording_;
    std::map<std::string, std::uint64_t> ended_;  ///< frames of each recorded window
};

PageRecorder* recorder = nullptr;

}  // namespace
}  // namespace gw::gl

extern "C" {

/// Records the next frames, until one window has shown so many. Returns 0 if GW_RECORD, GW_STATS or
/// GW_SCREENSHOT listens already.
EMSCRIPTEN_KEEPALIVE int gw_record(int frames) {
    using namespace gw::gl;
    if (recorder == nullptr) {
        if (frame_log() != nullptr) return 0;
        auto made = std::make_unique<PageRecorder>();
        recorder = made.get();
        set_frame_log(std::move(made));
    }
    recorder->ask(static_cast<std::uint64_t>(frames));
    return 1;
}

}  // extern "C"
