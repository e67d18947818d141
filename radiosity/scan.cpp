#include "radiosity/scan.h"

#include "radiosity/region.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {

namespace {

/// Texel coordinates of pixels: (u, v) = (U, V) / W, each linear in the pixel's coordinates. A plane seen in
/// perspective, so one homography for a facet and a face.
struct Homography {
    dvec3 at_zero, along_x, along_y;  ///< of U, V, W

    dvec3 at(double x, double y) const { return at_zero + (x * along_x + y * along_y); }
};

/// `first_row`: of the buffer in the face's window.
Homography homography(const Facet& facet, const Hemicube& hemicube, const scene::View& view, int first_row) {
    const dmat4& m = view.eye_from_world;
    const dvec3 right(m[0].x, m[1].x, m[2].x), up(m[0].y, m[1].y, m[2].y), forward(-m[0].z, -m[1].z, -m[2].z);
    // A ray p = c + t d meets the plane at t = height / -(n d): uv = (uv(c) (n d) - height grad d) / (n d).
    const double height = dot3(facet.normal, hemicube.position) - facet.offset;
    const dvec2 uv = facet.texel_of(hemicube.position);
    const auto of_direction = [&](const dvec3& d) {
        const double w = dot3(facet.normal, d);
        return dvec3(uv.x * w - height * dot3(facet.grad_u, d), uv.y * w - height * dot3(facet.grad_v, d), w);
    };
    const double step = 2.0 / view.width;
    const dvec3 corner = forward - right + (first_row * step - 1) * up;
    return {of_direction(corner), of_direction(step * right), of_direction(step * up)};
}

/// One facet in one face.
class FacetScan {
public:
    FacetScan(const Model& model, const Facet& facet, const Homography& map, int most_parts,
              std::span<double> factors)
        : model_(model),
          facet_(facet),
          pixmap_(model.pixmaps[facet.pixmap]),
          map_(map),
          most_parts_(most_parts),
          factors_(factors) {}

    void pixel(int i, int j, double delta) {
        const dvec3 h = map_.at(i + 0.5, j + 0.5);
        const dvec2 uv = texel(h);
        if (most_parts_ == 1) return to_one_texel(uv, delta);
        const dvec2 across_x = footprint(uv, h.z, map_.along_x), across_y = footprint(uv, h.z, map_.along_y);
        const int nx = parts(across_x), ny = parts(across_y);
        if (nx * ny == 1) return to_box(uv, box_of(across_x, across_y), delta);
        const dvec2 size = box_of(across_x / double(nx), across_y / double(ny));
        const double part = delta / (nx * ny);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                to_box(texel(map_.at(i + (x + 0.5) / nx, j + (y + 0.5) / ny)), size, part);
    }

private:
    static dvec2 texel(const dvec3& h) {
        const double w = 1 / h.z;
        return {h.x * w, h.y * w};
    }

    /// What one pixel covers of the pixmap along x or y: the derivative of the homography.
    static dvec2 footprint(const dvec2& uv, double w, const dvec3& along) {
        const double by = 1 / w;
        return {(along.x - uv.x * along.z) * by, (along.y - uv.y * along.z) * by};
    }

    int parts(const dvec2& texels) const {
        const double wanted = std::max(std::abs(texels.x), std::abs(texels.y));
        if (wanted <= 1) return 1;
        return wanted < most_parts_ ? static_cast<int>(wanted) + 1 : most_parts_;
    }

    /// The size of a box with the variance of the parallelogram of two footprints.
    static dvec2 box_of(const dvec2& a, const dvec2& b) {
        return {std::sqrt(a.x * a.x + b.x * b.x), std::sqrt(a.y * a.y + b.y * b.y)};
    }

    void to_one_texel(const dvec2& uv, double delta) {
        add(static_cast<int>(inside(uv.x, 0)), static_cast<int>(inside(uv.y, 1)), delta);
    }

    /// A pixel on the border may fall beside the facet: its middle is up to a part of a pixel away.
    double inside(double v, int axis) const {
        return v > facet_.low[axis] ? (v < facet_.high[axis] ? v : facet_.high[axis]) : facet_.low[axis];
    }

    void add(int x, int y, double value) {
        x = std::min(x, pixmap_.width - 1);
        y = std::min(y, pixmap_.height - 1);
        factors_[model_.nearest[pixmap_.first +
                                static_cast<std::size_t>(y) * static_cast<std::size_t>(pixmap_.width) +
                                static_cast<std::size_t>(x)]] += value;
    }

    /// A box moved, and where it is larger cut, into the facet.
    std::pair<double, double> interval(double middle, double size, int axis) const {
        const double low = facet_.low[axis], high = facet_.high[axis], half = size / 2;
        if (!(size < high - low)) return {low, high};
        const double m = middle > low + half ? (middle < high - half ? middle : high - half) : low + half;
        return {m - half, m + half};
    }

    /// The last texel that an interval from texel `first` to `end` touches.
    static int last(int first, double end) {
        const int in = static_cast<int>(end);
        return in > first && in == end ? in - 1 : in;
    }

    void to_box(const dvec2& uv, const dvec2& size, double value) {
        const auto [u0, u1] = interval(uv.x, size.x, 0);
        const auto [v0, v1] = interval(uv.y, size.y, 1);
        const int x0 = static_cast<int>(u0), y0 = static_cast<int>(v0);  // none is below 0
        const int x1 = last(x0, u1), y1 = last(y0, v1);
        if (x1 == x0 && y1 == y0) return add(x0, y0, value);
        const double density = value / ((u1 - u0) * (v1 - v0));
        for (int y = y0; y <= y1; ++y) {
            const double tall = std::min(v1, y + 1.0) - std::max(v0, double(y));
            for (int x = x0; x <= x1; ++x)
                add(x, y, density * tall * (std::min(u1, x + 1.0) - std::max(u0, double(x))));
        }
    }

    const Model& model_;
    const Facet& facet_;
    const Pixmap& pixmap_;
    const Homography map_;
    const int most_parts_;
    std::span<double> factors_;
};

template <class Pixel>
void for_each_pixel(const Region& region, const IdBuffer& buffer, std::uint32_t id, Pixel pixel) {
    for (std::size_t r = 0; r < region.spans.size(); ++r) {
        const int j = region.row + static_cast<int>(r);
        const std::uint32_t* row =
            &buffer.ids[static_cast<std::size_t>(j) * static_cast<std::size_t>(buffer.size)];
        for (int i = region.spans[r].first; i < region.spans[r].end; ++i)
            if (row[i] == id) pixel(i, j);
    }
}

}  // namespace

double scan_pixmap(const Model& model, std::uint32_t pixmap, const Hemicube& hemicube,
                   const IdBuffers& buffers, const DeltaFormFactors& delta, const ScanOptions& options,
                   std::span<double> factors) {
    double backs = 0;
    Region region;
    for (std::uint32_t number : model.pixmaps[pixmap].facets) {
        const Facet& facet = model.facets[number];
        if (dot3(hemicube.normal, facet.center - hemicube.position) < -facet.radius) continue;
        const bool back = dot3(facet.normal, hemicube.position) - facet.offset <= 0;
        for (std::size_t face = 0; face < hemicube_faces; ++face) {
            const IdBuffer& buffer = buffers[face];
            const scene::View& view = hemicube.views[face];
            find_region(facet, view, face == 0, region);
            if (region.spans.empty()) continue;
            const std::vector<double>& pixels = face == 0 ? delta.top : delta.side;
            const auto delta_at = [&](int i, int j) {
                return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(buffer.size) +
                              static_cast<std::size_t>(i)];
            };
            if (back) {
                for_each_pixel(region, buffer, number + 1, [&](int i, int j) { backs += delta_at(i, j); });
                continue;
            }
            FacetScan scan(model, facet, homography(facet, hemicube, view, buffer.size - buffer.rows),
                           options.most_parts, factors);
            for_each_pixel(region, buffer, number + 1,
                           [&](int i, int j) { scan.pixel(i, j, delta_at(i, j)); });
        }
    }
    return backs;
}

double escaping(const IdBuffers& buffers, const DeltaFormFactors& delta) {
    double sum = 0;
    for (std::size_t face = 0; face < hemicube_faces; ++face) {
        const std::vector<double>& pixels = face == 0 ? delta.top : delta.side;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (buffers[face].ids[i] == 0) sum += pixels[i];
    }
    return sum;
}

}  // namespace gw::radiosity
