#include "gl/glx/displays.h"

#include "gl/record/recorder.h"
#include "gl/x11/extension.h"
#include "gl/x11/quiet_errors.h"

#include <map>
#include <mutex>
#include <string_view>
#include <tuple>

namespace gw::gl::glx {

namespace {

struct KnownDisplay {
    explicit KnownDisplay(Display* display) : codes(register_codes(display)) {
        start_recording();
        for (int screen = 0; screen < ScreenCount(display); ++screen)
            screens.push_back(make_configs(display, screen, 1000 * screen + 1));
    }

    const ExtensionCodes codes;
    std::vector<std::deque<Config>> screens;
    std::map<VisualID, Config*> chosen;
    std::map<XID, std::shared_ptr<Surface>> surfaces;
};

using KnownDisplays = std::map<Display*, std::unique_ptr<KnownDisplay>>;

/// Never destroyed: programs call GLX from their own exit handlers.
KnownDisplays& known_displays() {
    static auto* const displays = new KnownDisplays;
    return *displays;
}

/// Guards known_displays() and all that hangs on it. Not held while anything is drawn.
std::recursive_mutex& display_mutex() {
    static auto* const mutex = new std::recursive_mutex;
    return *mutex;
}

/// The display comes before our own mutex: a program may call GLX between XLockDisplay and
/// XUnlockDisplay.
class Lock {
public:
    explicit Lock(Display* display) : display_(display), lock_(display_mutex()) {}

private:
    const x11::LockedDisplay display_;
    const std::lock_guard<std::recursive_mutex> lock_;
};

int forget_display(Display* display, XExtCodes*) {
    const Lock lock(display);
    const auto found = known_displays().find(display);
    if (found == known_displays().end()) return 0;
    for (const auto& [name, surface] : found->second->surfaces) surface->lose_display();
    known_displays().erase(found);
    return 0;
}

KnownDisplay& known(Display* display) {
    std::unique_ptr<KnownDisplay>& place = known_displays()[display];
    if (!place) {
        place = std::make_unique<KnownDisplay>(display);
        x11::call_at_close(display, &forget_display);
    }
    return *place;
}

/// Forgets the windows that are no longer there and that no context draws to.
void forget_lost_windows(Display* display, KnownDisplay& of) {
    std::erase_if(of.surfaces, [&](const auto& entry) {
        const auto& [name, surface] = entry;
        const bool is_own_name = surface->kind() == Surface::Kind::Window &&
                                 surface->target() == name && surface.use_count() == 1;
        return is_own_name && !x11::geometry(display, name);
    });
}

}  // namespace

const ExtensionCodes& codes_of(Display* display) {
    const Lock lock(display);
    return known(display).codes;
}

std::deque<Config>& configs_of(Display* display, int screen) {
    const Lock lock(display);
    static auto& none = *new std::deque<Config>;
    std::vector<std::deque<Config>>& screens = known(display).screens;
    return screen >= 0 && std::size_t(screen) < screens.size() ? screens[std::size_t(screen)]
                                                               : none;
}

bool is_config(Display* display, GLXFBConfig config) {
    const Lock lock(display);
    for (const std::deque<Config>& screen : known(display).screens)
        for (const Config& candidate : screen)
            if (&candidate == config) return true;
    return false;
}

Config* config_of_visual(Display* display, const XVisualInfo& visual) {
    const Lock lock(display);
    KnownDisplay& of = known(display);
    const auto found = of.chosen.find(visual.visualid);
    if (found != of.chosen.end()) return found->second;
    const auto rank = [](const Config& of) { return std::tuple(of.samples, !of.double_buffered); };
    Config* first = nullptr;
    for (std::deque<Config>& screen : of.screens)
        for (Config& config : screen)
            if (config.visual.visualid == visual.visualid &&
                (first == nullptr || rank(config) < rank(*first)))
                first = &config;
    return first;
}

XVisualInfo* chosen_visual(Display* display, const Config& config) {
    const Lock lock(display);
    known(display).chosen[config.visual.visualid] = const_cast<Config*>(&config);
    XVisualInfo like = config.visual;
    int count = 0;
    return XGetVisualInfo(display, VisualIDMask | VisualScreenMask, &like, &count);
}

std::shared_ptr<Surface> find_surface(Display* display, XID name) {
    const Lock lock(display);
    const auto& own = known(display).surfaces;
    if (const auto found = own.find(name); found != own.end()) return found->second;
    const std::string_view server = DisplayString(display);
    for (const auto& [other, of] : known_displays()) {
        const auto found = of->surfaces.find(name);
        if (found != of->surfaces.end() && server == DisplayString(other)) return found->second;
    }
    return nullptr;
}

std::shared_ptr<Surface> make_window_surface(Display* display, XID window, const Config& config) {
    const Lock lock(display);
    if (auto found = find_surface(display, window)) return found;
    forget_lost_windows(display, known(display));
    const x11::Geometry size = x11::geometry(display, window).value_or(x11::Geometry{});
    auto surface = std::make_shared<Surface>(display, config, Surface::Kind::Window, window,
                                             size.width, size.height);
    add_surface(display, window, surface);
    return surface;
}

void add_surface(Display* display, XID name, std::shared_ptr<Surface> surface) {
    const Lock lock(display);
    known(display).surfaces[name] = std::move(surface);
}

bool remove_surface(Display* display, XID name, Surface::Kind kind) {
    const Lock lock(display);
    auto& surfaces = known(display).surfaces;
    const auto found = surfaces.find(name);
    if (found == surfaces.end() || found->second->kind() != kind) return false;
    const XID target = found->second->target();
    surfaces.erase(found);
    if (kind == Surface::Kind::Window) surfaces.erase(target);
    return true;
}

}  // namespace gw::gl::glx
