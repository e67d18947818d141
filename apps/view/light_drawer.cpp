#include "apps/view/light_drawer.h"

#include "gw/base/elementary.h"
#include "gw/machine.h"
#include "radiosity/display/display.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>

namespace gw::apps {

Machine& LightDrawer::machine_for(const scene::View& view) {
    if (!machine_ || view.width != width_ || view.height != height_) {
        machine_ = make_fast(ideal(), view.width, view.height, {.threads = threads_});
        width_ = view.width;
        height_ = view.height;
    }
    machine_->reset_passes();
    return *machine_;
}

image::Picture LightDrawer::draw(const Light& light, const scene::View& view,
                                 const vec3& background, double exposure) {
    Machine& machine = machine_for(view);
    const double scale = gw::pow(2, exposure) * radiosity::scale_of_white(light.model->drawn);
    machine.execute(
        radiosity::texture_list(*light.model, *light.colors, view, {scale, background}));
    return image::picture_of(machine.planes().color, view.width, view.height,
                             machine.profile().color_bits);
}

std::optional<std::size_t> LightDrawer::figure_at(const Light& light, const scene::View& view,
                                                  int x, int y) {
    Machine& machine = machine_for(view);
    machine.execute(radiosity::figures_of(
        radiosity::texture_list(*light.model, *light.colors, view, {.background = vec3(0)})));
    const std::uint32_t id = scene::id_of(machine.planes().color.at(view.index(x, y)));
    if (id == 0) return {};
    const auto& figures = light.model->figures;
    const auto found = std::ranges::find(figures, id - 1, &radiosity::Figure::pixmap);
    if (found == figures.end()) return {};
    return std::size_t(found - figures.begin());
}

}  // namespace gw::apps
