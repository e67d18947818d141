// The keys of gw view: one row each, and their effects.
#include "apps/view/orbit.h"
#include "apps/view/viewer.h"
#include "gw/base/elementary.h"
#include "gw/error.h"
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/interface/line_algorithm.h"
#include "inspect/replay/pixel_history.h"
#include "render/options.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

template <class T>
T next_of(const std::vector<T>& all, const T& now, int by) {
    const auto found = std::find(all.begin(), all.end(), now);
    const auto count = std::ptrdiff_t(all.size());
    const std::ptrdiff_t at = found == all.end() ? (by > 0 ? -1 : 0) : found - all.begin();
    return all[std::size_t((at + by + count) % count)];
}

/// "" is the Z-buffer's ordinary picture.
std::vector<std::string> algorithm_choices() {
    std::vector<std::string> names = hiddensurface::algorithm_names();
    for (const auto& lines : hiddensurface::line_algorithms()) names.push_back(lines.name);
    names.push_back("");
    return names;
}

/// Unshot energy at which shooting rests.
constexpr double dark_enough = 1e-4;

}  // namespace

const std::vector<Viewer::Key>& Viewer::keys() {
    static const std::vector<Key> all{
        {"Left", "arrows: orbit", &Viewer::turn_left},
        {"Right", "", &Viewer::turn_right},
        {"Up", "", &Viewer::turn_up},
        {"Down", "", &Viewer::turn_down},
        {"+", "+ -: nearer, farther", &Viewer::nearer},
        {"=", "", &Viewer::nearer},
        {"-", "", &Viewer::farther},
        {"Home", "Home: the first view", &Viewer::first_view},
        {"r", "r R: next, previous renderer", &Viewer::next_renderer},
        {"R", "", &Viewer::previous_renderer},
        {"f", "f: next profile", &Viewer::next_profile},
        {"a", "a A: more, fewer samples", &Viewer::more_samples},
        {"A", "", &Viewer::fewer_samples},
        {"w", "w: shadows", &Viewer::next_shadow},
        {"e", "e: reflections by rays or maps", &Viewer::next_reflections},
        {"d", "d D: rays in a path", &Viewer::deeper},
        {"D", "", &Viewer::less_deep},
        {"t", "t: translucent order", &Viewer::next_translucency},
        {"g", "g: fog      1..9: lights", &Viewer::toggle_fog},
        {"Tab", "Tab: pass by pass", &Viewer::toggle_passes},
        {".", ", .: previous, next pass", &Viewer::next_pass},
        {",", "", &Viewer::previous_pass},
        {"z", "z: one plane, or all four", &Viewer::next_plane},
        {"i", "i: history of the pixel here", &Viewer::show_history},
        {"h", "h H: hidden-surface algorithm", &Viewer::next_algorithm},
        {"H", "", &Viewer::previous_algorithm},
        {"l", "l: radiosity", &Viewer::toggle_radiosity},
        {"Space", "Space: shoot, rest   n: one shot", &Viewer::toggle_shooting},
        {"n", "", &Viewer::shoot_once},
        {"[", "[ ]: dim, brighten emitter here", &Viewer::dim},
        {"]", "", &Viewer::brighten},
        {"x", "x X: exposure of the light", &Viewer::brighter_picture},
        {"X", "", &Viewer::darker_picture},
        {"s", "s: save view   p: save picture", &Viewer::save_view},
        {"p", "", &Viewer::save_picture},
        {"?", "?: this help   q: leave", &Viewer::toggle_help},
        {"q", "", &Viewer::finish},
        {"Escape", "", &Viewer::finish},
    };
    return all;
}

void Viewer::handle(const Input& input) {
    is_screen_old_ = true;
    switch (input.kind) {
        case Input::Kind::Close: return finish();
        case Input::Kind::Press: return press(input);
        case Input::Kind::Move: return drag(input);
        case Input::Kind::Release: return release(input);
        case Input::Kind::Wheel:
            settings_.camera = zoomed(settings_.camera, gw::pow(0.9, input.wheel));
            return moved();
        case Input::Kind::Key: break;
    }
    if (input.key.size() == 1 && input.key[0] >= '1' && input.key[0] <= '9')
        return toggle_light(std::size_t(input.key[0] - '1'));
    const auto found = std::ranges::find(keys(), input.key, &Key::key);
    if (found == keys().end()) return;
    message_.clear();
    (this->*found->press)();
}

void Viewer::step_renderer(int by) {
    show_ = show_ == Show::Passes ? show_ : Show::Picture;
    settings_.picture.renderer = next_of(render::renderer_names(), settings_.picture.renderer, by);
}

void Viewer::next_profile() {
    std::vector<std::string> names;
    for (const auto& [name, profile] : viewed_.profiles) names.push_back(name);
    settings_.picture.profile = next_of(names, settings_.picture.profile, 1);
}

void Viewer::more_samples() {
    settings_.picture.samples = std::min(settings_.picture.samples * 2, 64);
}
void Viewer::fewer_samples() {
    settings_.picture.samples = std::max(settings_.picture.samples / 2, 1);
}

void Viewer::next_shadow() {
    using enum scene::Shadow;
    const std::vector<std::optional<scene::Shadow>> all{{}, None, Volume, Map};
    settings_.picture.shadow = next_of(all, settings_.picture.shadow, 1);
}

void Viewer::next_reflections() { settings_.picture.traced = !settings_.picture.traced; }

void Viewer::next_translucency() {
    using enum multipass::Translucency;
    settings_.picture.translucency =
        next_of({Sorted, Unsorted, Layers}, settings_.picture.translucency, 1);
}

void Viewer::deeper() {
    settings_.picture.depth = std::min(settings_.picture.depth + 1, render::most_depth);
}
void Viewer::less_deep() { settings_.picture.depth = std::max(settings_.picture.depth - 1, 1); }

void Viewer::toggle_fog() {
    if (!viewed_.scene.fog) return say("the scene has no fog");
    settings_.fog = !settings_.fog;
}

void Viewer::toggle_light(std::size_t place) {
    if (place >= viewed_.scene.lights.size()) return say(fmt::format("no light {}", place + 1));
    if (!settings_.lights_off.erase(place)) settings_.lights_off.insert(place);
}

void Viewer::toggle_passes() {
    history_.clear();
    show_ = show_ == Show::Passes ? Show::Picture : Show::Passes;
}

void Viewer::step_pass(int by) {
    if (show_ != Show::Passes) return toggle_passes();
    const auto last = frame_.passes.empty() ? 0 : frame_.passes.size() - 1;
    if (by < 0 && pass_ > 0) --pass_;
    if (by > 0) pass_ = std::min(pass_ + 1, last);
}

void Viewer::next_plane() {
    using P = std::optional<Plane>;
    plane_ = next_of({P{}, P{Plane::Color}, P{Plane::Depth}, P{Plane::Stencil}, P{Plane::Accum}},
                     plane_, 1);
}

void Viewer::step_algorithm(int by) {
    algorithm_ = next_of(algorithm_choices(), show_ == Show::Hidden ? algorithm_ : "", by);
    show_ = algorithm_.empty() ? Show::Picture : Show::Hidden;
}

void Viewer::show_history() {
    if (!history_.empty()) return history_.clear();
    if (!is_in_picture(mouse_x_, mouse_y_)) return say("no pixel here");
    if (show_ == Show::Hidden || show_ == Show::Light)
        return say("a history is one of passes: Tab");
    if (history_job_.valid()) return;
    say("looking at the pixel ...");
    history_job_ =
        std::async(std::launch::async, [this, settings = settings_, x = mouse_x_, y = mouse_y_,
                                        known = show_ == Show::Passes ? frame_.by_pass : nullptr] {
            // A drawer of its own: the other one may be drawing.
            FrameDrawer own(viewed_.scene, viewed_.passes, viewed_.profiles);
            const auto by_pass = known ? known : own.draw_by_pass(settings).by_pass;
            if (!by_pass) throw Error("nothing was drawn; expected a picture");
            const int row = settings.picture.size.height - 1 - y;
            return inspect::history_rows(inspect::pixel_history(by_pass->recording(), x, row));
        });
}

void Viewer::toggle_radiosity() {
    if (show_ == Show::Light) {
        show_ = Show::Picture;
        return;
    }
    show_ = Show::Light;
    if (light_worker_) return;
    radiosity::SolverOptions options;
    options.form_factors.threads = settings_.picture.threads;
    light_worker_ = std::make_unique<LightWorker>(viewed_.scene, options);
    light_worker_->shoot_until(is_shooting_ ? dark_enough : 1);
}

void Viewer::toggle_shooting() {
    if (show_ != Show::Light) return toggle_radiosity();
    is_shooting_ = !is_shooting_;
    light_worker_->shoot_until(is_shooting_ ? dark_enough : 1);
}

void Viewer::shoot_once() {
    if (show_ != Show::Light) toggle_radiosity();
    is_shooting_ = false;
    light_worker_->shoot_until(1);
    light_worker_->shoot_once();
}

void Viewer::dim() { dim_by(0.8); }
void Viewer::brighten() { dim_by(1.25); }

void Viewer::dim_by(double factor) {
    const std::optional<Light> now = light();
    if (!now || !now->model) return say("emitters are dimmed in radiosity: l");
    if (!is_in_picture(mouse_x_, mouse_y_)) return say("no emitter here");
    const auto figure =
        picker_.figure_at(*now, view(), mouse_x_, settings_.picture.size.height - 1 - mouse_y_);
    if (!figure || now->model->figures[*figure].E == dvec3(0)) return say("no emitter here");
    changes_.push_back({now->model->figures[*figure].name, "dim", dvec3(factor)});
    light_worker_->change(changes_.back());
    say(fmt::format("{} times {}", changes_.back().object, factor));
}

void Viewer::turn(double right, double above) {
    settings_.camera = orbited(settings_.camera, right, above);
    moved();
}

void Viewer::nearer() {
    settings_.camera = zoomed(settings_.camera, 0.9);
    moved();
}
void Viewer::farther() {
    settings_.camera = zoomed(settings_.camera, 1 / 0.9);
    moved();
}
void Viewer::first_view() {
    settings_.camera = first_camera_;
    moved();
}

}  // namespace gw::apps
