// Curved figures cut into pieces, each of one facet and of a quarter of a texel. A facet of a sphere
// is often smaller than a pixel of an ID buffer: then its pieces are what a hemicube looks for.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <span>
#include <vector>

namespace gw::radiosity {

struct Piece {
    std::uint32_t texel = 0;
    float share = 0;  ///< of the texel
    dvec2 middle{0};  ///< in texels
};

class Pieces {
public:
    Pieces() = default;
    explicit Pieces(const PixmapModel& model);

    /// Of a facet; none if its pixmap is not curved.
    std::span<const Piece> of(std::uint32_t facet) const {
        if (first_.empty()) return {};
        return std::span(pieces_).subspan(first_[facet], first_[facet + 1] - first_[facet]);
    }

private:
    std::vector<Piece> pieces_;
    std::vector<std::size_t> first_;  ///< by facet, and the end
};

}  // namespace gw::radiosity
