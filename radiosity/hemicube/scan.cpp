#include "radiosity/hemicube/scan.h"

#include "radiosity/hemicube/facet_scan.h"

namespace gw::radiosity {

double scan_pixmap(const PixmapModel& model, std::uint32_t pixmap, const Hemicube& hemicube,
                   const IdBuffers& buffers, const DeltaFormFactors& delta,
                   const ScanOptions& options, std::span<double> factors) {
    double backs = 0;
    Region region;
    FacetScan scan(buffers[0].size, factors);
    for (std::uint32_t number : model.pixmaps[pixmap].facets) {
        const Facet& facet = model.facets[number];
        if (dot3(hemicube.normal, facet.center - hemicube.position) < -facet.radius) continue;
        const bool back = dot3(facet.normal, hemicube.position) - facet.offset <= 0;
        for (std::size_t face = 0; face < hemicube_faces; ++face) {
            const IdBuffer& buffer = buffers[face];
            const scene::View& view = hemicube.views[face];
            if (!buffer.present[number + 1]) continue;
            find_region(facet, view, face == 0, region);
            const std::vector<double>& deltas = face == 0 ? delta.top : delta.side;
            if (back) {
                scan.back(number, buffer, region, deltas, backs);
                continue;
            }
            const Homography map = homography(facet, hemicube, view, buffer.size - buffer.rows);
            scan.front(model, number, map, buffer, region, deltas, options);
        }
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
