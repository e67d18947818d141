#include "apps/study/difference.h"

#include <algorithm>
#include <cmath>

namespace gw::study {

Fractions fractions(Machine& machine) {
    const double white = double((1u << machine.profile().color_bits) - 1);
    Fractions out;
    for (const Rgba& color : machine.planes().color)
        for (std::size_t c = 0; c < 3; ++c) out.push_back(color[c] / white);
    return out;
}

Difference difference(const Fractions& picture, const Fractions& truth) {
    Difference d;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double e = 255 * (picture[i] - truth[i]);
        d.mean += e;
        d.rms += e * e;
        d.largest = std::max(d.largest, std::abs(e));
    }
    d.mean /= double(truth.size());
    d.rms = std::sqrt(d.rms / double(truth.size()));
    return d;
}

}  // namespace gw::study
