// gw view's screen: text and pictures of the viewer's state.
#include "apps/view/viewer.h"
#include "image/plane_pictures.h"
#include "inspect/text/plural.h"
#include "render/words/option_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace gw::apps {
namespace {

constexpr Color heading{255, 255, 255}, faint{140, 140, 140}, warning{255, 170, 60},
    marked{255, 230, 0};

/// The text in pieces of at most a panel's letters, broken at spaces.
std::vector<std::string> wrapped(const std::string& text) {
    std::vector<std::string> lines;
    std::string rest = text;
    while (rest.size() > std::size_t(panel_letters)) {
        auto at = rest.rfind(' ', panel_letters);
        if (at == rest.npos || at == 0) at = panel_letters;
        lines.push_back(rest.substr(0, at));
        rest = "  " + rest.substr(std::min(rest.find_first_not_of(' ', at), rest.size()));
    }
    lines.push_back(rest);
    return lines;
}

void add_wrapped(std::vector<PanelLine>& lines, const std::string& text, const Color& color) {
    for (const std::string& line : wrapped(text)) lines.push_back({line, color});
}

std::string rate(double seconds) {
    return fmt::format("{:.1f} ms, {:.1f} pictures a second", seconds * 1000,
                       1 / std::max(seconds, 1e-6));
}

}  // namespace

void Viewer::add_settings(std::vector<PanelLine>& lines) const {
    const PictureOptions& p = settings_.picture;
    const bool has_renderer = show_ == Show::Picture || show_ == Show::Passes;
    const auto add = [&](const char* key, const std::string& text, bool used) {
        lines.push_back({fmt::format("{:<4}{}", key, text), used ? PanelLine{}.color : faint});
    };
    add("r", "renderer    " + p.renderer, has_renderer);
    add("f", "profile     " + p.profile, has_renderer || show_ == Show::Hidden);
    add("a A", fmt::format("samples     {}{}", p.samples, p.weighted ? " weighted" : ""),
        has_renderer);
    add("w",
        fmt::format("shadows     {}",
                    p.shadow ? scene::word_of(scene::shadow_words, *p.shadow) : "the scene's"),
        has_renderer);
    add("e", fmt::format("reflections {}", scene::word_of(render::reflection_words, p.traced)),
        has_renderer);
    add("d D", fmt::format("depth       {}", p.depth), has_renderer);
    add("t",
        fmt::format("translucent {}", scene::word_of(render::translucency_words, p.translucency)),
        has_renderer);
    if (viewed_.scene.fog) add("g", settings_.fog ? "fog         on" : "fog         off", true);
    for (std::size_t i = 0; i < viewed_.scene.lights.size() && i < 9; ++i)
        add(std::to_string(i + 1).c_str(),
            fmt::format("light {} {}", settings_.lights_off.contains(i) ? "off" : "on ",
                        viewed_.scene.lights[i].name),
            has_renderer);
}

void Viewer::add_passes(std::vector<PanelLine>& lines) const {
    if (frame_.passes.empty()) return;
    Counters sum{};
    double seconds = 0;
    for (const FramePass& pass : frame_.passes) {
        sum += pass.counters;
        seconds += pass.seconds;
    }
    lines.push_back({inspect::plural(frame_.passes.size(), "pass", "passes") +
                     fmt::format(", {} fragments", sum.fragments)});
    lines.push_back({fmt::format("estimated on a VGX: {:.3f} s", seconds)});
    if (show_ != Show::Passes) return;
    const std::size_t first = pass_ > 6 ? pass_ - 6 : 0;
    for (std::size_t i = first; i < std::min(first + 9, frame_.passes.size()); ++i)
        lines.push_back({fmt::format("{} {:>2} {}", i == pass_ ? ">" : " ", i + 1,
                                     frame_.passes[i].name.empty() ? "(before the first pass)"
                                                                   : frame_.passes[i].name),
                         i == pass_ ? marked : PanelLine{}.color});
    const FramePass& pass = frame_.passes[pass_];
    add_wrapped(lines, pass.set.empty() ? "added by the driver" : pass.set, heading);
    lines.push_back(
        {fmt::format("{} fragments, {:.4f} s on a VGX", pass.counters.fragments, pass.seconds)});
}

void Viewer::add_light(std::vector<PanelLine>& lines) const {
    const std::optional<Light> now = light();
    if (!now) return;
    lines.push_back({fmt::format("shots {}   hemicubes {}", now->shots, now->hemicubes)});
    lines.push_back({fmt::format("unshot {:.2f} % of the energy", now->unshot * 100)});
    add_wrapped(lines, now->last, faint);
    lines.push_back({fmt::format("{}   exposure {:+.1f}",
                                 light_worker_->is_busy() ? "shooting" : "at rest", exposure_)});
    lines.push_back({"Ctrl and drag: move a figure", faint});
    if (!now->fault.empty()) add_wrapped(lines, now->fault, warning);
}

void Viewer::add_help(std::vector<PanelLine>& lines) const {
    lines.push_back({"drag: orbit   right or Shift: pan"});
    lines.push_back({"wheel: nearer, farther"});
    for (const Key& key : keys())
        if (*key.help != 0) lines.push_back({key.help});
}

std::vector<PanelLine> Viewer::panel() const {
    std::vector<PanelLine> lines{{viewed_.file.filename().string(), heading}};
    if (is_help_shown_) {
        add_help(lines);
        return lines;
    }
    add_settings(lines);
    lines.push_back({""});
    if (show_ == Show::Hidden && !frame_.notes.empty())
        for (const std::string& note : frame_.notes)
            add_wrapped(lines, note, &note == &frame_.notes.front() ? heading : PanelLine{}.color);
    add_passes(lines);
    add_light(lines);
    if (!frame_.picture.values.empty()) lines.push_back({rate(frame_.seconds)});
    if (!left_out_.empty()) add_wrapped(lines, "while it moves: " + left_out_, warning);
    if (!frame_.fault.empty()) add_wrapped(lines, frame_.fault, warning);
    if (!message_.empty()) add_wrapped(lines, message_, marked);
    lines.push_back({"?: keys", faint});
    return lines;
}

image::Picture Viewer::picture() const {
    if (show_ != Show::Passes || !frame_.by_pass || pass_ >= frame_.by_pass->passes())
        return frame_.picture;
    const Planes& planes = frame_.by_pass->planes_after(pass_ + 1);
    const Profile& profile = frame_.by_pass->recording().profile;
    const auto shown = [&](Plane plane) { return image::plane_picture(planes, plane, profile); };
    if (plane_) return shown(*plane_);
    return quarters({{"colour", shown(Plane::Color)},
                     {"Z", shown(Plane::Depth)},
                     {"stencil", shown(Plane::Stencil)},
                     {"accumulation", shown(Plane::Accum)}});
}

image::Picture Viewer::screen() const {
    const auto [width, height] = settings_.picture.size;
    return screen_of(
        {.picture = picture(), .panel = panel(), .below = history_, .strokes = grasped_box()},
        width, height);
}

}  // namespace gw::apps
