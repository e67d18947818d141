#include "apps/radiosity/files.h"

#include "gw/error.h"
#include "image/layers.h"
#include "radiosity/solver/saved.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

image::Layers layers_of(const radiosity::Saved& saved) {
    image::Layers layers{saved.facts, {}};
    for (const radiosity::SavedPixmap& p : saved.pixmaps)
        layers.layers.push_back({fmt::format("{:05} {}", layers.layers.size(), p.name), p.width,
                                 p.height, radiosity::saved_channels(), p.values});
    return layers;
}

}  // namespace

void put_solution(image::OutputSet& files, const std::filesystem::path& file,
                  const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                  const radiosity::Solution& solution) {
    image::put_layers(files.add(file), layers_of(radiosity::save(model, options, solution)));
}

radiosity::Solution load_solution(const std::filesystem::path& file,
                                  const radiosity::PixmapModel& model,
                                  const radiosity::FormFactorOptions& options) {
    // A pipe has no end that could be waited for.
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        throw Error(file.string(), 0, "is not a regular file; expected one that --save wrote");
    // What it is for is said before what is wrong with its values.
    radiosity::check_saved({image::read_layer_facts(file).facts, {}}, model, options,
                           file.string());
    radiosity::Saved saved;
    image::Layers layers = image::read_layers(file);
    saved.facts = std::move(layers.facts);
    for (image::Layer& layer : layers.layers)
        saved.pixmaps.push_back({layer.name, layer.width, layer.height, std::move(layer.values)});
    return radiosity::load(saved, model, options, file.string());
}

}  // namespace gw::apps
