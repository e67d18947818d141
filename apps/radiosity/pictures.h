// Pictures of solved pixmaps from every view, as textures and strips [F2.3]. Does not solve.
#pragma once

#include "apps/radiosity/options.h"
#include "image/output/output_set.h"
#include "radiosity/display/displayed_pixmaps.h"

namespace gw::apps {

/// What is shown: a solver's state, or one that was mixed of shares.
struct Solved {
    const radiosity::PixmapModel& model;
    const radiosity::Solution& solution;
};
radiosity::DisplayedPixmaps displayed(const Solved& solved, const RadiosityOptions& options);

/// The frame buffer's value of radiosity 1: 2^exposure, by the scene's white if it has one.
double shown_scale(const RadiosityOptions& options, const scene::Scene& scene);

class RadiosityPictures {
public:
    RadiosityPictures(const RadiosityOptions& options, const scene::Scene& scene, Session& session);

    /// Writes DIR/NAME.png, or NAME_1.png ... for several views. With --display both, writes
    /// NAME_texture.png, NAME_strips.png and NAME_difference.png, and returns a line about their
    /// difference for printing. With --units, also writes NAME_units.exr and NAME_false.png, with a
    /// line about their scale; with --lux NAME_lux.exr and NAME_lux.png.
    std::string put(const Solved& solved, const std::string& name, image::OutputSet& files);

private:
    struct Image {
        std::vector<Rgba> color, figures;  ///< figures: only if two pictures are compared
    };
    Image draw(const radiosity::PixmapModel& model, const radiosity::DisplayedPixmaps& colors,
               const scene::View& view, bool strips);
    std::vector<Rgba> with_components(const radiosity::PixmapModel& model,
                                      const radiosity::DisplayedPixmaps& colors,
                                      const scene::View& view);
    std::string put_view(const Solved& solved, const scene::View& view,
                         const std::filesystem::path& stem, image::OutputSet& files);

    std::vector<dvec3> drawn_values(const Solved& solved, const radiosity::DisplayedPixmaps& colors,
                                    const scene::View& view, double most);
    std::string put_false(const std::vector<double>& values, double red, const scene::View& view,
                          const std::filesystem::path& stem, const std::string& what,
                          image::OutputSet& files);
    std::string put_lux(const Solved& solved, const scene::View& view,
                        const std::filesystem::path& stem, image::OutputSet& files);
    std::string put_units(const Solved& solved, const scene::View& view,
                          const std::filesystem::path& stem, image::OutputSet& files);

    const RadiosityOptions& options_;
    scene::Scene scene_;
    Profile profile_;
    std::unique_ptr<Machine> machine_;
    std::vector<scene::View> views_;
};

}  // namespace gw::apps
