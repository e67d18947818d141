#include "hiddensurface/lines/horizon.h"

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

/// Points nearer to the horizon than this part of the compared values are on it.
constexpr double relative_tolerance = 1e-11;
/// Shorter pieces come from the rounding of their ends.
constexpr double shortest = 1e-13;

}  // namespace

std::size_t Horizon::first_reaching(double u) const {
    return std::size_t(std::partition_point(pieces_.begin(), pieces_.end(),
                                            [u](const Piece& piece) { return piece.b.x <= u; }) -
                       pieces_.begin());
}

std::optional<double> Horizon::at(double u) const {
    std::size_t i = first_reaching(u);
    if (i == pieces_.size() || pieces_[i].a.x > u) {
        if (i == 0 || pieces_[i - 1].b.x < u) return std::nullopt;
        --i;  // at the end of a piece
    }
    return pieces_[i].at(u);
}

std::vector<Part> Horizon::beyond(const dvec2& a, const dvec2& b, LineCounts& counts) const {
    const Piece line{a, b};
    std::vector<Part> parts;
    const auto add = [&](double from, double to) {
        if (to <= from) return;
        const Part part{(from - a.x) / (b.x - a.x), (to - a.x) / (b.x - a.x)};
        if (!parts.empty() && parts.back().second >= part.first)
            parts.back().second = part.second;
        else
            parts.push_back(part);
    };
    double u = a.x;
    for (std::size_t i = first_reaching(a.x); i < pieces_.size() && pieces_[i].a.x < b.x; ++i) {
        const Piece& piece = pieces_[i];
        counts.crossings += 1;
        const double from = std::max(u, piece.a.x), to = std::min(b.x, piece.b.x);
        add(u, from);
        const double size =
            std::abs(piece.a.y) + std::abs(piece.b.y) + std::abs(a.y) + std::abs(b.y);
        // A point on the horizon is exactly on it: a line that begins there is beyond it at once.
        const auto over = [&](double at) {
            const double d = sign_ * (line.at(at) - piece.at(at));
            return std::abs(d) > relative_tolerance * size ? d : 0;
        };
        const double over_from = over(from), over_to = over(to);
        if (over_from > 0 || over_to > 0) {
            const double crossing = from + over_from / (over_from - over_to) * (to - from);
            add(over_from < 0 ? crossing : from, over_to < 0 ? crossing : to);
        }
        u = to;
    }
    add(u, b.x);
    return parts;
}

void Horizon::raise(const dvec2& a, const dvec2& b) {
    LineCounts none;
    const Piece line{a, b};
    const std::size_t first = first_reaching(a.x);
    std::size_t last = first;
    std::vector<Piece> merged;
    const auto put = [&](const Piece& piece, double from, double to) {
        if (to - from > shortest) merged.push_back({{from, piece.at(from)}, {to, piece.at(to)}});
    };
    const std::vector<Part> parts = beyond(a, b, none);
    if (parts.empty()) return;
    std::vector<std::pair<double, double>> over;
    for (const auto& [from, to] : parts)
        over.emplace_back(from == 0 ? a.x : a.x + from * (b.x - a.x),
                          to == 1 ? b.x : a.x + to * (b.x - a.x));
    // Keep the old pieces between the parts of the new line, in order.
    for (; last < pieces_.size() && pieces_[last].a.x < b.x; ++last) {
        double u = pieces_[last].a.x;
        for (const auto& [from, to] : over) {
            if (to <= u || from >= pieces_[last].b.x) continue;
            put(pieces_[last], u, from);
            u = std::max(u, to);
        }
        put(pieces_[last], u, pieces_[last].b.x);
    }
    for (const auto& [from, to] : over) put(line, from, to);
    std::sort(merged.begin(), merged.end(),
              [](const Piece& p, const Piece& q) { return p.a.x < q.a.x; });
    pieces_.erase(pieces_.begin() + std::ptrdiff_t(first), pieces_.begin() + std::ptrdiff_t(last));
    pieces_.insert(pieces_.begin() + std::ptrdiff_t(first), merged.begin(), merged.end());
}

}  // namespace gw::hiddensurface
