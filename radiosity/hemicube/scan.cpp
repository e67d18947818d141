#include "radiosity/hemicube/scan.h"

#include "radiosity/hemicube/footprints.h"

#include <algorithm>

namespace gw::radiosity {
namespace {

/// Boxes that are spread at a time: so few that they stay in the cache.
constexpr std::size_t enough = 512;

std::size_t row_of(const IdBuffer& buffer, int y) {
    return std::size_t(y) * std::size_t(buffer.size);
}

struct Range {
    int first = 0, end = 0;
    int count() const { return end - first; }
};

/// The parts of a pixel along x or y. Beside a pixel that sees something else the facet may reach
/// on, by half a pixel on average. Without these parts, texels there would get nothing.
Range reach(int count, bool ends_before, bool ends_after) {
    const int more = (count + 1) / 2;
    return {ends_before ? -more : 0, ends_after ? count + more : count};
}

/// One facet in one face of a hemicube: its pixels, their footprints, and the texels that receive
/// their light [F2.2].
class FacetScan {
public:
    /// For buffers of this size; `factors` as of scan_pixels.
    FacetScan(int size, std::span<double> factors, PixelScratch& scratch);

    /// A facet's front. `deltas`: delta form factors of the buffer's pixels. `region`: the pixels
    /// that can see it.
    void front(const PixmapModel& model, std::uint32_t facet, const Homography& map,
               const IdBuffer& buffer, const Region& region, const std::vector<double>& deltas,
               const ScanOptions& options);

    /// A facet's back: adds the delta form factors of its pixels to `sum`.
    void back(std::uint32_t facet, const IdBuffer& buffer, const Region& region,
              const std::vector<double>& deltas, double& sum);

private:
    using Divided = PixelScratch::Divided;
    void row(const FacetMap& map, const IdBuffer& buffer, std::uint32_t facet_pixel, int y,
             const double* deltas);
    void divide(const IdBuffer& buffer, std::uint32_t facet_pixel, int y);
    void add_parts(const Divided& divided);

    std::span<double> factors_;
    FacetPixels& pixels_;
    Boxes& row_;
    Parts& parts_;
    std::vector<Divided>& divided_;
    Boxes& boxes_;
};

FacetScan::FacetScan(int size, std::span<double> factors, PixelScratch& scratch)
    : factors_(factors),
      pixels_(scratch.pixels),
      row_(scratch.row),
      parts_(scratch.parts),
      divided_(scratch.divided),
      boxes_(scratch.boxes) {
    pixels_.reserve(std::size_t(size));
    row_.reserve(std::size_t(size));
}

void FacetScan::front(const PixmapModel& model, std::uint32_t number, const Homography& map,
                      const IdBuffer& buffer, const Region& region,
                      const std::vector<double>& deltas, const ScanOptions& options) {
    const Facet& facet = model.facets[number];
    const Pixmap& pixmap = model.pixmaps[facet.pixmap];
    const FacetMap facet_map{map,
                             {facet.low.x, facet.high.x, pixmap.width},
                             {facet.low.y, facet.high.y, pixmap.height},
                             options.most_parts};
    const std::uint32_t facet_pixel = pixel_of(number);
    const TexelSums sums{factors_.data(), pixmap.first,
                         pixmap.whole ? nullptr : model.nearest.data()};
    for (std::size_t r = 0; r < region.spans.size(); ++r) {
        const int y = region.row + static_cast<int>(r);
        const std::size_t start = row_of(buffer, y);
        const Region::Span& span = region.spans[r];
        find_pixels(&buffer.pixels[start], span.first, span.end, facet_pixel, pixels_);
        if (pixels_.count > 0) row(facet_map, buffer, facet_pixel, y, &deltas[start]);
        if (boxes_.count >= enough) spread(facet_map, boxes_, sums);
    }
    spread(facet_map, boxes_, sums);
}

void FacetScan::row(const FacetMap& map, const IdBuffer& buffer, std::uint32_t facet_pixel, int y,
                    const double* deltas) {
    divided_.clear();
    parts_.count = 0;
    if (find_footprints(map, y, deltas, pixels_, row_)) divide(buffer, facet_pixel, y);
    find_parts(map, parts_);
    boxes_.reserve(row_.count + parts_.count);
    std::size_t next = 0;
    for (const Divided& divided : divided_) {
        append(row_, next, divided.pixel, boxes_);
        add_parts(divided);
        next = divided.pixel + 1;
    }
    append(row_, next, row_.count, boxes_);
}

/// Pixels that cover more than a texel, and those at an end that may.
void FacetScan::divide(const IdBuffer& buffer, std::uint32_t facet_pixel, int y) {
    // Whether a pixel sees something else; beyond the face's border the facet goes on.
    const std::uint32_t* const row = &buffer.pixels[row_of(buffer, y)];
    const std::uint32_t* const row_below = y > 0 ? row - buffer.size : nullptr;
    const std::uint32_t* const row_above = y + 1 < buffer.rows ? row + buffer.size : nullptr;
    for (std::size_t i = 0; i < pixels_.count; ++i) {
        const int x = pixels_.x[i], nx = pixels_.nx[i], ny = pixels_.ny[i];
        if (row_.texels_across[i] == 2) continue;
        const bool left = x > 0 && row[x - 1] != facet_pixel,
                   right = x + 1 < buffer.size && row[x + 1] != facet_pixel,
                   below = row_below && row_below[x] != facet_pixel,
                   above = row_above && row_above[x] != facet_pixel;
        if (nx * ny == 1 && !left && !right && !below && !above) continue;
        const Range columns = reach(nx, left, right), rows = reach(ny, below, above);
        parts_.reserve(std::size_t(columns.count()) * std::size_t(rows.count()));
        divided_.push_back({i, parts_.count, 0});
        for (int j = rows.first; j < rows.end; ++j) {
            const double middle = y + (j + 0.5) / ny;
            for (int k = columns.first; k < columns.end; ++k) {
                parts_.x[parts_.count] = x + (k + 0.5) / nx;
                parts_.y[parts_.count++] = middle;
            }
        }
        divided_.back().end = parts_.count;
    }
}

/// Those of a pixel's parts that fall on the facet; if none does, the pixel's middle.
void FacetScan::add_parts(const Divided& divided) {
    const std::size_t first = boxes_.count, pixel = divided.pixel;
    std::size_t next = first;
    for (std::size_t i = divided.first; i < divided.end; ++i) {
        boxes_.u[next] = parts_.u[i];
        boxes_.v[next] = parts_.v[i];
        next += std::size_t(parts_.inside[i]);
    }
    if (next == first) {
        boxes_.u[first] = row_.u[pixel];
        boxes_.v[first] = row_.v[pixel];
        ++next;
    }
    const double value = row_.value[pixel] / static_cast<double>(next - first);
    for (std::size_t i = first; i < next; ++i) {
        boxes_.width[i] = row_.width[pixel];
        boxes_.height[i] = row_.height[pixel];
        boxes_.value[i] = value;
        boxes_.texels_across[i] = 3;
    }
    boxes_.count = next;
}

void FacetScan::back(std::uint32_t facet, const IdBuffer& buffer, const Region& region,
                     const std::vector<double>& deltas, double& sum) {
    for (std::size_t r = 0; r < region.spans.size(); ++r) {
        const std::size_t start = row_of(buffer, region.row + static_cast<int>(r));
        find_pixels(&buffer.pixels[start], region.spans[r].first, region.spans[r].end,
                    pixel_of(facet), pixels_);
        for (std::size_t i = 0; i < pixels_.count; ++i)
            sum += deltas[start + std::size_t(pixels_.x[i])];
    }
}

}  // namespace

double scan_pixels(const PixmapModel& model, std::uint32_t number, const Hemicube& hemicube,
                   const IdBuffers& buffers, const DeltaFormFactors& delta,
                   const ScanOptions& options, std::span<double> factors, PixelScratch& scratch) {
    const Facet& facet = model.facets[number];
    if (dot3(hemicube.normal, facet.center - hemicube.position) < -facet.radius) return 0;
    double backs = 0;
    FacetScan scan(buffers[0].size, factors, scratch);
    const bool back = dot3(facet.normal, hemicube.position) - facet.offset <= 0;
    for (std::size_t face = 0; face < hemicube_faces; ++face) {
        const IdBuffer& buffer = buffers[face];
        const scene::View& view = hemicube.views[face];
        if (!buffer.present[number + 1]) continue;
        find_region(facet, view, face == 0, scratch.region);
        const std::vector<double>& deltas = face == 0 ? delta.top : delta.side;
        if (back) {
            scan.back(number, buffer, scratch.region, deltas, backs);
            continue;
        }
        const Homography map = homography(facet, hemicube, view, buffer.size - buffer.rows);
        scan.front(model, number, map, buffer, scratch.region, deltas, options);
    }
    return backs;
}

double escaping(const IdBuffers& buffers, const DeltaFormFactors& delta) {
    double sum = 0;
    for (std::size_t face = 0; face < hemicube_faces; ++face) {
        if (!buffers[face].present[0]) continue;
        const std::vector<double>& pixels = face == 0 ? delta.top : delta.side;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (buffers[face].pixels[i] == nothing) sum += pixels[i];
    }
    return sum;
}

}  // namespace gw::radiosity
