#include "radiosity/solver/direct_light.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace gw::radiosity {
namespace {

constexpr std::array<dvec3, 6> axes{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// The integral of the unit directions to each element, over the solid angle that the lamp sees of it.
/// A form factor is that of their cosine to the normal, by pi. So the form factors of six hemicubes
/// are its components, and no edge between hemicubes shows.
std::vector<dvec3> directions(const PixmapModel& model, FormFactors& factors, const dvec3& lamp,
                              std::uint64_t turns) {
    const scene::Bounds box = scene::bounds(model.drawn);
    double farthest = 0;
    for (int i = 0; i < 8; ++i) farthest = std::max(farthest, length(scene::corner(box, i) - lamp));
    std::vector<dvec3> sums(model.texel_count(), dvec3(0));
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const Row row = factors.from_points(
            {{.position = lamp, .normal = axes[k], .share = 1, .farthest = farthest}}, turns + k);
        for (std::size_t i = 0; i < row.texels.size(); ++i)
            sums[row.texels[i]] += pi * row.factors[i] * axes[k];
    }
    return sums;
}

/// Of a small element: a cone of half angle a has the solid angle 2 pi (1 - cos a), and its directions
/// add up to pi sin² a.
double solid_angle(double sum) { return 2 * pi * (1 - std::sqrt(std::max(0.0, 1 - sum / pi))); }

DirectLight& of_name(std::vector<DirectLight>& direct, const std::string& name,
                     std::size_t texels) {
    for (DirectLight& light : direct)
        if (light.name == name) return light;
    direct.push_back({name, std::vector(texels, dvec3(0)), dvec3(0), dvec3(0)});
    return direct.back();
}

}  // namespace

void add_direct_light(const scene::Scene& scene, PixmapModel& model,
                      const FormFactorOptions& options) {
    model.direct.clear();
    std::optional<FormFactors> factors;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        if (!light.luminous) continue;
        if (!factors) factors.emplace(model, options);
        const dvec3 lamp(light.position);
        const std::vector<dvec3> sums =
            directions(model, *factors, lamp, model.patches.size() + axes.size() * i);
        const std::string name = light.name.empty() ? "light " + std::to_string(i + 1) : light.name;
        DirectLight& direct = of_name(model.direct, name, model.texel_count());
        const dvec3 emitted = scene::luminous_flux(light);
        dvec3 arrived(0);
        for (std::size_t element = 0; element < sums.size(); ++element) {
            const double sum = length(sums[element]);
            if (sum == 0) continue;
            const dvec3 flux = solid_angle(sum) * scene::intensity(light, sums[element] / sum);
            arrived += flux;
            for (auto t = std::uint32_t(element); t != no_texel; t = model.next_of_element[t])
                direct.H[t] += flux / model.element_area[element];
        }
        direct.emitted += emitted;
        direct.escaped += emitted - arrived;
    }
}

PixmapModel make_lit_model(const scene::Scene& scene, const ModelOptions& options,
                           const FormFactorOptions& form_factors) {
    PixmapModel model = make_model(scene, options);
    add_direct_light(scene, model, form_factors);
    return model;
}

}  // namespace gw::radiosity
