#include "hiddensurface/run/blame.h"

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace gw::hiddensurface {
namespace {

/// The step that painted a pixel last, and what it covered.
struct LastPaint {
    std::size_t step = 0;
    std::uint32_t id = 0, over = 0;
};

std::vector<LastPaint> last_paints(const std::vector<Step>& steps, std::size_t pixels, int width) {
    std::vector<LastPaint> last(pixels);
    for (std::size_t i = 0; i < steps.size(); ++i)
        for (const auto& [run, id] : steps[i].painted)
            for (int x = run.x0; x < run.x1; ++x) {
                LastPaint& at = last[pixel_index(x, run.y, width)];
                at = {i + 1, id, at.id};
            }
    return last;
}

std::string name_of(std::uint32_t id) { return id == 0 ? "the background" : std::to_string(id); }

}  // namespace

std::string sentence_of(const Blame& blame, int height) {
    const std::string where =
        fmt::format("at {} {}, first at ({}, {}).", blame.pixels,
                    blame.pixels == 1 ? "pixel" : "pixels", blame.x, height - 1 - blame.y);
    if (blame.step == 0) return "No step painted " + name_of(blame.expected) + " " + where;
    return fmt::format("Step {} painted {} over {} {} Expected: {}.", blame.step, blame.id,
                       name_of(blame.over), where, name_of(blame.expected));
}

std::vector<Blame> blame_of(const std::vector<Step>& steps, const Result& result, int width) {
    if (result.counts.wrong == 0 || result.difference.empty()) return {};
    const std::vector<LastPaint> last = last_paints(steps, result.ids.size(), width);
    std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t, std::uint32_t>, Blame> found;
    for (int y = int(result.ids.size()) / width - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = pixel_index(x, y, width);
            if (result.difference[at] != Difference::Wrong) continue;
            const LastPaint& paint = last[at];
            Blame& blame = found[{paint.step, paint.id, paint.over, result.expected[at]}];
            if (blame.pixels++ == 0)
                blame = {paint.step, paint.id, paint.over, result.expected[at], 1, x, y};
        }
    std::vector<Blame> all;
    for (const auto& [key, blame] : found) all.push_back(blame);
    return all;
}

}  // namespace gw::hiddensurface
