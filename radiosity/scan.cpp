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
    FacetScan(const Model& model, std::uint32_t number, const IdBuffer& buffer, const Homography& map,
              int most_parts, std::span<double> factors)
        : model_(model),
          facet_(model.facets[number]),
          buffer_(buffer),
          id_(number + 1),
          pixmap_(model.pixmaps[facet_.pixmap]),
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
        parts_.clear();
        const Range in_x = reach(i, j, 1, 0, nx), in_y = reach(i, j, 0, 1, ny);
        for (int y = in_y.begin; y < in_y.end; ++y)
            for (int x = in_x.begin; x < in_x.end; ++x) {
                const dvec2 at = texel(map_.at(i + (x + 0.5) / nx, j + (y + 0.5) / ny));
                if (in_bounds(at)) parts_.push_back(at);
            }
        if (parts_.empty()) parts_.push_back(uv);
        for (const dvec2& at : parts_) to_box(at, size, delta / static_cast<double>(parts_.size()));
    }

private:
    struct Range {
        int begin = 0, end = 0;
    };

    /// The parts of a pixel. Beside one that sees something else the facet may reach on, by half a pixel in
    /// the mean: without these parts, texels there would get nothing.
    Range reach(int i, int j, int dx, int dy, int count) const {
        const int more = (count + 1) / 2;
        return {ends(i - dx, j - dy) ? -more : 0, ends(i + dx, j + dy) ? count + more : count};
    }

    bool in_bounds(const dvec2& uv) const {
        return uv.x >= facet_.low.x && uv.x <= facet_.high.x && uv.y >= facet_.low.y && uv.y <= facet_.high.y;
    }

    bool ends(int i, int j) const {
        if (i < 0 || j < 0 || i >= buffer_.size || j >= buffer_.rows) return false;
        return buffer_.ids[static_cast<std::size_t>(j) * static_cast<std::size_t>(buffer_.size) +
                           static_cast<std::size_t>(i)] != id_;
    }

    /// W is below 0 where the front is seen. A part of a pixel may reach over the plane's horizon: the texel
    /// is then far away, and moved into the facet.
    static dvec2 texel(const dvec3& h) {
        const double w = 1 / (h.z < -1e-30 ? h.z : -1e-30);
        return {h.x * w, h.y * w};
    }

    /// What one pixel covers of the pixmap along x or y: the derivative of the homography.
    static dvec2 footprint(const dvec2& uv, double w, const dvec3& along) {
        const double by = 1 / w;
        return {(along.x - uv.x * along.z) * by, (along.y - uv.y * along.z) * by};
    }

    /// So many that a part covers at most half a texel, and the box of two such footprints a whole one.
    int parts(const dvec2& texels) const {
        const double wanted = 2 * std::max(std::abs(texels.x), std::abs(texels.y));
        if (wanted <= 1) return 1;
        return wanted < most_parts_ ? static_cast<int>(wanted) + 1 : most_parts_;
    }

    /// The box around the parallelogram of two footprints.
    static dvec2 box_of(const dvec2& a, const dvec2& b) {
        return {std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y)};
    }

    void to_one_texel(const dvec2& uv, double delta) {
        const auto at = [&](double v, int axis, int count) {
            return std::min(static_cast<int>(std::clamp(v, facet_.low[axis], facet_.high[axis])), count - 1);
        };
        add(at(uv.x, 0, pixmap_.width), at(uv.y, 1, pixmap_.height), delta);
    }

    void add(int x, int y, double value) {
        const std::size_t t = pixmap_.first +
                              static_cast<std::size_t>(y) * static_cast<std::size_t>(pixmap_.width) +
                              static_cast<std::size_t>(x);
        factors_[pixmap_.whole ? t : model_.nearest[t]] += value;
    }

    /// An interval of texels: the first one, and the parts of the interval in it and in the next.
    struct Cells {
        int first = 0, next = 0;
        double in_first = 0, in_next = 0;
    };

    /// Of an interval at most a texel long, moved, and where it is larger cut, into the facet: a pixel on the
    /// border may fall beside it.
    Cells cells(double middle, double size, int axis, int count) const {
        const double low = facet_.low[axis], high = facet_.high[axis], whole = high - low;
        const double length = size < whole ? size : whole, wanted = middle - length / 2;
        const double limited = wanted < high - length ? wanted : high - length;
        const double begin = limited > low ? limited : low;  // not below 0
        const int at = static_cast<int>(begin), first = at < count ? at : count - 1;
        const double over = begin + length - (first + 1), beyond = over > 0 ? over : 0;
        return {first, first + 1 < count ? first + 1 : first, length - beyond, beyond};
    }

    // Without a branch: which texels a pixel touches cannot be foretold.
    void to_box(const dvec2& uv, const dvec2& size, double value) {
        const Cells u = cells(uv.x, size.x, 0, pixmap_.width), v = cells(uv.y, size.y, 1, pixmap_.height);
        const double density = value / ((u.in_first + u.in_next) * (v.in_first + v.in_next));
        add(u.first, v.first, density * u.in_first * v.in_first);
        add(u.next, v.first, density * u.in_next * v.in_first);
        add(u.first, v.next, density * u.in_first * v.in_next);
        add(u.next, v.next, density * u.in_next * v.in_next);
    }

    const Model& model_;
    const Facet& facet_;
    const IdBuffer& buffer_;
    const std::uint32_t id_;
    const Pixmap& pixmap_;
    const Homography map_;
    const int most_parts_;
    std::span<double> factors_;
    std::vector<dvec2> parts_;  ///< of a pixel, that lie on the facet
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
            FacetScan scan(model, number, buffer,
                           homography(facet, hemicube, view, buffer.size - buffer.rows), options.most_parts,
                           factors);
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
