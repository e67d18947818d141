#include "hiddensurface/run/estimate.h"

#include "gw/base/elementary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

/// The number of polygons of the larger of two samples; the other has half as many. Scenes below
/// twice this number are not estimated.
constexpr std::size_t sample_size = 1024;

/// Smaller objects are sampled whole.
constexpr std::size_t least_run = 64;

/// `count` polygons, evenly over the scene's order.
Input scattered_sample(const Input& input, std::size_t count) {
    Input sampled{input.scene, input.view, input.profile, {}};
    for (std::size_t i = 0; i < count; ++i)
        sampled.polygons.push_back(input.polygons[i * input.polygons.size() / count]);
    return sampled;
}

/// About `count` polygons: of each object a run of neighbours from its middle, in proportion to its
/// size; of small objects some, whole.
Input joined_sample(const Input& input, std::size_t count) {
    const std::vector<Polygon>& all = input.polygons;
    Input sampled{input.scene, input.view, input.profile, {}};
    double wanted = 0;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].object == all[begin].object) ++end;
        const std::size_t size = end - begin;
        wanted += double(size) * double(count) / double(all.size());
        if (wanted < double(std::min(size, least_run))) continue;
        const std::size_t taken = std::min(size, std::size_t(wanted));
        const auto from = all.begin() + std::ptrdiff_t(begin + (size - taken) / 2);
        sampled.polygons.insert(sampled.polygons.end(), from, from + std::ptrdiff_t(taken));
        wanted -= double(taken);
    }
    return sampled;
}

Input sample(const Input& input, std::size_t count, Sampling sampling) {
    return sampling == Sampling::Joined ? joined_sample(input, count)
                                        : scattered_sample(input, count);
}

double rays(const Input& input) {
    double visible = 0;
    for (const Polygon& polygon : input.polygons) visible += polygon.visible() ? 1 : 0;
    return visible * double(input.view.width) * double(input.view.height);
}

double questions(const Counts& c) {
    return double(c.facings + c.keys + c.extents + c.planes + c.overlaps + c.crossings + c.depths);
}
double questions(const LineCounts& c) {
    return double(c.facings + c.extents + c.planes + c.crossings);
}

struct Sample {
    double questions = 0, bytes = 0;
};

template <class AnyAlgorithm>
Sample run_sample(const AnyAlgorithm& algorithm, const Input& input) {
    StepLog none;
    const auto counts = algorithm.run(input, none).counts;
    return {questions(counts), double(counts.peak_bytes)};
}

/// Extrapolates b to a scene `times` as large, by its growth from a at half the size.
double grown(double a, double b, double times) {
    if (a <= 0 || b <= 0) return b * times;
    return b * gw::pow(times, std::clamp(gw::log(b / a) / gw::log(2.0), 1.0, 2.5));
}

template <class AnyAlgorithm>
Estimate estimate_of(const AnyAlgorithm& algorithm, const Input& input) {
    Estimate found{algorithm.name, input.polygons.size()};
    const Growth& growth = algorithm.growth;
    const double second = 1e-9 * growth.nanoseconds;
    if (growth.law == GrowthLaw::Rays) found.seconds = second * rays(input);
    if (growth.law != GrowthLaw::Superlinear || found.polygons < 2 * sample_size) return found;
    const Sample half = run_sample(algorithm, sample(input, sample_size / 2, growth.sampling)),
                 whole = run_sample(algorithm, sample(input, sample_size, growth.sampling));
    const double times = double(found.polygons) / double(sample_size);
    found.seconds = second * grown(half.questions, whole.questions, times);
    found.bytes = grown(half.bytes, whole.bytes, times);
    return found;
}

/// "20,480"
std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
    return digits;
}

/// "2 minutes": two digits at most.
std::string duration(double seconds) {
    struct Unit {
        const char* name;
        double seconds;
    };
    const Unit units[] = {{"seconds", 1}, {"minutes", 60}, {"hours", 3600}, {"days", 86400}};
    const Unit* unit = &units[0];
    for (const Unit& larger : units)
        if (seconds >= 2 * larger.seconds) unit = &larger;
    const auto number = std::size_t(std::ceil(seconds / unit->seconds));
    return number <= 1 ? "a second" : fmt::format("{} {}", grouped(number), unit->name);
}

std::string memory(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.0f} MB", std::ceil(bytes / 1e6))
                       : fmt::format("{:.0f} GB", std::ceil(bytes / 1e9));
}

}  // namespace

Estimate estimate(const Algorithm& algorithm, const Input& input) {
    return estimate_of(algorithm, input);
}
Estimate estimate(const LineAlgorithm& algorithm, const Input& input) {
    return estimate_of(algorithm, input);
}

bool is_beyond(const Estimate& estimate, double seconds) {
    return seconds > 0 && (estimate.seconds > seconds || estimate.bytes > most_estimated_bytes);
}

std::string text_of(const Estimate& estimate) {
    std::string text = fmt::format("{}: {} polygons would take about {}", estimate.algorithm,
                                   grouped(estimate.polygons), duration(estimate.seconds));
    if (estimate.bytes > 0) text += " and " + memory(estimate.bytes);
    return text;
}

}  // namespace gw::hiddensurface
