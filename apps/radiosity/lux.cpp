#include "apps/radiosity/lux.h"

#include "apps/command/command.h"
#include "gw/escape_controls.h"
#include "radiosity/display/nearest_point.h"
#include "radiosity/model/figures.h"
#include "radiosity/solver/direct_light.h"

#include <fmt/format.h>

namespace gw::apps {

radiosity::PixmapModel lit_model(const scene::Scene& scene, const RadiosityOptions& options) {
    return radiosity::make_lit_model(scene, options.model, options.solver.form_factors);
}

void check_lux(const RadiosityOptions& options, const scene::Scene& scene) {
    if (scene.white > 0 || (!options.lux && options.lux_at.empty())) return;
    throw UsageError(
        "--lux: the scene's light has no unit; expected white = {lux = 500} in it, or another one");
}

std::string lux_lines(const RadiosityOptions& options, const Solved& solved) {
    if (options.lux_at.empty()) return "";
    const radiosity::PixmapModel& model = solved.model;
    const radiosity::DisplayedPixmaps light =
        radiosity::displayed_irradiance(model, solved.solution, !options.no_ambient);
    std::string text;
    for (const dvec3& point : options.lux_at) {
        const radiosity::SurfacePoint at = radiosity::nearest_point(model, point);
        const radiosity::Facet& facet = model.facets[at.facet];
        text += fmt::format("{:.5g} lux on {}, {:.3g} from the point\n",
                            scene::luminance_of(light.at(facet.pixmap, at.uv)),
                            escape_controls(model.figures[facet.figure].name), at.distance);
    }
    return text;
}

}  // namespace gw::apps
