#include "radiosity/solver/solution.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {

Solution initial_solution(const PixmapModel& model) {
    Solution solution;
    solution.H.assign(model.texel_count(), dvec3(0));
    for (const dvec3& E : model.E)
        solution.unshot.push_back({storable(E.x), storable(E.y), storable(E.z)});
    for (const DirectLight& light : model.direct) add(model, light, solution);
    return solution;
}

void add(const PixmapModel& model, const DirectLight& light, Solution& solution) {
    for (std::size_t t = 0; t < light.H.size(); ++t) {
        const dvec3 before = solution.H[t];
        for (int c = 0; c < 3; ++c) {
            solution.H[t][c] = storable(before[c] + light.H[t][c]);
            solution.unshot[t][c] =
                storable(solution.unshot[t][c] + model.rho[t][c] * (solution.H[t][c] - before[c]));
        }
    }
    solution.escaped += light.escaped;
}

dvec3 radiosity_at(const PixmapModel& model, const Solution& solution, std::size_t texel) {
    return model.E[texel] + model.rho[texel] * solution.H[texel];
}

double storable(double v) {
    const auto head = static_cast<float>(v);
    return double(head) + double(static_cast<float>(v - double(head)));
}

double Books::imbalance() const {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
        const double off = std::abs(absorbed[c] + unshot[c] + escaped[c] - emitted[c]);
        if (off > 0) worst = std::max(worst, off / emitted[c]);
    }
    return worst;
}

double Books::unshot_share() const {
    const double all = emitted.x + emitted.y + emitted.z;
    return all > 0 ? (unshot_size.x + unshot_size.y + unshot_size.z) / all : 0;
}

Books books(const PixmapModel& model, const Solution& solution) {
    Books b;
    for (const DirectLight& light : model.direct) b.emitted += light.emitted;
    for (std::size_t t = 0; t < model.texel_count(); ++t) {
        b.emitted += model.area[t] * model.E[t];
        b.absorbed += model.area[t] * (dvec3(1) - model.rho[t]) * solution.H[t];
        const dvec3 unshot = model.area[t] * solution.unshot[t];
        b.unshot += unshot;
        b.unshot_size += dvec3(std::abs(unshot.x), std::abs(unshot.y), std::abs(unshot.z));
    }
    b.absorbed += solution.backs;
    b.escaped = solution.escaped;
    return b;
}

dvec3 ambient(const PixmapModel& model, const Solution& solution) {
    dvec3 unshot(0), rho(0);
    double area = 0;
    for (std::size_t t = 0; t < model.texel_count(); ++t) {
        area += model.area[t];
        rho += model.area[t] * model.rho[t];
        unshot += model.area[t] * solution.unshot[t];
    }
    dvec3 light(0);
    for (int c = 0; c < 3; ++c) {
        const double mean = rho[c] / area;
        if (mean < 1 && unshot[c] > 0) light[c] = unshot[c] / area / (1 - mean);
    }
    return light;
}

}  // namespace gw::radiosity
