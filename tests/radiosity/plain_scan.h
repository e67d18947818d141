// The scan of [F2.2], one pixel after the other and no vectors: the scalar twin that scan_pixmap is
// compared with.
#pragma once

#include "radiosity/hemicube/facet_view.h"
#include "radiosity/hemicube/scan.h"

#include <array>
#include <cmath>

namespace gw::radiosity {

/// One facet in one face.
class PlainScan {
public:
    PlainScan(const PixmapModel& model, std::uint32_t number, const IdBuffer& buffer,
              const Homography& map, int most_parts, std::span<double> factors)
        : map_(map),
          u_{model.facets[number].low.x, model.facets[number].high.x,
             model.pixmaps[model.facets[number].pixmap].width},
          v_{model.facets[number].low.y, model.facets[number].high.y,
             model.pixmaps[model.facets[number].pixmap].height},
          first_(model.pixmaps[model.facets[number].pixmap].first),
          nearest_(model.pixmaps[model.facets[number].pixmap].whole ? nullptr
                                                                    : model.nearest.data()),
          factors_(factors.data()),
          most_parts_(most_parts),
          pixel_(pixel_of(number)),
          buffer_(buffer) {}

    void pixel(int i, int j, double delta) const {
        const dvec3 h = at(i + 0.5, j + 0.5);
        const double w = inverse(h.z);
        const dvec2 uv(h.x * w, h.y * w);
        if (most_parts_ == 1) return to_box<2>(uv, dvec2(0), delta);
        const dvec2 across_x = footprint(uv, w, map_.along_x),
                    across_y = footprint(uv, w, map_.along_y);
        const double x = largest(across_x), y = largest(across_y);
        if (x <= 0.5 && y <= 0.5) return to_box<2>(uv, box_of(across_x, across_y), delta);
        const int nx = parts(x), ny = parts(y);
        if (nx * ny == 1 && !at_end(i, j)) return to_box<3>(uv, box_of(across_x, across_y), delta);
        in_parts(i, j, nx, ny, uv, box_of(across_x / double(nx), across_y / double(ny)), delta);
    }

private:
    dvec3 at(double x, double y) const {
        return map_.at_zero + (x * map_.along_x + y * map_.along_y);
    }

    /// In texels, along u or v: where the facet lies, and how many texels the pixmap has.
    struct Axis {
        double low = 0, high = 0;
        int count = 0;
        bool holds(double v) const { return v >= low && v <= high; }
    };
    struct Range {
        int begin = 0, end = 0;
    };

    /// W is below 0 where the front is seen. A part of a pixel may reach over the plane's horizon:
    /// the texel is then far away.
    static double inverse(double w) { return 1 / (w < -1e-30 ? w : -1e-30); }

    static double largest(const dvec2& v) {
        const double x = std::abs(v.x), y = std::abs(v.y);
        return x > y ? x : y;
    }

    /// What one pixel covers of the pixmap along x or y: the derivative of the homography.
    static dvec2 footprint(const dvec2& uv, double w, const dvec3& along) {
        return {(along.x - uv.x * along.z) * w, (along.y - uv.y * along.z) * w};
    }

    /// The box around the parallelogram of two footprints.
    static dvec2 box_of(const dvec2& a, const dvec2& b) {
        return {std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y)};
    }

    /// So many that a part covers at most a texel, and the box of two such footprints two.
    int parts(double texels) const {
        if (texels <= 1) return 1;
        return texels < most_parts_ ? static_cast<int>(texels) + 1 : most_parts_;
    }

    void in_parts(int i, int j, int nx, int ny, const dvec2& middle, const dvec2& size,
                  double delta) const {
        std::vector<dvec2> parts;
        const Range in_x = reach(i, j, 1, 0, nx), in_y = reach(i, j, 0, 1, ny);
        for (int y = in_y.begin; y < in_y.end; ++y)
            for (int x = in_x.begin; x < in_x.end; ++x) {
                const dvec3 h = at(i + (x + 0.5) / nx, j + (y + 0.5) / ny);
                const double w = inverse(h.z);
                if (u_.holds(h.x * w) && v_.holds(h.y * w)) parts.push_back({h.x * w, h.y * w});
            }
        if (parts.empty()) parts.push_back(middle);
        for (const dvec2& uv : parts)
            to_box<3>(uv, size, delta / static_cast<double>(parts.size()));
    }

    /// The parts of a pixel. Beside one that sees something else the facet may reach on, by half a
    /// pixel in the mean: without these parts, texels there would get nothing.
    Range reach(int i, int j, int dx, int dy, int count) const {
        const int more = (count + 1) / 2;
        return {ends(i - dx, j - dy) ? -more : 0, ends(i + dx, j + dy) ? count + more : count};
    }

    bool at_end(int i, int j) const {
        return ends(i - 1, j) || ends(i + 1, j) || ends(i, j - 1) || ends(i, j + 1);
    }

    /// Whether that pixel sees something else; beyond the face's border the facet goes on.
    bool ends(int i, int j) const {
        if (i < 0 || j < 0 || i >= buffer_.size || j >= buffer_.rows) return false;
        return buffer_.pixels[std::size_t(j) * std::size_t(buffer_.size) + std::size_t(i)] !=
               pixel_;
    }

    /// An interval, as parts of it in `Count` texels, one after the other.
    template <std::size_t Count>
    struct Cells {
        std::array<std::size_t, Count> texel;
        std::array<double, Count> part;
    };

    /// Of an interval shorter than Count - 1 texels, moved, and where it is larger cut, into the
    /// facet: a pixel on the border may fall beside it.
    template <std::size_t Count>
    static Cells<Count> cells(double middle, double size, const Axis& axis) {
        const double whole = axis.high - axis.low, length = size < whole ? size : whole;
        const double wanted = middle - length / 2, end = axis.high - length;
        const double limited = wanted < end ? wanted : end;
        const double begin = limited > axis.low ? limited : axis.low;  // not below 0
        const int at = static_cast<int>(begin), last = axis.count - 1,
                  first = at < last ? at : last;
        Cells<Count> cells;
        double left = length, room = first + 1 - begin;
        for (std::size_t k = 0; k < Count; ++k) {
            const int texel = first + static_cast<int>(k);
            cells.texel[k] = std::size_t(texel < last ? texel : last);
            cells.part[k] = left < room || k + 1 == Count ? left : room;
            left -= cells.part[k];
            room = 1;
        }
        return cells;
    }

    template <std::size_t Count>
    void to_box(const dvec2& uv, const dvec2& size, double value) const {
        constexpr double least = 1e-12;  // a point is a box too
        const Cells<Count> u = cells<Count>(uv.x, size.x + least, u_),
                           v = cells<Count>(uv.y, size.y + least, v_);
        double long_u = 0, long_v = 0;
        for (std::size_t k = 0; k < Count; ++k) {
            long_u += u.part[k];
            long_v += v.part[k];
        }
        const double density = value / (long_u * long_v);
        for (std::size_t j = 0; j < Count; ++j) {
            const std::size_t row = first_ + v.texel[j] * std::size_t(u_.count);
            const double in_row = density * v.part[j];
            for (std::size_t k = 0; k < Count; ++k) add(row + u.texel[k], in_row * u.part[k]);
        }
    }

    void add(std::size_t texel, double value) const {
        factors_[nearest_ ? nearest_[texel] : texel] += value;
    }

    const Homography map_;
    const Axis u_, v_;
    const std::size_t first_;
    const std::uint32_t* const nearest_;  ///< null: every texel is an element
    double* const factors_;
    const int most_parts_;
    const std::uint32_t pixel_;
    const IdBuffer& buffer_;
};

/// The front of every facet of a pixmap.
inline void plain_scan(const PixmapModel& model, std::uint32_t pixmap, const Hemicube& hemicube,
                       const IdBuffers& buffers, const DeltaFormFactors& delta,
                       const ScanOptions& options, std::span<double> factors) {
    Region region;
    for (const std::uint32_t number : model.pixmaps[pixmap].facets)
        for (std::size_t face = 0; face < hemicube_faces; ++face) {
            const Facet& facet = model.facets[number];
            const IdBuffer& buffer = buffers[face];
            if (dot3(facet.normal, hemicube.position) - facet.offset <= 0) continue;
            find_region(facet, hemicube.views[face], face == 0, region);
            const PlainScan scan(
                model, number, buffer,
                homography(facet, hemicube, hemicube.views[face], buffer.size - buffer.rows),
                options.most_parts, factors);
            for (std::size_t r = 0; r < region.spans.size(); ++r)
                for (int i = region.spans[r].first; i < region.spans[r].end; ++i) {
                    const int j = region.row + static_cast<int>(r);
                    const auto at = std::size_t(j) * std::size_t(buffer.size) + std::size_t(i);
                    if (buffer.pixels[at] == pixel_of(number))
                        scan.pixel(i, j, (face == 0 ? delta.top : delta.side)[at]);
                }
        }
}

}  // namespace gw::radiosity
