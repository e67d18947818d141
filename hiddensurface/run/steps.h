// The step log: an algorithm's comparisons, decisions, splits and draws, in order. Replay rebuilds
// the picture and the list's order after every step from the log alone. Does not draw.
#pragma once

#include "hiddensurface/model/grid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gw::hiddensurface {

/// The detail of a log; each level includes the ones before it.
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
    std::vector<std::uint32_t> polygons;  ///< their identifiers; of a Sort, the whole order
    std::string test;                     ///< "x extents", "behind the plane", "D_f", ...
    std::string result;                   ///< "disjoint", "behind", "swapped", ...
    int row = -1;                         ///< the scan line; -1: none
    std::vector<Painted> painted;         ///< Draw only: all changes of the picture
    std::vector<Loop> before, behind;     ///< Split only: the pieces, in grid units
    Rect window{};                        ///< the pixels in question; width 0: none
    bool operator==(const Step&) const = default;
};

class StepLog {
public:
    /// Records nothing.
    StepLog() = default;
    explicit StepLog(Level finest) : on_(true), finest_(finest) {}

    bool on() const { return on_; }
    bool wants(Level level) const { return on_ && level <= finest_; }
    /// Records Draw steps at any level, others if they are wanted.
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

/// A step log played forwards and backwards.
class Replay {
public:
    Replay(std::vector<Step> steps, int width, int height);

    std::size_t size() const { return steps_.size(); }
    /// The number of steps done: 0 .. size().
    std::size_t position() const { return undo_.size(); }
    const Step& step(std::size_t i) const { return steps_[i]; }
    /// Identifiers after the steps done, bottom row first.
    const std::vector<std::uint32_t>& ids() const { return ids_; }
    /// Identifiers in the order of the last Sort; empty before the first.
    const std::vector<std::uint32_t>& order() const { return order_; }

    void forward();
    void backward();
    void go_to(std::size_t position);

private:
    struct Undo {
        std::vector<std::uint32_t> ids;    ///< of the pixels painted, in the order painted
        std::vector<std::uint32_t> order;  ///< of a Sort
    };
    template <class Change>
    void for_painted(const Step& step, const Change& change);

    std::vector<Step> steps_;
    std::vector<std::uint32_t> ids_, order_;
    std::vector<Undo> undo_;
    int width_ = 0;
};

}  // namespace gw::hiddensurface
