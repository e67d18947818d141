#include "apps/radiosity_pictures.h"

#include "gw/arithmetic.h"
#include "gw/elementary.h"
#include "image/picture.h"
#include "image/write.h"
#include "multipass/driver.h"
#include "radiosity/display.h"

#include <fmt/format.h>

#include <cstdlib>

namespace gw::apps {

namespace {

/// Eight bits are what pictures are looked at with.
image::Picture to_picture(const std::vector<Rgba>& color, const scene::View& view, int bits, double gamma) {
    image::Picture picture =
        image::toned(image::picture_of(color, view.width, view.height, bits), {.gamma = gamma});
    for (std::uint16_t& v : picture.values) v = static_cast<std::uint16_t>(rescale(v, bits, 8));
    picture.bits = 8;
    return picture;
}

struct Difference {
    image::Picture picture;  ///< sixteen times too bright
    double mean = 0;         ///< of 255
    int largest = 0;
};

Difference difference(const image::Picture& a, const image::Picture& b) {
    Difference d{a};
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const int off = std::abs(int(a.values[i]) - int(b.values[i]));
        sum += off;
        d.largest = std::max(d.largest, off);
        d.picture.values[i] = static_cast<std::uint16_t>(std::min(255, 16 * off));
    }
    d.mean = sum / static_cast<double>(a.values.size());
    return d;
}

std::filesystem::path with_ending(std::filesystem::path stem, const char* ending) { return stem += ending; }

}  // namespace

RadiosityPictures::RadiosityPictures(const RadiosityOptions& options, const scene::Scene& scene)
    : options_(options),
      scene_(scene),
      profile_(load_profile(options.picture)),
      machine_(make_machine(options.picture, profile_)) {
    std::vector<scene::Camera> cameras(std::max<std::size_t>(1, options.views.size()), *scene.camera);
    for (std::size_t i = 0; i < options.views.size(); ++i) {
        std::tie(cameras[i].eye, cameras[i].at) = options.views[i];
        cameras[i].near_plane = cameras[i].far_plane = 0;  // fitted to the scene
    }
    const scene::Bounds bounds = scene::bounds(scene);
    for (const scene::Camera& camera : cameras)
        views_.push_back(
            scene::make_view(camera, bounds, options.picture.size.width, options.picture.size.height));
}

std::vector<Rgba> RadiosityPictures::draw(const radiosity::Solver& solver, const std::vector<dvec3>& colors,
                                          const scene::View& view, bool strips) {
    const radiosity::Brightness brightness{pow(2, options_.exposure), scene_.background};
    machine_->execute(
        strips ? radiosity::strip_list(solver.model(), colors, view, brightness, options_.picture.threads)
               : radiosity::texture_list(solver.model(), colors, view, brightness));
    machine_->reset_passes();
    std::vector<Rgba> color = machine_->planes().color;
    if (options_.specular) add_components(view, color);
    return color;
}

// [F4, K3] What radiosity leaves out, by the passes of equation 2, added in the frame buffer.
void RadiosityPictures::add_components(const scene::View& view, std::vector<Rgba>& color) {
    scene::Scene rest = scene_;
    rest.background = vec3(0);
    for (scene::Material& m : rest.materials) m.Ka = m.Kd = m.Ke = vec3(0);
    multipass::render(*machine_, rest, view, {});
    State add;
    add.blend = {.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
    CommandList list;
    list.add(SetState{add});
    list.add(WritePixels{.rect = {0, 0, view.width, view.height}, .colors = color});
    machine_->execute(list);
    color = machine_->planes().color;
}

std::string RadiosityPictures::put_view(const radiosity::Solver& solver, const scene::View& view,
                                        const std::filesystem::path& stem, image::OutputSet& files) {
    const std::vector<dvec3> colors =
        radiosity::shown(solver.model(), solver.solution(), !options_.no_ambient);
    const auto picture = [&](bool strips) {
        return to_picture(draw(solver, colors, view, strips), view, profile_.color_bits, options_.gamma);
    };
    if (options_.display != "both") {
        image::put_picture(files.add(with_ending(stem, ".png")), picture(options_.display == "strips"));
        return "";
    }
    const image::Picture texture = picture(false), strips = picture(true);
    const Difference d = difference(texture, strips);
    image::put_picture(files.add(with_ending(stem, "_texture.png")), texture);
    image::put_picture(files.add(with_ending(stem, "_strips.png")), strips);
    image::put_picture(files.add(with_ending(stem, "_difference.png")), d.picture);
    return fmt::format("{}: texture and strips differ by {:.3f} of 255 in the mean, {} at most\n",
                       stem.filename().string(), d.mean, d.largest);
}

std::string RadiosityPictures::put(const radiosity::Solver& solver, const std::string& name,
                                   image::OutputSet& files) {
    std::string text;
    for (std::size_t i = 0; i < views_.size(); ++i)
        text +=
            put_view(solver, views_[i],
                     options_.output / (views_.size() > 1 ? fmt::format("{}_{}", name, i + 1) : name), files);
    return text;
}

}  // namespace gw::apps
