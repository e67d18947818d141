#include "hiddensurface/model/piece.h"

#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/scan_conversion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace gw::hiddensurface {
namespace {

/// Sutherland-Hodgman against one plane; `sign` -1 keeps the part before it. A new corner is always
/// computed from the corner before the plane, so both halves get the same.
Loop half_of(const Loop& loop, const dvec4& plane, double sign) {
    Loop half;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const dvec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const double da = side(plane, a), db = side(plane, b);
        if (sign * da >= 0) half.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0))
            half.push_back(da < 0 ? a + (da / (da - db)) * (b - a)
                                  : b + (db / (db - da)) * (a - b));
    }
    return half;
}

bool is_inside(const PixelCut& cut, double x, double y) {
    return ((cut.line.x * x + cut.line.y * y) + cut.line.z < 0) == cut.negative;
}

/// True within the rounding of a corner that a cut made.
bool is_on(const dvec3& line, const dvec2& p) {
    const double off = line.x * p.x + line.y * p.y + line.z;
    return std::abs(off) <= 1e-3 * std::sqrt(line.x * line.x + line.y * line.y);
}

/// The run's pixels inside all cuts.
void add_cut(const Run& run, const std::vector<PixelCut>& cuts, int s, std::vector<Run>& out) {
    const double y = double(center(run.y, s));
    Run open{run.y, run.x0, run.x0};
    for (int x = run.x0; x < run.x1; ++x) {
        const bool inside = std::all_of(cuts.begin(), cuts.end(), [&](const PixelCut& cut) {
            return is_inside(cut, double(center(x, s)), y);
        });
        if (inside && open.x1 < x) open.x0 = x;
        if (inside) open.x1 = x + 1;
        if (!inside && open.x0 < open.x1) out.push_back(open);
        if (!inside) open.x0 = open.x1 = x + 1;
    }
    if (open.x0 < open.x1) out.push_back(open);
}

std::pair<double, double> along(const Loop& loop, const dvec2& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const dvec3& p : loop) {
        const double d = direction.x * p.x + direction.y * p.y;
        low = std::min(low, d);
        high = std::max(high, d);
    }
    return {low, high};
}

/// Two convex polygons are apart if and only if a side of one of them separates them.
bool side_separates(const Loop& a, const Loop& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const dvec3 side = a[(i + 1) % a.size()] - a[i];
        if (side.x == 0 && side.y == 0) continue;
        const dvec2 across = dvec2(side.y, -side.x) / std::sqrt(side.x * side.x + side.y * side.y);
        if (!overlap(along(a, across), along(b, across))) return true;
    }
    return false;
}

}  // namespace

Piece whole(std::size_t index, const Polygon& polygon) {
    Piece piece{.polygon = index, .count = polygon.triangles.size(), .name = name_of(polygon)};
    for (const Facet& facet : polygon.facets)
        piece.parts.insert(piece.parts.end(), facet.parts.begin(), facet.parts.end());
    return piece;
}

dvec3 cut_line(const dvec4& p, const dvec4& by) {
    if (p.z == 0) return {by.x, by.y, by.w};  // never drawn: edge-on
    const double f = by.z / p.z;
    return {by.x - f * p.x, by.y - f * p.y, by.w - f * p.w};
}

std::pair<std::vector<Loop>, std::vector<Loop>> divide(const std::vector<Loop>& parts,
                                                       const dvec4& plane) {
    std::pair<std::vector<Loop>, std::vector<Loop>> halves;
    for (const Loop& part : parts) {
        Loop before = half_of(part, plane, -1), behind = half_of(part, plane, 1);
        if (before.size() > 2) halves.first.push_back(std::move(before));
        if (behind.size() > 2) halves.second.push_back(std::move(behind));
    }
    return halves;
}

std::vector<CutEdge> edges_made(const Piece& piece) {
    std::vector<CutEdge> made;
    for (const Loop& part : piece.parts)
        for (std::size_t i = 0; i < part.size(); ++i) {
            const dvec2 a(part[i]), b(part[(i + 1) % part.size()]);
            if (std::any_of(piece.cuts.begin(), piece.cuts.end(), [&](const PixelCut& cut) {
                    return is_on(cut.line, a) && is_on(cut.line, b);
                }))
                made.emplace_back(a, b);
        }
    return made;
}

std::vector<Run> runs_of(const Piece& piece, const Polygon& polygon, int s, const Rect& window) {
    std::vector<Run> out;
    for (const WindowTriangle& t : std::span(polygon.triangles).subspan(piece.first, piece.count))
        for (const Run& run : scan_convert(t.corners, s, window)) {
            if (piece.cuts.empty())
                out.push_back(run);
            else
                add_cut(run, piece.cuts, s, out);
        }
    return out;
}

std::pair<double, double> extent(const Piece& piece, int axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Loop& part : piece.parts)
        for (const dvec3& p : part) {
            low = std::min(low, p[axis]);
            high = std::max(high, p[axis]);
        }
    return {low, high};
}

bool projections_overlap(const Piece& a, const Piece& b) {
    for (const Loop& p : a.parts)
        for (const Loop& q : b.parts)
            if (!side_separates(p, q) && !side_separates(q, p)) return true;
    return false;
}

}  // namespace gw::hiddensurface
