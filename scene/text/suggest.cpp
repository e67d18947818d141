#include "scene/text/suggest.h"

#include "gw/escape_controls.h"

#include <algorithm>

namespace gw::scene {

// Damerau's distance with neighbours swapped at most once: three rows of the usual table.
int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
    name = name.substr(0, 64);
    const auto distance = [&](const std::string& k) { return edit_distance(name, k); };
    const auto best = std::ranges::min_element(known, {}, distance);
    return best == known.end() ? std::string() : *best;
}

std::string unknown(std::string_view what, std::string_view name,
                    const std::vector<std::string>& known, std::string_view where) {
    std::string text = "unknown " + std::string(what) + " '" + printable(name) + "'";
    if (!where.empty()) text += " in " + std::string(where);
    if (known.empty()) return text + "; none is known";
    return text + "; the nearest known is '" + nearest(name, known) + "'";
}

std::string printable(std::string_view text, std::size_t most) {
    if (text.size() <= most) return escape_controls(text);
    while (most > 0 && (static_cast<unsigned char>(text[most]) >> 6) == 2) --most;
    return escape_controls(text.substr(0, most)) + "...";
}

}  // namespace gw::scene
