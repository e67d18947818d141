#include "apps/radiosity/mix.h"

#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/radiosity/files.h"
#include "apps/radiosity/light_maps.h"
#include "apps/radiosity/lux.h"
#include "apps/radiosity/pictures.h"
#include "gw/escape_controls.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

/// By share; 1 for lamps that are not named.
std::vector<dvec3> factors_of(const std::vector<Strength>& mix,
                              const std::vector<std::string>& lamps) {
    std::vector<dvec3> factors(lamps.size(), dvec3(1));
    for (const Strength& strength : mix) {
        const auto found = std::find(lamps.begin(), lamps.end(), strength.lamp);
        if (found == lamps.end()) {
            std::string known;
            for (const std::string& lamp : lamps) known += (known.empty() ? "" : ", ") + lamp;
            throw UsageError("--mix: no lamp '" + strength.lamp + "'; expected one of " + known);
        }
        factors[std::size_t(found - lamps.begin())] = strength.factor;
    }
    return factors;
}

std::string strengths_text(const std::vector<std::string>& lamps,
                           const std::vector<dvec3>& factors) {
    std::string text;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const dvec3& f = factors[i];
        text += (i > 0 ? ", " : "") + escape_controls(lamps[i]);
        text += f.x == f.y && f.y == f.z ? fmt::format(" {}", f.x)
                                         : fmt::format(" {},{},{}", f.x, f.y, f.z);
    }
    return text;
}

}  // namespace

int show_mix(const RadiosityOptions& options, Session& session, const scene::Scene& scene,
             radiosity::PixmapModel model) {
    const std::vector<std::string> lamps = radiosity::lamps_of(model);
    const std::vector<dvec3> factors = factors_of(options.mix, lamps);
    const std::vector<radiosity::Share> shares =
        load_shares(options.output, model, options.solver.form_factors);
    const radiosity::Solution solution = radiosity::mix(shares, factors, model);
    const Solved mixed{model, solution};
    image::OutputSet files(session.inputs);
    std::string text = RadiosityPictures(options, scene, session).put(mixed, "mixed", files);
    text += lux_lines(options, mixed);
    if (options.light_maps) text += put_light_maps(options, scene, mixed, "mixed_", files);
    put_index(files, options.output, session);
    files.commit();
    print(fmt::format("mixed of {} shots, {:.4f} unshot: {}\n{}", solution.shots,
                      radiosity::books(model, solution).unshot_share(),
                      strengths_text(lamps, factors), text));
    return Done;
}

}  // namespace gw::apps
