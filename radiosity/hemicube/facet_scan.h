// One facet in one face of a hemicube: its pixels, what they cover, and the texels that receive it
// [F2.2].
#pragma once

#include "radiosity/hemicube/region.h"
#include "radiosity/hemicube/scan.h"
#include "radiosity/hemicube/spread.h"

namespace gw::radiosity {

class FacetScan {
public:
    /// For buffers of this size; `factors` as of scan_pixmap.
    FacetScan(int size, std::span<double> factors);

    /// A facet's front. `deltas`: delta form factors of the buffer's pixels. `region`: where its
    /// pixels are.
    void front(const PixmapModel& model, std::uint32_t facet, const Homography& map,
               const IdBuffer& buffer, const Region& region, const std::vector<double>& deltas,
               const ScanOptions& options);

    /// A facet's back: adds the delta form factors of its pixels to `sum`.
    void back(std::uint32_t facet, const IdBuffer& buffer, const Region& region,
              const std::vector<double>& deltas, double& sum);

private:
    /// A pixel that is divided: which of pixels_, and its parts in parts_.
    struct Divided {
        std::size_t pixel, first, end;
    };
    void row(const FacetMap& map, const IdBuffer& buffer, std::uint32_t facet_pixel, int y,
             const double* deltas);
    void divide(const IdBuffer& buffer, std::uint32_t facet_pixel, int y);
    void add_parts(const Divided& divided);

    std::span<double> factors_;
    FacetPixels pixels_;  ///< of one row ...
    Boxes row_;           ///< ... and what they cover
    Parts parts_;
    std::vector<Divided> divided_;
    Boxes boxes_;
};

}  // namespace gw::radiosity
