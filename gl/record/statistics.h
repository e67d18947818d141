// Counts what a program draws, frame by frame: GW_STATS names the file of the result.
#pragma once

#include "gl/drawable/frame_log.h"
#include "gl/drawable/settings.h"
#include "gl/record/estimate.h"

#include <array>
#include <chrono>
#include <limits>
#include <map>
#include <string>

namespace gw::gl {

/// The smallest, mean and largest value of all frames.
struct Spread {
    double least = std::numeric_limits<double>::infinity(), sum = 0, most = 0;
    void add(double value);
};

/// Writes the result after each frame, so that it is there however the program ends.
class Statistics : public FrameLog {
public:
    /// Throws Error if the file cannot be written.
    Statistics(const std::string& file, const FrameRange& frames);
    ~Statistics() override;
    Statistics(const Statistics&) = delete;
    Statistics& operator=(const Statistics&) = delete;

    void open(Drawable&) override {}
    void begin_frame(Drawable& drawable) override;
    void executed(Drawable& drawable, const Execution& execution) override;
    void end_frame(Drawable& drawable) override;
    void close(Drawable& drawable) override;

private:
    using Clock = std::chrono::steady_clock;
    /// A frame that is being drawn.
    struct Frame {
        Clock::time_point begin;
        Counters counters;
        std::array<std::uint64_t, cause_count> executions{};
    };

    void add(const Frame& frame, Clock::time_point end);
    std::string text() const;
    void write() const;

    int file_ = -1;
    FrameRange range_;
    std::map<const Drawable*, Frame> open_;
    std::uint64_t frames_ = 0;
    Clock::time_point begin_{}, end_{};  ///< of the first and the last frame
    Spread milliseconds_, estimated_, draws_, vertices_, fragments_, written_;
    Estimate estimate_;  ///< of all frames
    std::array<Spread, cause_count> causes_;
};

}  // namespace gw::gl
