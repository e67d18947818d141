#include "web/engine/lighting.h"

#include "gw/error.h"
#include "image/plane_pictures.h"
#include "radiosity/model/changes.h"
#include "radiosity/model/figures.h"
#include "radiosity/solver/direct_light.h"
#include "scene/validate/warnings_of.h"

#include <set>

namespace gw::lab {
namespace {

using Json = Lighting::Json;

Json json_of_color(const dvec3& v) { return Json::array({v.x, v.y, v.z}); }

radiosity::Change change_of(const Json& json) {
    const Json& v = json.at("value");
    return {json.at("object"), json.at("what"), {v.at(0), v.at(1), v.at(2)}};
}

radiosity::SolverOptions solver_options(const Json& options) {
    return {.form_factors = {.hemicube = options.at("hemicube"), .threads = 1},
            .row_memory = std::size_t{256} << 20};
}

/// The place of a face's pixel in the cross. The top is in the middle, each side has its upper row
/// at the top's border.
ivec2 in_cross(std::size_t face, int x, int y, int size) {
    const int half = size / 2;
    switch (face) {
        case 0: return {half + x, half + y};
        case 1: return {y, half + size - 1 - x};
        case 2: return {2 * size - 1 - y, half + x};
        case 3: return {half + x, y};
        default: return {half + size - 1 - x, 2 * size - 1 - y};
    }
}

}  // namespace

Lighting::Lighting(scene::Scene scene, const Json& options)
    : scene_(std::move(scene)), beginning_(beginning(options)) {
    for (const Json& change : beginning_.at("changes")) apply(change_of(change), scene_);
    const radiosity::SolverOptions solving = solver_options(options);
    solver_ = std::make_unique<radiosity::Solver>(
        radiosity::make_lit_model(scene_, {}, solving.form_factors), solving);
    keep_unshot();
}

Json Lighting::beginning(const Json& options) {
    Json changes = Json::array();
    if (options.value("resolved", false))
        for (Json change : options.at("changes")) {
            change.erase("after");
            changes.push_back(change);
        }
    return {{"hemicube", options.at("hemicube")}, {"changes", changes}};
}

bool Lighting::is_due(const Json& options) const {
    const Json& changes = options.at("changes");
    return !options.value("resolved", false) && applied_.size() < changes.size() &&
           changes.at(applied_.size()).at("after") <= shots_;
}

bool Lighting::go_on(const Json& options) {
    const Json& changes = options.at("changes");
    if (beginning(options) != beginning_) return false;
    for (std::size_t i = 0; i < applied_.size(); ++i)
        if (i >= changes.size() || changes[i] != applied_[i] ||
            applied_[i].at("after") > options.at("shots"))
            return false;
    const bool is_missed = is_due(options) && changes[applied_.size()].at("after") < shots_;
    if (is_missed || options.at("shots") < shots_) {
        if (!applied_.empty()) return false;
        rewind();
        return true;
    }
    if (is_due(options)) {
        change(changes[applied_.size()]);
    } else if (shots_ < options.at("shots") && !is_dark_) {
        const auto shot = solver_->shoot();
        is_dark_ = !shot;
        if (!shot) return true;
        last_ = *shot;
        ++shots_;
        hemicubes_ += shot->hemicubes;
        keep_unshot();
    }
    return true;
}

void Lighting::rewind() {
    solver_->resume(radiosity::initial_solution(solver_->model()));
    shots_ = hemicubes_ = 0;
    last_ = {};
    is_dark_ = false;
    unshot_.clear();
    keep_unshot();
}

void Lighting::change(const Json& change) {
    scene::Scene changed = scene_;
    apply(change_of(change), changed);
    hemicubes_ += solver_
                      ->update(radiosity::make_lit_model(changed, {},
                                                         solver_options(beginning_).form_factors))
                      .hemicubes;
    scene_ = std::move(changed);
    applied_.push_back(change);
    changed_.push_back(unshot_.size());
    is_dark_ = false;
    keep_unshot();
}

void Lighting::keep_unshot() {
    unshot_.push_back(radiosity::books(solver_->model(), solver_->solution()).unshot_share());
}

Json Lighting::facts(const Json& options) const {
    const radiosity::PixmapModel& model = solver_->model();
    const radiosity::Books books = radiosity::books(model, solver_->solution());
    Json figures = Json::array(), pixmaps = Json::array();
    std::set<std::string> names;
    for (const radiosity::Figure& figure : model.figures)
        if (names.insert(figure.name).second)
            figures.push_back({{"name", figure.name},
                               {"Kd", json_of_color(figure.rho)},
                               {"emission", json_of_color(figure.E)}});
    for (const radiosity::Pixmap& pixmap : model.pixmaps)
        pixmaps.push_back(
            {{"name", pixmap.name}, {"width", pixmap.width}, {"height", pixmap.height}});
    const auto at_patch = [&](std::size_t number, const dvec3& flux) -> Json {
        const radiosity::Patch& patch = model.patches.at(number);
        return {{"patch", number},
                {"pixmap", patch.pixmap},
                {"x", patch.x},
                {"y", patch.y},
                {"width", patch.width},
                {"height", patch.height},
                {"flux", json_of_color(flux)},
                {"points", radiosity::points_of(model, patch).size()}};
    };
    std::vector<std::string> warnings = scene::left_out_by_radiosity(scene_);
    for (const std::string& line : radiosity::left_out(model)) warnings.push_back(line);
    Json answer{{"warnings", warnings},
                {"shots", shots_},
                {"hemicubes", hemicubes_},
                {"more", is_due(options) || (shots_ < options.at("shots") && !is_dark_)},
                {"dark", is_dark_},
                {"unshot", unshot_},
                {"changed", changed_},
                {"emitted", json_of_color(books.emitted)},
                {"absorbed", json_of_color(books.absorbed)},
                {"escaped", json_of_color(books.escaped)},
                {"left", json_of_color(books.unshot)},
                {"figures", figures},
                {"pixmaps", pixmaps},
                {"texels", model.texel_count()},
                {"patches", model.patches.size()}};
    const auto [next, flux] = solver_->brightest();
    answer["shot"] = shots_ > 0 ? at_patch(last_.patch, last_.flux) : at_patch(next, flux);
    return answer;
}

image::Picture Lighting::hemicube(std::size_t patch, std::size_t point) const {
    const radiosity::PixmapModel& model = solver_->model();
    const radiosity::SolverOptions options = solver_options(beginning_);
    const int size = options.form_factors.hemicube;
    const auto points = radiosity::points_of(model, model.patches.at(patch));
    const radiosity::FormFactors factors(model, options.form_factors);
    radiosity::IdBuffers buffers;
    radiosity::HemicubePainter(size).draw(model, factors.hemicube_on(points, point, patch),
                                          buffers);
    std::vector<std::uint32_t> ids(std::size_t(4 * size) * std::size_t(size), 0);
    for (std::size_t face = 0; face < buffers.size(); ++face) {
        const radiosity::IdBuffer& buffer = buffers[face];
        for (int y = 0; y < buffer.rows; ++y)
            for (int x = 0; x < buffer.size; ++x) {
                const ivec2 p = in_cross(face, x, y, size);
                ids[pixel_index(p.x, p.y, 2 * size)] =
                    buffer.pixels[pixel_index(x, y, buffer.size)] & 0xFFFFFF;
            }
    }
    return image::id_colors(ids, 2 * size, 2 * size, 0);
}

}  // namespace gw::lab
