#include "gl/record/recorder.h"

#include "gl/context/frame_log.h"
#include "gl/context/settings.h"
#include "gw/error.h"
#include "inspect/recording/stream.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <utility>

namespace gw::gl {

namespace {

inspect::Recording heading(const Profile& profile) {
    inspect::Recording out;
    out.producer = "gw gl";
    out.profile = profile;
    return out;
}

/// Writes each list before the program goes on. If the disk is full, it says so once and stops;
/// the program does not.
class Recorder : public FrameLog {
public:
    Recorder(std::string file, const Profile& profile)
        : file_(std::move(file)),
          out_(file_, std::ios::binary),
          writer_((check_is_open(), out_), heading(profile)) {}
    ~Recorder() override {
        attempt([&] { writer_.finish(); });
    }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void open(const std::string& window, int width, int height) override {
        attempt([&] { writer_.open(window, width, height); });
    }
    void add(const std::string& window, const CommandList& list) override {
        attempt([&] { writer_.add(window, list); });
    }
    void close(const std::string& window) override {
        attempt([&] { writer_.close(window); });
    }

private:
    void check_is_open() const {
        if (!out_)
            throw Error("GW_RECORD is '" + file_ + "'; expected a file that can be written (" +
                        std::strerror(errno) + ")");
    }
    template <class Write>
    void attempt(Write write) {
        const std::lock_guard lock(mutex_);
        if (failed_) return;
        try {
            write();
            if (!out_) throw Error("cannot write " + file_ + ": " + std::strerror(errno));
        } catch (const std::exception& error) {
            failed_ = true;
            std::fprintf(stderr, "gw: recording stopped: %s\n", error.what());
        }
    }

    std::string file_;
    std::ofstream out_;
    inspect::StreamWriter writer_;
    std::mutex mutex_;
    bool failed_ = false;
};

}  // namespace

void start_recording() {
    static const bool started = [] {
        const char* const file = std::getenv("GW_RECORD");
        if (file != nullptr) set_frame_log(std::make_unique<Recorder>(file, settings().profile));
        return true;
    }();
    static_cast<void>(started);
}

}  // namespace gw::gl
