#include "radiosity/solver/shares.h"

#include "gw/error.h"
#include "radiosity/model/figures.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::radiosity {
namespace {

std::vector<dvec3> emission_of(const PixmapModel& model, const std::string& lamp) {
    return emission_times(model,
                          [&](const Figure& figure) { return dvec3(figure.name == lamp ? 1 : 0); });
}

dvec3 all_storable(const dvec3& v) { return {storable(v.x), storable(v.y), storable(v.z)}; }

Solution sum_of(const std::vector<Share>& shares, const std::vector<dvec3>& factors,
                std::size_t texels) {
    Solution sum;
    sum.H.assign(texels, dvec3(0));
    sum.unshot.assign(texels, dvec3(0));
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Solution& share = shares[i].solution;
        for (std::size_t t = 0; t < texels; ++t) {
            sum.H[t] += factors[i] * share.H[t];
            sum.unshot[t] += factors[i] * share.unshot[t];
        }
        sum.escaped += factors[i] * share.escaped;
        sum.backs += factors[i] * share.backs;
        sum.shots = share.shots;
    }
    for (std::size_t t = 0; t < texels; ++t) {
        sum.H[t] = all_storable(sum.H[t]);
        sum.unshot[t] = all_storable(sum.unshot[t]);
    }
    return sum;
}

}  // namespace

std::vector<std::string> lamps_of(const PixmapModel& model) {
    std::vector<std::string> lamps;
    for (const Figure& figure : model.figures)
        if (figure.E != dvec3(0) &&
            std::find(lamps.begin(), lamps.end(), figure.name) == lamps.end())
            lamps.push_back(figure.name);
    for (const DirectLight& light : model.direct)
        if (std::find(lamps.begin(), lamps.end(), light.name) == lamps.end())
            lamps.push_back(light.name);
    return lamps;
}

std::vector<Share> initial_shares(const PixmapModel& model) {
    std::vector<Share> shares;
    for (const std::string& lamp : lamps_of(model)) {
        Share share{lamp, emission_of(model, lamp), {}};
        share.solution.H.assign(model.texel_count(), dvec3(0));
        for (const dvec3& E : share.E) share.solution.unshot.push_back(all_storable(E));
        for (const DirectLight& light : model.direct)
            if (light.name == lamp) add(model, light, share.solution);
        shares.push_back(std::move(share));
    }
    return shares;
}

Solution mix(const std::vector<Share>& shares, const std::vector<dvec3>& factors,
             PixmapModel& model) {
    const auto factor_of = [&](const std::string& name) {
        for (std::size_t i = 0; i < shares.size(); ++i)
            if (shares[i].lamp == name) return factors[i];
        return dvec3(1);
    };
    model.E = emission_times(model, [&](const Figure& figure) { return factor_of(figure.name); });
    for (Figure& figure : model.figures) figure.E *= factor_of(figure.name);
    for (DirectLight& light : model.direct) {
        const dvec3 factor = factor_of(light.name);
        for (dvec3& H : light.H) H *= factor;
        light.emitted *= factor;
        light.escaped *= factor;
    }
    return sum_of(shares, factors, model.texel_count());
}

Saved save_share(const PixmapModel& model, const FormFactorOptions& options, const Share& share,
                 std::size_t number, std::size_t count) {
    Saved saved = save(model, options, share.solution, share.E);
    saved.facts["kind"] = share_kind;
    saved.facts["lamp"] = share.lamp;
    saved.facts["share"] = fmt::format("{} of {}", number, count);
    return saved;
}

Share load_share(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
                 const std::string& lamp, const std::string& file) {
    Share share{lamp, emission_of(model, lamp), load(saved, model, options, file, share_kind)};
    const auto found = saved.facts.find("lamp");
    const std::string name = found == saved.facts.end() ? "" : found->second;
    if (name != lamp)
        throw Error(file, 0,
                    fmt::format("has the light of '{}'; expected that of '{}'", name, lamp));
    return share;
}

void check_same_shots(const std::vector<Share>& shares, const std::vector<std::string>& files,
                      std::uint64_t shots) {
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (shares[i].solution.shots != shots)
            throw Error(files[i], 0,
                        fmt::format("has {} shots; expected {}, as the solution beside it",
                                    shares[i].solution.shots, shots));
}

}  // namespace gw::radiosity
