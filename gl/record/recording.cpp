#include "gl/record/recording.h"

#include "gl/drawable/drawable.h"
#include "gl/drawable/off_screen.h"
#include "gl/record/restored_planes.h"
#include "gw/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace gw::gl {

namespace {

inspect::Recording heading(const Profile& profile) {
    inspect::Recording out;
    out.producer = "gw gl";
    out.profile = profile;
    return out;
}

inspect::ColorMap color_map_of(ShownIndices shown) {
    inspect::ColorMap map{.planes = static_cast<inspect::IndexPlanes>(shown.planes),
                          .bits = shown.bits,
                          .bits_in_r = shown.bits_in_r,
                          .entries = std::move(shown.entries)};
    return map.bits != 0 ? map : inspect::ColorMap{};
}

void warn_of_samples(const Drawable& drawable) {
    std::fprintf(
        stderr,
        "gw: warning: the recording of '%s' begins with frame %llu, with one value for all "
        "samples of a pixel; expected a recording from frame 0 on, or a program that clears "
        "its framebuffers in each frame\n",
        drawable.name().c_str(), static_cast<unsigned long long>(drawable.frame()));
}

}  // namespace

Recording::Recording(std::string file, const Profile& profile, const FrameRange& frames)
    : file_(std::move(file)),
      frames_(frames),
      out_(file_, std::ios::binary),
      writer_((check("expected a file that can be written"), out_), heading(profile)) {}

Recording::~Recording() {
    attempt([&] { writer_.finish(); });
    if (!failed_ && is_empty_)
        std::fprintf(stderr, "gw: warning: no frame of GW_FRAMES was drawn: '%s' has none\n",
                     file_.c_str());
}

void Recording::check(const char* what) {
    if (!out_) throw Error(std::string(what) + " (" + std::strerror(errno) + ")");
}

template <class Write>
void Recording::attempt(Write write) {
    if (failed_) return;
    errno = 0;
    try {
        write();
        if (!out_) throw Error("the file cannot be written");
    } catch (const std::exception& error) {
        failed_ = true;
        const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
        std::fprintf(stderr, "gw: recording stopped: %s: %s%s\n", file_.c_str(), error.what(),
                     reason.c_str());
    }
}

CommandList Recording::drawn_before(Drawable& drawable) const {
    const std::string pass = "before frame " + std::to_string(drawable.frame());
    auto* const machine = dynamic_cast<OffScreen*>(&drawable);
    if (machine == nullptr) {
        const CommandList samples = drawable.resolve_samples();
        if (drawable.samples() > 0) warn_of_samples(drawable);
        CommandList out =
            restoring_list(drawable.planes(), drawable.profile(), pass, *drawable.state());
        out.append(samples);
        return out;
    }
    std::map<std::uint32_t, SurfaceValues> surfaces;
    std::uint32_t number = 0;
    bool has_samples = false;
    for (const Surface& surface : machine->surfaces()) {
        ++number;
        if (surface.width == 0) continue;
        surfaces[number] = {surface, machine->read_surface(number)};
        has_samples |= surface.samples > 0;
    }
    if (has_samples) warn_of_samples(drawable);
    return restoring_list(surfaces, pass, machine->in_use(), *drawable.state());
}

void Recording::begin_window(Drawable& drawable) {
    writer_.open(drawable.name(), drawable.width(), drawable.height());
    windows_.insert(drawable.name());
    is_empty_ = false;
    color_maps_.erase(drawable.name());
    if (drawable.state() == nullptr) return;  // nothing was drawn before
    writer_.add(drawable.name(), drawn_before(drawable), {}, new_color_map(drawable));
}

std::optional<inspect::ColorMap> Recording::new_color_map(const Drawable& drawable) {
    inspect::ColorMap now = color_map_of(drawable.shown_indices());
    inspect::ColorMap& known = color_maps_[drawable.name()];
    if (now == known) return {};
    return known = std::move(now);
}

void Recording::open(Drawable& drawable) {
    if (frames_.first == 0) attempt([&] { begin_window(drawable); });
}

void Recording::begin_frame(Drawable& drawable) {
    if (!frames_.holds(drawable.frame())) return;
    attempt([&] {
        if (!windows_.contains(drawable.name())) begin_window(drawable);
    });
}

void Recording::executed(Drawable& drawable, const Execution& execution) {
    if (!frames_.holds(drawable.frame())) return;
    attempt([&] {
        if (windows_.contains(drawable.name()))
            writer_.add(drawable.name(), execution.list, namer_.table_of(execution.calls),
                        new_color_map(drawable));
    });
}

void Recording::end_frame(Drawable& drawable) {
    if (drawable.frame() == frames_.last) close(drawable);
}

void Recording::close(Drawable& drawable) {
    attempt([&] {
        color_maps_.erase(drawable.name());
        if (windows_.erase(drawable.name()) != 0) writer_.close(drawable.name());
    });
}

}  // namespace gw::gl
