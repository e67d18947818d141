// The step log: an algorithm's comparisons, decisions, splits and draws, in order, with the values
// that decided them. Does not draw.
#pragma once

#include "hiddensurface/model/grid.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gw::hiddensurface {

/// The detail of a log; each level includes the ones before it.
enum class Level { Polygon, Line, Span, Pixel };
enum class Action { Compare, Decide, Sort, Split, Draw };
const char* name_of(Level level);
const char* name_of(Action action);

/// Pixels that get a polygon's identifier.
struct Painted {
    Run run;
    std::uint32_t id = 0;
    bool operator==(const Painted&) const = default;
};

/// What decided a step. y counts downwards here, as in pictures; rows and Loops of a Step count
/// upwards, as in the machine.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<std::int64_t>,
                           std::vector<double>, std::vector<std::string>>;
using Values = std::vector<std::pair<std::string, Value>>;

/// A piece, named by the polygon and the cuts that made it: "3", "3a", "3ab".
struct NamedOutline {
    std::string name;
    std::vector<Loop> outline;  ///< in grid units
    bool operator==(const NamedOutline&) const = default;
};

/// A line and its visible parts, 0 .. 1, in grid units.
struct DrawnLine {
    dvec3 a{0}, b{0};
    std::vector<std::pair<double, double>> visible;
    bool operator==(const DrawnLine&) const = default;
};

struct Step {
    Level level = Level::Polygon;
    Action action = Action::Compare;
    std::string test, result;         ///< both select the sentence: step_words.json
    std::vector<std::string> pieces;  ///< their names; of a Sort, the whole order, far to near
    Values values;
    bool decisive = false;           ///< changes an order, cuts, rejects, or finds a failure
    Rect window{};                   ///< the pixels in question; width 0: none
    std::vector<Painted> painted;    ///< Draw only: all changes of the picture
    std::vector<NamedOutline> made;  ///< new pieces
    std::optional<DrawnLine> line;   ///< Draw only, of a hidden-line algorithm
    std::vector<std::pair<std::string, std::uint64_t>>
        counts;  ///< those changed since the last step
    bool operator==(const Step&) const = default;
};

/// The polygon of a piece, by its name.
std::uint32_t polygon_of(const std::string& piece);

/// A counter whose changes the steps hold.
struct WatchedCount {
    const char* name;
    const std::uint64_t* count;
    std::uint64_t last = 0;
};

/// More steps than this need too much memory.
inline constexpr std::size_t most_steps = 2'000'000;

class StepLog {
public:
    /// Records nothing.
    StepLog() = default;
    explicit StepLog(Level finest) : on_(true), finest_(finest) {}

    bool on() const { return on_; }
    Level finest() const { return finest_; }
    bool wants(Level level) const { return on_ && level <= finest_; }
    /// Steps added from now on hold the changes of these counters, which must outlive them.
    void watch(std::vector<WatchedCount> counts) { watched_ = std::move(counts); }
    /// Records Draw steps at any level, others if they are wanted. Throws Error beyond most_steps.
    void add(Step step);
    const std::vector<Step>& steps() const { return steps_; }

private:
    bool on_ = false;
    Level finest_ = Level::Polygon;
    std::vector<WatchedCount> watched_;
    std::vector<Step> steps_;
};

}  // namespace gw::hiddensurface
