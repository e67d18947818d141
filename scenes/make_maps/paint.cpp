#include "scenes/make_maps/paint.h"

#include <algorithm>

namespace gw::maps {
namespace {

constexpr int points = 4;  // along each side of a texel

Color texel(int x, int y, int width, int height, Color (*at)(dvec2 st)) {
    Color sum(0);
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i) {
            const Color c =
                at({(x + (i + 0.5) / points) / width, (y + (j + 0.5) / points) / height});
            for (int k = 0; k < 3; ++k) sum[k] += std::clamp(c[k], 0.0, 1.0);
        }
    return sum / static_cast<double>(points * points);
}

}  // namespace

image::Picture paint(int width, int height, Color (*at)(dvec2 st)) {
    image::Picture picture{.width = width, .height = height, .values = {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color c = texel(x, y, width, height, at);
            for (int k = 0; k < 3; ++k)
                picture.values.push_back(static_cast<std::uint16_t>(c[k] * 255 + 0.5));
        }
    return picture;
}

Color mix(Color a, Color b, double t) { return a + (b - a) * std::clamp(t, 0.0, 1.0); }

double ramp(double low, double high, double x) {
    return std::clamp((x - low) / (high - low), 0.0, 1.0);
}

Color grey(double v) { return Color(v); }

}  // namespace gw::maps
