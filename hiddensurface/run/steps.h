// The step log: what an algorithm compared, decided, split and drew, in order. From it alone every
// state can be rebuilt (hiddensurface/run/replay.h). Does not hold pictures.
#pragma once

#include "hiddensurface/model/grid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gw::hiddensurface {

/// How fine a log is; each holds the ones before it.
enum class Level { Polygon, Line, Span, Pixel };
enum class Action { Compare, Decide, Sort, Split, Draw };

/// Pixels that get a polygon's identifier.
struct Painted {
    Run run;
    std::uint32_t id = 0;
    bool operator==(const Painted&) const = default;
};

struct Step {
    Level level = Level::Polygon;
    Action action = Action::Compare;
    /// identifiers: what it is about; of a Sort, the whole order
    std::vector<std::uint32_t> polygons;
    std::string test;                  ///< "x extents", "behind the plane", "D_f", ...
    std::string result;                ///< "disjoint", "behind", "swapped", ...
    int row = -1;                      ///< the scan line, where there is one
    std::vector<Painted> painted;      ///< Draw only: all that changes in the picture
    std::vector<Loop> before, behind;  ///< Split only: the pieces, in grid units
    Rect window{};                     ///< pixels that it is about; of no width: none
    bool operator==(const Step&) const = default;
};

class StepLog {
public:
    /// Records nothing.
    StepLog() = default;
    explicit StepLog(Level finest) : on_(true), finest_(finest) {}

    bool on() const { return on_; }
    bool wants(Level level) const { return on_ && level <= finest_; }
    /// Draw steps are recorded at any level, others where they are wanted.
    void add(Step step) {
        if (wants(step.level) || (on_ && step.action == Action::Draw))
            steps_.push_back(std::move(step));
    }
    void compare(std::vector<std::uint32_t> polygons, const char* test, const char* result) {
        if (on_) add({Level::Polygon, Action::Compare, std::move(polygons), test, result});
    }
    const std::vector<Step>& steps() const { return steps_; }

private:
    bool on_ = false;
    Level finest_ = Level::Polygon;
    std::vector<Step> steps_;
};

/// One line of JSON, without its end.
std::string to_json(const Step& step);
/// The step of a line that to_json wrote. Throws Error "what; expected what".
Step step_from_json(const std::string& line);

const char* name_of(Level level);
const char* name_of(Action action);

}  // namespace gw::hiddensurface
