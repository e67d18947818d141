#include "apps/study/hemicube.h"

#include "gw/base/elementary.h"
#include "radiosity/hemicube/form_factors.h"
#include "radiosity/model/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace gw::study {
namespace {

constexpr double half = 1;     ///< the wall is a square from -half to half, at distance 1
constexpr double texels = 16;  ///< per unit

radiosity::PixmapModel wall() {
    scene::Scene scene{.name = "wall"};
    scene.materials.push_back({.name = "light", .Kd = vec3(0), .Ke = vec3(1)});
    const float h = float(half);
    scene.objects.push_back(
        {.name = "wall",
         .mesh = make_mesh({.primitive = Primitive::Quads,
                            .positions = {{-h, 1, -h}, {h, 1, -h}, {h, 1, h}, {-h, 1, h}}})});
    return radiosity::make_model(scene, {.texels_per_unit = texels});
}

/// Howell B-4 as an indefinite integral: a point's form factor to a rectangle at distance 1
/// parallel to it.
double corner(double x, double y) {
    const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
    return (x / a * atan2(y / a, 1) + y / b * atan2(x / b, 1)) / (2 * pi);
}

std::vector<double> exact(const radiosity::PixmapModel& model) {
    std::vector<double> factors(model.texel_count());
    const radiosity::Facet& facet = model.facets.front();
    for (int y = 0; y < model.pixmaps[0].height; ++y)
        for (int x = 0; x < model.pixmaps[0].width; ++x) {
            const dvec3 p = facet.at(dvec2(x, y)), q = facet.at(dvec2(x + 1, y + 1));
            factors[model.pixmaps[0].texel(x, y)] = std::abs((corner(q.x, q.z) - corner(p.x, q.z)) -
                                                             (corner(q.x, p.z) - corner(p.x, p.z)));
        }
    return factors;
}

struct Deviation {
    double squares = 0, missed = 0;
};

Deviation deviation(const radiosity::PixmapModel& model, const std::vector<double>& truth, int size,
                    int parts, int turn) {
    radiosity::FormFactors factors(model, {.hemicube = size,
                                           .scan = {.most_parts = parts},
                                           .seed = static_cast<std::uint64_t>(turn)});
    const radiosity::Row row = factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0);
    std::vector<double> found(truth.size());
    for (std::size_t i = 0; i < row.texels.size(); ++i) found[row.texels[i]] = row.factors[i];
    Deviation d;
    for (std::size_t t = 0; t < truth.size(); ++t) {
        d.squares += (found[t] / truth[t] - 1) * (found[t] / truth[t] - 1);
        d.missed += found[t] == 0 ? 1 : 0;
    }
    return d;
}

plot::Series series(const std::vector<HemicubeError>& rows, const char* name,
                    double HemicubeError::*value) {
    plot::Series line{.name = name, .points = {}};
    for (const HemicubeError& row : rows)
        if (row.*value > 0) line.points.push_back({double(row.size), row.*value});
    return line;
}

}  // namespace

std::vector<HemicubeError> hemicube_errors(const std::vector<int>& sizes, int turns,
                                           const std::function<void(const std::string&)>& say) {
    const radiosity::PixmapModel model = wall();
    const std::vector<double> truth = exact(model);
    const double count = double(truth.size()) * turns;
    std::vector<HemicubeError> rows;
    for (const int size : sizes) {
        say(fmt::format("hemicube {}", size));
        HemicubeError row{.size = size, .pixels = size / (2 * texels)};
        for (int turn = 0; turn < turns; ++turn) {
            const Deviation drawn = deviation(model, truth, size, 1, turn),
                            oversampled = deviation(model, truth, size, 64, turn);
            row.rms_drawn += drawn.squares / count;
            row.rms_oversampled += oversampled.squares / count;
            row.missed_drawn += drawn.missed / count;
            row.missed_oversampled += oversampled.missed / count;
        }
        row.rms_drawn = std::sqrt(row.rms_drawn);
        row.rms_oversampled = std::sqrt(row.rms_oversampled);
        rows.push_back(row);
    }
    return rows;
}

plot::Plot hemicube_plot(const std::vector<HemicubeError>& rows) {
    plot::Plot plot{.title = "Form factors of texels: error against hemicube resolution",
                    .caption = fmt::format(
                        "A point before a wall of {0} x {0} texels at distance 1; n = {1:.0f} "
                        "pixels across a texel at the right end.",
                        int(2 * half * texels), rows.back().pixels),
                    .x = {.label = "pixels across the hemicube", .log = 2},
                    .y = {.label = "share", .log = 10}};
    for (const auto& [name, value] :
         {std::pair{"rms error, as drawn", &HemicubeError::rms_drawn},
          {"rms error, oversampled", &HemicubeError::rms_oversampled},
          {"texels missed, as drawn", &HemicubeError::missed_drawn},
          {"texels missed, oversampled", &HemicubeError::missed_oversampled}}) {
        plot::Series line = series(rows, name, value);
        if (!line.points.empty()) plot.series.push_back(std::move(line));
    }
    return plot;
}

}  // namespace gw::study
