#include "gl/record/statistics.h"

#include "gl/drawable/drawable.h"
#include "gw/error.h"
#include "inspect/text/plural.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace gw::gl {

namespace {

#ifdef _WIN32
constexpr int own_bytes = O_BINARY | O_NOINHERIT;
#else
constexpr int own_bytes = O_CLOEXEC;
#endif

constexpr const char* cause_names[cause_count] = {"",
                                                  "flush",
                                                  "pixels read",
                                                  "pixels copied",
                                                  "context switch",
                                                  "texture replaced",
                                                  "query answered",
                                                  "frame too large"};

std::string row(const std::string& name, const Spread& spread, std::uint64_t frames, int digits) {
    return fmt::format("{:<26}{:>14.{}f}{:>14.{}f}{:>14.{}f}\n", name, spread.least, digits,
                       spread.sum / double(frames), std::max(digits, 1), spread.most, digits);
}

double rate(std::uint64_t frames, double seconds) {
    return double(frames) / std::max(seconds, 1e-9);
}

/// "an estimated 24.0 (6.0 to 48.0)" frames a second.
std::string estimated_rate(std::uint64_t frames, const Estimate& estimate) {
    if (estimate.seconds == 0) return "no estimate";
    return fmt::format("an estimated {:.1f} ({:.1f} to {:.1f})", rate(frames, estimate.seconds),
                       rate(frames, estimate.most), rate(frames, estimate.least));
}

}  // namespace

void Spread::add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
    sum += value;
}

Statistics::Statistics(const std::string& file, const FrameRange& frames)
    : file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | own_bytes, 0666)), range_(frames) {
    if (file_ < 0)
        throw Error(std::string("expected a file that can be written (") + std::strerror(errno) +
                    ")");
}

Statistics::~Statistics() { ::close(file_); }

void Statistics::begin_frame(Drawable& drawable) {
    if (!range_.holds(drawable.frame())) return;
    open_.try_emplace(&drawable).first->second.begin = Clock::now();
    if (begin_ == Clock::time_point{}) begin_ = Clock::now();
}

void Statistics::executed(Drawable& drawable, const Execution& execution) {
    const auto frame = open_.find(&drawable);
    if (frame == open_.end()) return;
    frame->second.counters += execution.counters;
    ++frame->second.executions[std::size_t(execution.cause)];
}

void Statistics::end_frame(Drawable& drawable) {
    const auto frame = open_.find(&drawable);
    if (frame == open_.end()) return;
    add(frame->second, Clock::now());
    open_.erase(frame);
    write();
}

void Statistics::close(Drawable& drawable) { open_.erase(&drawable); }

void Statistics::add(const Frame& frame, Clock::time_point end) {
    ++frames_;
    end_ = end;
    milliseconds_.add(std::chrono::duration<double, std::milli>(end - frame.begin).count());
    const Estimate estimate = estimated_on_vgx(frame.counters);
    estimate_ += estimate;
    estimated_.add(estimate.seconds * 1000);
    draws_.add(double(frame.counters.draws));
    vertices_.add(double(frame.counters.vertices));
    fragments_.add(double(frame.counters.fragments));
    written_.add(double(frame.counters.written));
    for (std::size_t i = 0; i < causes_.size(); ++i) causes_[i].add(double(frame.executions[i]));
}

std::string Statistics::text() const {
    const double seconds = std::chrono::duration<double>(end_ - begin_).count();
    const std::string frames = inspect::plural(frames_, "frame", "frames");
    std::string out = fmt::format("{} in {:.3f} s, {:.1f} frames a second\n", frames, seconds,
                                  rate(frames_, seconds));
    out += fmt::format("{:<26}{:>14}{:>14}{:>14}\n", "per frame", "least", "mean", "most");
    out += row("milliseconds", milliseconds_, frames_, 3);
    out += row("estimated on a VGX, ms", estimated_, frames_, 3);
    out += row("draws", draws_, frames_, 0);
    out += row("vertices", vertices_, frames_, 0);
    out += row("fragments", fragments_, frames_, 0);
    out += row("fragments written", written_, frames_, 0);
    for (std::size_t i = 1; i < causes_.size(); ++i)
        if (causes_[i].most > 0)
            out += row(std::string("barriers: ") + cause_names[i], causes_[i], frames_, 0);
    out += fmt::format("{}: {:.1f} frames a second here, {} on an {}\n", frames,
                       rate(frames_, seconds), estimated_rate(frames_, estimate_),
                       estimated_machine());
    return out;
}

/// A reader may find the text of two frames mixed while the program runs, never afterwards.
void Statistics::write() const {
    const std::string result = text();
    ::lseek(file_, 0, SEEK_SET);
    if (::write(file_, result.data(), unsigned(result.size())) == ssize_t(result.size()))
        static_cast<void>(::ftruncate(file_, off_t(result.size())) == 0);
}

}  // namespace gw::gl
