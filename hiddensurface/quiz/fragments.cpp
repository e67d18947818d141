#include "hiddensurface/quiz/fragments.h"

#include "gw/error.h"
#include "hiddensurface/run/compare.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace gw::hiddensurface {
namespace {

constexpr std::string_view header = "x,y,polygon";

[[noreturn]] void fail(const std::string& name, int line, const std::string& what) {
    throw Error(fmt::format("{}:{}: {}", name, line, what));
}

/// Three whole numbers between commas.
std::optional<std::array<long, 3>> numbers_of(std::string_view line) {
    std::array<long, 3> values{};
    const char *at = line.data(), *end = line.data() + line.size();
    const auto skip = [&] {
        while (at < end && (*at == ' ' || *at == '\t')) ++at;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        skip();
        const auto [next, error] = std::from_chars(at, end, values[i]);
        if (error != std::errc()) return std::nullopt;
        at = next;
        skip();
        if (i < 2 && (at == end || *at++ != ',')) return std::nullopt;
    }
    return at == end ? std::optional(values) : std::nullopt;
}

}  // namespace

const char* name_of(Mistake mistake) {
    switch (mistake) {
        case Mistake::None: return "none";
        case Mistake::Missing: return "missing";
        case Mistake::Doubled: return "doubled";
        case Mistake::Misplaced: return "misplaced";
        case Mistake::Wrong: return "wrong";
    }
    return "";
}

std::vector<Fragment> read_fragments(const std::string& name, std::string_view text,
                                     const Input& input) {
    std::set<std::uint32_t> known;
    for (const Polygon& polygon : input.polygons) known.insert(polygon.id);
    std::vector<Fragment> list;
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        number += 1;
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        if (line.empty() || line[0] == '#' || (list.empty() && line == header)) continue;
        const auto values = numbers_of(line);
        if (!values)
            fail(name, number,
                 "'" + scene::printable(line) +
                     "' is no fragment; expected x,y,polygon: three whole numbers");
        const auto [x, y, id] = *values;
        if (x < 0 || y < 0 || x >= input.view.width || y >= input.view.height)
            fail(
                name, number,
                fmt::format(
                    "pixel {},{} is outside the window; expected x 0..{} and y 0..{} from the top left",
                    x, y, input.view.width - 1, input.view.height - 1));
        if (id <= 0 || id > 0xffffffffL || known.count(std::uint32_t(id)) == 0)
            fail(name, number,
                 fmt::format("the scene has no polygon {}; expected {}", id,
                             known.empty()
                                 ? "none: the scene has no polygons"
                                 : fmt::format("{}..{}", *known.begin(), *known.rbegin())));
        list.push_back({int(x), int(y), std::uint32_t(id), number});
    }
    return list;
}

FragmentGrade grade_fragments(const std::vector<Fragment>& list,
                              const std::vector<std::uint32_t>& z_buffer, const Input& input) {
    const auto over = polygons_over(input);
    const Differences differences(input, {});
    std::vector<bool> taken(z_buffer.size());
    FragmentGrade grade;
    const auto add = [&](Mistake mistake, std::uint64_t& count, const Fragment& f,
                         std::uint32_t expected) {
        count += 1;
        grade.mistakes.push_back({mistake, f.x, f.y, f.line, f.id, expected});
    };
    for (const Fragment& f : list) {
        const int row = input.view.height - 1 - f.y;
        const std::size_t at = input.view.index(f.x, row);
        const std::uint32_t expected = z_buffer[at];
        if (std::count(over[at].begin(), over[at].end(), f.id) == 0) {
            add(Mistake::Misplaced, grade.misplaced, f, expected);
        } else if (taken[at]) {
            add(Mistake::Doubled, grade.doubled, f, expected);
        } else {
            taken[at] = true;
            const Difference difference = differences.at(f.id, expected, f.x, row);
            if (difference == Difference::None || difference == Difference::Tie)
                grade.right += 1;
            else
                add(Mistake::Wrong, grade.wrong, f, expected);
        }
    }
    for (int y = 0; y < input.view.height; ++y)
        for (int x = 0; x < input.view.width; ++x) {
            const std::size_t at = input.view.index(x, input.view.height - 1 - y);
            if (z_buffer[at] == 0) continue;
            grade.expected += 1;
            if (!taken[at]) add(Mistake::Missing, grade.missing, {x, y, 0, 0}, z_buffer[at]);
        }
    return grade;
}

std::string fragments_text(const std::vector<std::uint32_t>& z_buffer, const Input& input) {
    std::string text = std::string(header) + "\n";
    for (int y = 0; y < input.view.height; ++y)
        for (int x = 0; x < input.view.width; ++x) {
            const std::size_t at = input.view.index(x, input.view.height - 1 - y);
            if (z_buffer[at] != 0) text += fmt::format("{},{},{}\n", x, y, z_buffer[at]);
        }
    return text;
}

}  // namespace gw::hiddensurface
