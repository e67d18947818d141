// A horizon: the highest (or lowest) v so far over u, linear in pieces. Does not project lines.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

class Horizon {
public:
    /// `up`: the highest; else the lowest.
    explicit Horizon(bool up) : sign_(up ? 1 : -1) {}

    /// The parts of a -> b (u, v), a.x < b.x, that are beyond the horizon or over no horizon. Counts
    /// one crossing for every piece of the horizon compared.
    std::vector<Part> beyond(const dvec2& a, const dvec2& b, LineCounts& counts) const;
    /// Raises (lowers) the horizon to the parts of a -> b that are beyond it.
    void raise(const dvec2& a, const dvec2& b);
    /// v at u; none: no horizon there.
    std::optional<double> at(double u) const;
    std::size_t size() const { return pieces_.size(); }

private:
    struct Piece {
        dvec2 a, b;
        double at(double u) const { return a.y + (u - a.x) / (b.x - a.x) * (b.y - a.y); }
    };
    std::size_t first_reaching(double u) const;

    double sign_;
    std::vector<Piece> pieces_;  ///< ascending in u, apart
};

}  // namespace gw::hiddensurface
