// Radiosity: states of the light, and pictures of them.
#include "gw/base/elementary.h"
#include "gw/error.h"
#include "radiosity/display/display.h"
#include "web/engine/method.h"
#include "web/engine/rgba.h"

#include <algorithm>
#include <cmath>

namespace gw::lab {
namespace {

image::Tone tone_of(const Json& options) { return {.gamma = options.value("gamma", 1.0)}; }

double scale_of(const Lighting& lighting, const Json& options) {
    return pow(2, options.value("exposure", 0.0)) *
           radiosity::scale_of_white(lighting.solver().model().drawn);
}

radiosity::DisplayedPixmaps colors_of(const Lighting& lighting, const Json& options) {
    const radiosity::Solver& solver = lighting.solver();
    return radiosity::displayed_pixmaps(solver.model(), solver.solution(),
                                        options.value("ambient", true));
}

/// To nearest, of 16 bits.
std::uint16_t value16(double v) {
    return std::uint16_t(std::lround(std::clamp(v, 0.0, 1.0) * 65535));
}

}  // namespace

Json LabSession::light(const Json& options) {
    auto& lighting = lightings_.at(options.value("resolved", false) ? 1 : 0);
    if (!lighting || !lighting->go_on(options)) {
        lighting.reset();
        lighting = std::make_unique<Lighting>(scene_for(options), options);
    }
    return lighting->facts(options);
}

const Lighting& LabSession::lighting_of(const Json& options) const {
    const auto& lighting = lightings_.at(options.value("resolved", false) ? 1 : 0);
    if (!lighting) throw Error("nothing is lit; expected a state of light first");
    return *lighting;
}

Json LabSession::lit(const Json& options) {
    const Lighting& lighting = lighting_of(options);
    Machine& machine = machine_for(options);
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    machine.execute(radiosity::texture_list(lighting.solver().model(), colors_of(lighting, options),
                                            view, {scale_of(lighting, options), scene.background}));
    const Planes& planes = machine.planes();
    picture_ = rgba_of(image::toned(
        image::picture_of(planes.color, view.width, view.height, machine.profile().color_bits),
        tone_of(options)));
    return Json::object();
}

Json LabSession::pixmap(const Json& options) {
    const Lighting& lighting = lighting_of(options);
    const std::uint32_t number = options.at("pixmap");
    const radiosity::Pixmap& pixmap = lighting.solver().model().pixmaps.at(number);
    const radiosity::DisplayedPixmaps colors = colors_of(lighting, options);
    const double scale = scale_of(lighting, options);
    image::Picture picture{.width = pixmap.width, .height = pixmap.height, .bits = 16};
    for (int y = 0; y < pixmap.height; ++y)
        for (int x = 0; x < pixmap.width; ++x)
            for (int c = 0; c < 3; ++c)
                picture.values.push_back(value16(scale * colors.at(number, x, y)[c]));
    picture_ = rgba_of(image::toned(picture, tone_of(options)));
    return Json::object();
}

Json LabSession::hemicube(const Json& options) {
    picture_ = rgba_of(lighting_of(options).hemicube(options.at("patch"), options.at("point")));
    return Json::object();
}

const Method radiosity_methods[] = {
    {"light", &LabSession::light},
    {"lit", &LabSession::lit, {{"picture", &LabSession::picture}}},
    {"pixmap", &LabSession::pixmap, {{"picture", &LabSession::picture}}},
    {"hemicube", &LabSession::hemicube, {{"picture", &LabSession::picture}}},
};

}  // namespace gw::lab
