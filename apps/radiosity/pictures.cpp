#include "apps/radiosity/pictures.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "image/picture.h"
#include "image/plane_pictures.h"
#include "image/plot/markup.h"
#include "image/write.h"
#include "itembuffer/render.h"
#include "itembuffer/traced_component.h"
#include "multipass/frame/driver.h"
#include "radiosity/display/emissive_scene.h"
#include "scene/draw/draw_commands.h"
#include "scene/draw/item_buffer.h"
#include "scene/draw/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace gw::apps {
namespace {

image::Picture to_picture(const std::vector<Rgba>& color, const scene::View& view, int bits,
                          double gamma) {
    return image::toned(image::picture_of(color, view.width, view.height, bits), {.gamma = gamma});
}

image::Picture in_eight_bits(image::Picture picture) {
    for (std::uint16_t& v : picture.values)
        v = static_cast<std::uint16_t>(rescale(v, picture.bits, 8));
    picture.bits = 8;
    return picture;
}

struct Difference {
    image::Picture picture;  ///< sixteen times too bright
    double mean = 0;         ///< of 255, over pixels that show the same figure in both
    int largest = 0;
    int others = 0;  ///< pixels that show different figures
};

/// Vertices are snapped, so a strip's outline may lie a 256th of a pixel beside its triangle's.
/// A pixel whose centre lies between the two shows another figure; `others` marks these pixels.
/// Pictures of eight bits.
Difference difference(const image::Picture& a, const image::Picture& b,
                      const std::vector<bool>& others) {
    Difference d{.picture = a};
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const bool other = others[i / a.channels];
        const int off = std::abs(int(a.values[i]) - int(b.values[i]));
        d.picture.values[i] = static_cast<std::uint16_t>(std::min(255, 16 * off));
        if (i % a.channels == 0) d.others += other ? 1 : 0;
        if (other) continue;
        sum += off;
        d.largest = std::max(d.largest, off);
    }
    d.mean = sum / static_cast<double>(a.values.size());
    return d;
}

std::filesystem::path with_ending(std::filesystem::path stem, const char* ending) {
    return stem += ending;
}

/// The largest channel of all texels, or of those only that do not emit.
double brightest(const radiosity::PixmapModel& model, const radiosity::DisplayedPixmaps& colors,
                 bool emitters) {
    double most = 0;
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p)
        for (int y = 0; y < model.pixmaps[p].height; ++y)
            for (int x = 0; x < model.pixmaps[p].width; ++x)
                if (emitters || model.E[model.pixmaps[p].texel(x, y)] == dvec3(0))
                    for (int c = 0; c < 3; ++c) most = std::max(most, colors.at(p, x, y)[c]);
    return most;
}

std::vector<bool> other_figures(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
    std::vector<bool> others;
    for (std::size_t i = 0; i < a.size(); ++i)
        others.push_back(scene::id_of(a[i]) != scene::id_of(b[i]));
    return others;
}

}  // namespace

radiosity::DisplayedPixmaps displayed(const Solved& solved, const RadiosityOptions& options) {
    return radiosity::displayed_pixmaps(solved.model, solved.solution, !options.no_ambient);
}

double shown_scale(const RadiosityOptions& options, const scene::Scene& scene) {
    return pow(2, options.exposure) * radiosity::scale_of_white(scene);
}

RadiosityPictures::RadiosityPictures(const RadiosityOptions& options, const scene::Scene& scene,
                                     Session& session)
    : options_(options),
      scene_(scene),
      profile_(load_profile(options.picture, session)),
      machine_(make_machine(options.picture, profile_, session)) {
    std::vector<scene::Camera> cameras(std::max<std::size_t>(1, options.views.size()),
                                       *scene.camera);
    for (std::size_t i = 0; i < options.views.size(); ++i) {
        std::tie(cameras[i].eye, cameras[i].at) = options.views[i];
        cameras[i].near_plane = cameras[i].far_plane = 0;  // fitted to the scene
    }
    const scene::Bounds bounds = scene::bounds(scene);
    for (const scene::Camera& camera : cameras)
        views_.push_back(scene::fitted_view(camera, scene, bounds, options.picture.size.width,
                                            options.picture.size.height));
}

RadiosityPictures::Image RadiosityPictures::draw(const radiosity::PixmapModel& model,
                                                 const radiosity::DisplayedPixmaps& colors,
                                                 const scene::View& view, bool strips) {
    const radiosity::Brightness brightness{shown_scale(options_, scene_), scene_.background};
    const CommandList list =
        strips ? radiosity::strip_list(model, colors, view, brightness, options_.picture.threads)
               : radiosity::texture_list(model, colors, view, brightness);
    const auto drawn = [&](const CommandList& commands) {
        machine_->execute(commands);
        machine_->reset_passes();
        return machine_->planes().color;
    };
    Image image;
    if (options_.display == "both") image.figures = drawn(radiosity::figures_of(list));
    image.color = options_.specular ? with_components(model, colors, view) : drawn(list);
    return image;
}

// [F4, K4] Adds specular and traced components with the passes of equations 2 and 5, over the scene
// whose pixmaps emit their radiosity.
std::vector<Rgba> RadiosityPictures::with_components(const radiosity::PixmapModel& model,
                                                     const radiosity::DisplayedPixmaps& colors,
                                                     const scene::View& view) {
    const scene::Scene all =
        radiosity::emissive_scene(scene_, model, colors, shown_scale(options_, scene_));
    const scene::Scene seen = radiosity::without_backs(all, view.camera);
    multipass::Options passes;
    std::optional<raytrace::World> world;
    if (raytrace::any_traced(all)) {
        world.emplace(all, options_.picture.threads);
        passes.pass_list = itembuffer::passes_with_tracing(seen, passes.translucency);
        // First hits come from the drawn scene; second rays also meet faces that turn their backs
        // to the eye.
        passes.trace = [&](Machine& machine, const scene::Scene& now, const scene::View& at,
                           const JitterState& jitter) {
            const auto ids = scene::draw_item_buffer(machine, now, at, jitter);
            const raytrace::Tracer tracer(all, *world, at, {.threads = options_.picture.threads});
            return itembuffer::traced_component(tracer, now, at, ids, jitter, machine.profile())
                .color;
        };
    }
    multipass::render(*machine_, raytrace::drawn_scene(seen), view, passes);
    machine_->reset_passes();
    return machine_->planes().color;
}

std::string RadiosityPictures::put_view(const Solved& solved, const scene::View& view,
                                        const std::filesystem::path& stem,
                                        image::OutputSet& files) {
    const radiosity::DisplayedPixmaps colors = displayed(solved, options_);
    const auto picture = [&](const Image& image) {
        return to_picture(image.color, view, profile_.color_bits, options_.gamma);
    };
    if (options_.display != "both") {
        const Image image = draw(solved.model, colors, view, options_.display == "strips");
        image::put_picture(files.add(with_ending(stem, ".png")), picture(image));
        return "";
    }
    const Image texture = draw(solved.model, colors, view, false),
                strips = draw(solved.model, colors, view, true);
    const Difference d = difference(in_eight_bits(picture(texture)), in_eight_bits(picture(strips)),
                                    other_figures(texture.figures, strips.figures));
    image::put_picture(files.add(with_ending(stem, "_texture.png")), picture(texture));
    image::put_picture(files.add(with_ending(stem, "_strips.png")), picture(strips));
    image::put_picture(files.add(with_ending(stem, "_difference.png")), d.picture);
    return fmt::format(
        "{}: texture and strips differ by {:.3f} of 255 in the mean, {} at most; {} pixels on "
        "outlines show another figure\n",
        stem.filename().string(), d.mean, d.largest, d.others);
}

/// Drawn so that the brightest value is white: the frame buffer cuts none off.
std::vector<dvec3> RadiosityPictures::drawn_values(const Solved& solved,
                                                   const radiosity::DisplayedPixmaps& colors,
                                                   const scene::View& view, double most) {
    machine_->execute(
        radiosity::texture_list(solved.model, colors, view, {.scale = most > 0 ? 1 / most : 1}));
    machine_->reset_passes();
    const std::uint32_t white = max_of_bits(profile_.color_bits);
    std::vector<dvec3> values;
    for (const Rgba& color : machine_->planes().color)
        values.push_back({most * double(color[0]) / white, most * double(color[1]) / white,
                          most * double(color[2]) / white});
    return values;
}

/// The colours of part_colors with their values.
std::string scale_svg(double red, const std::string& what) {
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"460\" height=\"62\" "
        "font-family=\"sans-serif\" font-size=\"13\" text-anchor=\"middle\">\n<rect width=\"460\" "
        "height=\"62\" fill=\"#fff\"/>\n<linearGradient id=\"scale\">";
    constexpr std::array colors{"#0000ff", "#00ffff", "#00ff00", "#ffff00", "#ff0000"};
    std::string labels;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const double part = double(i) / 4;
        svg += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>", part, colors[i]);
        labels += fmt::format("<text x=\"{}\" y=\"50\">{:.4g}{}</text>\n", 40 + 380 * part,
                              red * part, i == 0 ? " " + plot::escaped(what) : "");
    }
    return svg +
           "</linearGradient>\n<rect x=\"40\" y=\"10\" width=\"380\" height=\"22\" "
           "fill=\"url(#scale)\"/>\n" +
           labels + "</svg>\n";
}

/// A value of `red` and more is red; NAME.png of the stem, and NAME_scale.svg. Returns a line about
/// the scale.
std::string RadiosityPictures::put_false(const std::vector<double>& values, double red,
                                         const scene::View& view, const std::filesystem::path& stem,
                                         const std::string& what, image::OutputSet& files) {
    std::vector<double> parts;
    for (const double value : values) parts.push_back(red > 0 ? value / red : 0);
    image::put_picture(files.add(with_ending(stem, ".png")),
                       image::part_colors(parts, view.width, view.height));
    files.add(with_ending(stem, "_scale.svg")).write_text(scale_svg(red, what));
    return fmt::format(
        "{}.png, {}: red {:.4g} and more, yellow {:.4g}, green {:.4g}, cyan {:.4g}, "
        "blue to black 0\n",
        stem.filename().string(), what, red, red * 3 / 4, red / 2, red / 4);
}

std::string RadiosityPictures::put_units(const Solved& solved, const scene::View& view,
                                         const std::filesystem::path& stem,
                                         image::OutputSet& files) {
    const radiosity::DisplayedPixmaps colors = displayed(solved, options_);
    const double most = brightest(solved.model, colors, true),
                 lit = brightest(solved.model, colors, false);
    std::vector<float> radiosities;
    std::vector<double> means;
    for (const dvec3& B : drawn_values(solved, colors, view, most)) {
        for (int c = 0; c < 3; ++c) radiosities.push_back(float(B[c]));
        means.push_back((B.x + B.y + B.z) / 3);
    }
    image::put_values(files.add(with_ending(stem, "_units.exr")),
                      {view.width, view.height, {"R", "G", "B"}, std::move(radiosities)});
    return put_false(means, lit > 0 ? lit : most, view, with_ending(stem, "_false"), "radiosity",
                     files);
}

std::string RadiosityPictures::put_lux(const Solved& solved, const scene::View& view,
                                       const std::filesystem::path& stem, image::OutputSet& files) {
    const radiosity::DisplayedPixmaps colors =
        radiosity::displayed_irradiance(solved.model, solved.solution, !options_.no_ambient);
    std::vector<float> written;
    std::vector<double> lux;
    for (const dvec3& H :
         drawn_values(solved, colors, view, brightest(solved.model, colors, true))) {
        lux.push_back(scene::luminance_of(H));
        written.push_back(float(lux.back()));
    }
    const double most = *std::max_element(lux.begin(), lux.end());
    image::put_values(files.add(with_ending(stem, "_lux.exr")),
                      {view.width, view.height, {"Y"}, std::move(written)});
    return put_false(lux, most, view, with_ending(stem, "_lux"), "lux", files);
}

std::string RadiosityPictures::put(const Solved& solved, const std::string& name,
                                   image::OutputSet& files) {
    std::string text;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        const std::filesystem::path stem =
            options_.output / (views_.size() > 1 ? fmt::format("{}_{}", name, i + 1) : name);
        text += put_view(solved, views_[i], stem, files);
        if (options_.units) text += put_units(solved, views_[i], stem, files);
        if (options_.lux) text += put_lux(solved, views_[i], stem, files);
    }
    return text;
}

}  // namespace gw::apps
