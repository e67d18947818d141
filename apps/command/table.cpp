#include "apps/command/table.h"

#include "gw/escape_controls.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The first column and columns `from` .. `to` - 1.
Rows part_of(const Rows& rows, std::size_t from, std::size_t to) {
    Rows part;
    for (const auto& row : rows) {
        part.push_back({row[0]});
        part.back().insert(part.back().end(), row.begin() + std::ptrdiff_t(from),
                           row.begin() + std::ptrdiff_t(to));
    }
    return part;
}

}  // namespace

std::string table(std::vector<std::vector<std::string>> rows) {
    for (auto& row : rows)
        for (std::string& cell : row) cell = escape_controls(cell);
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        text += fmt::format("{:<{}}", row[0], widths[0]);
        for (std::size_t i = 1; i < row.size(); ++i)
            text += fmt::format("  {:>{}}", row[i], widths[i]);
        text += "\n";
    }
    return text;
}

std::string table_in_parts(const std::vector<std::vector<std::string>>& rows, std::size_t width) {
    const std::size_t columns = rows.front().size() - 1;
    for (std::size_t parts = 1;; ++parts) {
        const std::size_t each = (columns + parts - 1) / parts;
        std::string text;
        std::size_t widest = 0;
        for (std::size_t from = 1; from <= columns; from += each) {
            const std::string part = table(part_of(rows, from, std::min(from + each, columns + 1)));
            widest = std::max(widest, part.find('\n'));
            text += (from > 1 ? "\n" : "") + part;
        }
        if (widest <= width || each <= 1) return text;
    }
}

}  // namespace gw::apps
