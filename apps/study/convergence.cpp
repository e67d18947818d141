#include "apps/study/convergence.h"

#include "multipass/frame/driver.h"

#include <fmt/format.h>

#include <map>

namespace gw::study {
namespace {

Fractions picture(const scene::Scene& scene, const Profile& profile, const MachineMaker& make,
                  int samples, const ConvergenceOptions& options) {
    const auto machine = make(profile);
    const scene::View view = scene::make_view(scene, options.width, options.height);
    multipass::render(*machine, scene, view, {.samples = samples});
    return fractions(*machine);
}

/// The converged pictures, by the number of sub-pixel bits, because vertices and samples lie on that
/// grid.
class Truths {
public:
    Truths(const scene::Scene& scene, const MachineMaker& make, const ConvergenceOptions& options)
        : scene_(scene), make_(make), options_(options) {}

    const Fractions& of(int subpixel_bits) {
        const auto found = pictures_.find(subpixel_bits);
        if (found != pictures_.end()) return found->second;
        Profile profile = ideal();
        profile.subpixel_bits = subpixel_bits;
        return pictures_[subpixel_bits] =
                   picture(scene_, profile, make_, options_.reference, options_);
    }

private:
    const scene::Scene& scene_;
    const MachineMaker& make_;
    const ConvergenceOptions& options_;
    std::map<int, Fractions> pictures_;
};

/// The errors of fewer samples than the grid has places. With more, only rounding is left.
std::vector<dvec2> before_saturation(const std::vector<dvec2>& rms, int subpixel_bits) {
    std::vector<dvec2> out;
    for (const dvec2& p : rms)
        if (p.x < double(1 << 2 * subpixel_bits)) out.push_back(p);
    return out;
}

plot::Series law_line(const ProfileError& from, double exponent, const std::string& name) {
    plot::Series line{.name = name, .markers = false, .dashed = true};
    const dvec2 first = from.rms.front();
    const plot::PowerLaw law =
        plot::power_law({first, {2 * first.x, first.y * plot::PowerLaw{1, exponent}(2)}});
    for (const dvec2& p : from.rms) line.points.push_back({p.x, law(p.x)});
    return line;
}

}  // namespace

std::vector<ProfileError> convergence(scene::Scene scene, const std::vector<Profile>& profiles,
                                      const MachineMaker& make, const ConvergenceOptions& options,
                                      const std::function<void(const std::string&)>& say) {
    for (scene::Light& light : scene.lights) light.area.samples = 1;
    for (scene::Object& object : scene.objects)
        if (object.glare) object.glare->samples = 1;
    Truths truths(scene, make, options);
    std::vector<ProfileError> errors;
    for (const Profile& profile : profiles) {
        ProfileError error{.profile = profile.name};
        say(fmt::format("{}, {} samples", profile.name, options.reference));
        const Fractions& truth = truths.of(profile.subpixel_bits);
        error.grid = difference(truth, truths.of(ideal().subpixel_bits)).rms;
        for (int n = 2; n <= options.largest; n *= 2) {
            say(fmt::format("{}, {} samples", profile.name, n));
            error.rms.push_back(
                {double(n), difference(picture(scene, profile, make, n, options), truth).rms});
        }
        error.law = plot::power_law(before_saturation(error.rms, profile.subpixel_bits));
        errors.push_back(std::move(error));
    }
    return errors;
}

plot::Plot convergence_plot(const std::vector<ProfileError>& errors, const std::string& title,
                            int dimensions) {
    plot::Plot plot{
        .title = title,
        .caption =
            "Error against a converged picture of 16 bits and the same sub-pixel grid, root of the mean "
            "square over all pixels. An 8x8 grid has 64 places: exponents are fitted below that.",
        .x = {"samples N", 2},
        .y = {"error, 255ths of white", 10}};
    for (const ProfileError& e : errors)
        plot.series.push_back({fmt::format("{}: N^{:.2f}", e.profile, e.law.exponent), e.rms});
    const double exponent = -0.5 - 0.5 / dimensions;
    plot.series.push_back(
        law_line(errors.back(), exponent, fmt::format("well spread: N^{:.3g}", exponent)));
    plot.series.push_back(law_line(errors.back(), -0.5, "random: N^-0.5"));
    return plot;
}

}  // namespace gw::study
