// Pictures of a light [F2.3], and the figures that their pixels show. Does not solve.
#pragma once

#include "apps/view/light_worker.h"
#include "image/picture.h"
#include "scene/draw/view.h"

#include <memory>
#include <optional>

namespace gw::apps {

class LightDrawer {
public:
    explicit LightDrawer(int threads) : threads_(threads) {}

    /// The radiosity by the scene's white, times 2^exposure, from the view, on the profile `ideal`.
    image::Picture draw(const Light& light, const scene::View& view, const vec3& background,
                        double exposure);
    /// The number in PixmapModel::figures of the figure at a pixel of the view, rows from the bottom.
    std::optional<std::size_t> figure_at(const Light& light, const scene::View& view, int x, int y);

private:
    Machine& machine_for(const scene::View& view);

    int threads_;
    int width_ = 0, height_ = 0;
    std::unique_ptr<Machine> machine_;
};

}  // namespace gw::apps
