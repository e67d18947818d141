// The A-buffer. L. Carpenter: The A-buffer, an Antialiased Hidden Surface Method, SIGGRAPH 1984. A
// pixel is a list of fragments, sorted by their nearest depth. Each has a mask of the 4 x 8 points
// of the pixel that its face covers, and the nearest and farthest depth of the face there.
// Fragments behind one that covers all points are dropped. At the end the masks give each face its
// part of the pixel: front to back, each takes the points that are left. If the depths of two
// fragments overlap, the paper's estimate gives the visible part of the front one. The picture is
// that of the point in the middle of the pixel; `shares` has the parts, for smooth edges.
//
// Does not claim: exact parts of faces that pierce each other (an estimate), or of three that
// overlap in depth (compared two at a time).
//
// Left out: translucency.
//
// Ours: points at multiples of 1/8 and 1/4 of a pixel, so that one is its middle. At the middle,
// the exact planes decide.
#include "hiddensurface/faces/face.h"
#include "hiddensurface/model/scan_conversion.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::hiddensurface {
namespace {

constexpr int across = 8, down = 4;
constexpr std::uint32_t all_points = ~std::uint32_t{0};
constexpr std::uint32_t middle_point = std::uint32_t{1} << (down / 2 * across + across / 2);

struct Fragment {
    const Face* face = nullptr;
    std::uint32_t mask = 0;
    double nearest = 0, farthest = 0;
};

/// Depths are those of the plane at the pixel's corners, clamped to the face's own.
Fragment make_fragment(const Face& face, int x, int y, std::uint32_t mask) {
    const double n = double(face.plane.n), middle = double(face.plane.scaled(x, y)) / n;
    const double reach =
        0.5 * (std::abs(double(face.plane.x)) + std::abs(double(face.plane.y))) / n;
    const double low = double(face.nearest), high = double(face.farthest);
    return {&face, mask, std::clamp(middle - reach, low, high),
            std::clamp(middle + reach, low, high)};
}

class ABuffer {
public:
    ABuffer(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "A-buffer")},
          faces_(faces_of(input)),
          pixels_(std::size_t(input.view.width) * std::size_t(input.view.height)),
          row_(std::size_t(input.view.width)) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        for (const Face& face : faces_) add(face);
        output_.counts.peak_bytes = pixels_.size() * sizeof(pixels_[0]) + most_ * sizeof(Fragment);
        for (int y = input_.view.height - 1; y >= 0; --y) resolve_line(y);
        return std::move(output_);
    }

private:
    /// Scan converts on a grid of points instead of pixels: the points are its "centres".
    void add(const Face& face) {
        const int s = input_.subpixel_bits();
        const std::int64_t half = std::int64_t{1} << (s - 1);
        std::vector<GridPoint> corners;
        for (const GridPoint& p : face.corners)
            corners.push_back({across * p.x + half, down * p.y + half, 0});
        const Rect points{0, 0, across * input_.view.width, down * input_.view.height};
        const std::uint64_t before = output_.counts.nodes;
        int y = -1;
        for (const Run& run : scan_convert(corners, s, points)) {
            if (run.y / down != y) flush(face, y);
            y = run.y / down;
            for (int x = run.x0; x < run.x1; ++x)
                row_[std::size_t(x / across)] |= std::uint32_t{1}
                                                 << (run.y % down * across + x % across);
        }
        flush(face, y);
        if (log_.on())
            log_.add({.action = Action::Decide,
                      .test = "fragments",
                      .result = "made",
                      .pieces = {face.name},
                      .values = {{"fragments", std::int64_t(output_.counts.nodes - before)}}});
    }

    void flush(const Face& face, int y) {
        if (y < 0) return;
        const int end = std::min(face.bounds.x + face.bounds.width, input_.view.width);
        for (int x = std::max(face.bounds.x - 1, 0); x < end; ++x)
            if (const std::uint32_t mask = std::exchange(row_[std::size_t(x)], 0))
                insert(x, y, face, mask);
    }

    std::vector<Fragment>& pixel(int x, int y) { return pixels_[input_.view.index(x, y)]; }

    void insert(int x, int y, const Face& face, std::uint32_t mask) {
        output_.counts.nodes += 1;
        const Fragment made = make_fragment(face, x, y, mask);
        std::vector<Fragment>& list = pixel(x, y);
        std::size_t place = 0;
        for (; place < list.size() && list[place].nearest <= made.nearest; ++place) {
            output_.counts.depths += 1;
            if (list[place].mask != all_points || list[place].farthest >= made.nearest) continue;
            output_.counts.rejected += 1;
            return;
        }
        list.insert(list.begin() + std::ptrdiff_t(place), made);
        const std::size_t hidden =
            made.mask != all_points
                ? 0
                : std::erase_if(list, [&](const Fragment& f) { return f.nearest > made.farthest; });
        output_.counts.rejected += hidden;
        fragments_ += 1 - hidden;
        most_ = std::max(most_, fragments_);
    }

    void resolve_line(int y) {
        std::vector<Painted> painted;
        for (int x = 0; x < input_.view.width; ++x) {
            const std::vector<Fragment>& list = pixel(x, y);
            if (list.empty()) continue;
            share_out(x, y, list);
            const Fragment* shown = nullptr;
            for (const Fragment& f : list) {
                if (!(f.mask & middle_point)) continue;
                if (shown) output_.counts.depths += 1;
                if (!shown || is_nearer(*f.face, *shown->face, x, y)) shown = &f;
            }
            if (shown) add_run(painted, {y, x, x + 1}, input_.polygons[shown->face->polygon].id);
        }
        output_.counts.spans += painted.size();
        draw_line(input_, y, std::move(painted), output_, log_);
    }

    /// The paper's resolution, front to back.
    void share_out(int x, int y, const std::vector<Fragment>& list) {
        std::vector<double> points(list.size());
        std::uint32_t left = all_points;
        for (std::size_t i = 0; i < list.size() && left; ++i) {
            const Fragment& f = list[i];
            output_.counts.overlaps += 1;
            const std::uint32_t taken = left & f.mask;
            points[i] += std::popcount(taken);
            if (i + 1 < list.size() && list[i + 1].nearest < f.farthest) {
                const Fragment& g = list[i + 1];
                const double seen =
                    (g.farthest - f.nearest) / (f.farthest - f.nearest + g.farthest - g.nearest);
                const double lost = (1 - seen) * std::popcount(taken & g.mask);
                points[i] -= lost;
                points[i + 1] += lost;
            }
            left &= ~f.mask;
        }
        for (std::size_t i = 0; i < list.size(); ++i)
            if (points[i] > 0)
                output_.shares.push_back(
                    {x, y, input_.polygons[list[i].face->polygon].id, points[i] / (across * down)});
        if (log_.wants(Level::Pixel)) log_pixel(x, y, list, points);
    }

    void log_pixel(int x, int y, const std::vector<Fragment>& list,
                   const std::vector<double>& points) {
        Step step{.level = Level::Pixel,
                  .test = "points",
                  .result = list.size() == 1 ? "one" : "shared",
                  .decisive = list.size() > 1,
                  .window = pixels_of({y, x, x + 1})};
        std::vector<std::int64_t> masks;
        std::vector<double> nearest, farthest;
        for (const Fragment& f : list) {
            step.pieces.push_back(f.face->name);
            masks.push_back(f.mask);
            nearest.push_back(f.nearest);
            farthest.push_back(f.farthest);
        }
        step.values = {
            {"points", points}, {"masks", masks}, {"z_nearest", nearest}, {"z_farthest", farthest}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Face> faces_;
    std::vector<std::vector<Fragment>> pixels_;
    std::vector<std::uint32_t> row_;          ///< masks of the face being added
    std::uint64_t fragments_ = 0, most_ = 0;  ///< in lists: now, and at most
};

}  // namespace

Algorithm a_buffer() {
    return {.name = "a-buffer",
            .title = "A-buffer: masks of 32 points a pixel (1984)",
            .claim = Claim::Always,
            .run = [](const Input& input, StepLog& log) { return ABuffer(input, log).run(); }};
}

}  // namespace gw::hiddensurface
