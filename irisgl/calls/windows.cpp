// Windows: opening, places, sizes.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "generated/irisgl/calls.h"

#include "gl/record/recorder.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace gw::irisgl::calls {

namespace {

constexpr long default_width = 640, default_height = 480, screen_width = 1280, screen_height = 1024;

struct WindowPlace {
    long x, y, width, height;
};

/// Makes the longer side shorter.
void fit_aspect(WindowPlace& p, long x, long y) {
    const double ratio = double(x) / double(y);
    if (double(p.width) > double(p.height) * ratio)
        p.width = long(double(p.height) * ratio);
    else
        p.height = long(double(p.width) / ratio);
}

WindowPlace take_hints() {
    const WindowHints h = std::exchange(program().hints, {});
    WindowPlace p{h.x, h.y, h.width > 0 ? h.width : default_width,
                  h.height > 0 ? h.height : default_height};
    p.width = std::max(p.width, h.min_width);
    p.height = std::max(p.height, h.min_height);
    if (h.max_width > 0) p.width = std::min(p.width, h.max_width);
    if (h.max_height > 0) p.height = std::min(p.height, h.max_height);
    if (h.width == 0 && h.aspect_x > 0 && h.aspect_y > 0) fit_aspect(p, h.aspect_x, h.aspect_y);
    p.width = std::clamp(p.width, 1L, screen_width);
    p.height = std::clamp(p.height, 1L, screen_height);
    if (!h.has_origin) {
        p.x = (screen_width - p.width) / 2;
        p.y = (screen_height - p.height) / 2;
    }
    return p;
}

Window* find(const char* function, long id) {
    const auto found = program().windows.find(id);
    if (found != program().windows.end()) return found->second.get();
    warn(std::string(function) + ": there is no window " + std::to_string(id) + "; it is ignored");
    return nullptr;
}

/// What a program that ends has drawn to its front buffers is shown.
void show_at_exit() {
    if (program().current != nullptr) program().current->show_front();
}

void move_to(long x, long y, long width, long height) {
    Window& w = current_window();
    w.x = int(x);
    w.y = int(y);
    w.take_size(int(std::clamp(width, 1L, screen_width)),
                int(std::clamp(height, 1L, screen_height)));
    if (w.host() != nullptr) w.host()->place(w.x, w.y, w.width(), w.height());
    happen(REDRAW, w.id());
}

}  // namespace

long winopen(const std::string& title) {
    gl::start_recording();
    Program& p = program();
    const bool has_border = p.hints.has_border;
    const WindowPlace at = take_hints();
    long id = 1;
    while (p.windows.contains(id)) ++id;
    if (p.windows.empty()) std::atexit(show_at_exit);
    auto made = std::make_unique<Window>(
        id, int(at.width), int(at.height),
        make_host_window(title, int(at.x), int(at.y), int(at.width), int(at.height), has_border));
    Window& w = *p.windows.emplace(id, std::move(made)).first->second;
    w.x = int(at.x);
    w.y = int(at.y);
    w.make_current();
    greset();
    qdevice(INPUTCHANGE);
    qdevice(REDRAW);
    happen(REDRAW, id);
    happen(INPUTCHANGE, id);
    return id;
}

long swinopen(long) {
    warn("swinopen: a subwindow is opened as a window of its own");
    return winopen("");
}

void winclose(long id) {
    Window* const w = find("winclose", id);
    if (w == nullptr) return;
    if (program().current == w) {
        w->show_front();
        Window* next = nullptr;
        for (const auto& [other, window] : program().windows)
            if (other != id) next = window.get();
        program().windows.erase(id);
        program().current = nullptr;
        if (next != nullptr) next->make_current();
        return;
    }
    program().windows.erase(id);
}

void winset(long id) {
    Window* const w = find("winset", id);
    if (w == nullptr || w == program().current) return;
    if (program().current != nullptr) program().current->show_front();
    w->make_current();
}
long winget() { return program().current != nullptr ? program().current->id() : -1; }

void wintitle(const std::string& s) {
    if (current_window().host() != nullptr) current_window().host()->set_title(s);
}
void icontitle(const std::string&) {}
void winmove(long x, long y) {
    const Window& w = current_window();
    move_to(x, y, w.width(), w.height());
}
void winposition(long x1, long x2, long y1, long y2) { move_to(x1, y1, x2 - x1 + 1, y2 - y1 + 1); }
void winpop() {
    if (current_window().host() != nullptr) current_window().host()->raise(true);
}
void winpush() {
    if (current_window().host() != nullptr) current_window().host()->raise(false);
}
long winattach() { return winget(); }
long windepth(long id) { return id; }
void winconstraints() { program().hints = {}; }

void prefposition(long x1, long x2, long y1, long y2) {
    WindowHints& h = program().hints;
    h.has_origin = true;
    h.x = x1;
    h.y = y1;
    h.width = std::max(1L, x2 - x1 + 1);
    h.height = std::max(1L, y2 - y1 + 1);
}
void prefsize(long x, long y) {
    program().hints.width = std::max(1L, x);
    program().hints.height = std::max(1L, y);
}
void minsize(long x, long y) {
    program().hints.min_width = x;
    program().hints.min_height = y;
}
void maxsize(long x, long y) {
    program().hints.max_width = x;
    program().hints.max_height = y;
}
void keepaspect(long x, long y) {
    program().hints.aspect_x = x;
    program().hints.aspect_y = y;
}
void stepunit(long, long) {}
void fudge(long, long) {}
void iconsize(long, long) {}
void noborder() { program().hints.has_border = false; }
void noport() {}
void foreground() {}
void imakebackground() {}

void getsize(long* x, long* y) {
    *x = current_window().width();
    *y = current_window().height();
}
void getorigin(long* x, long* y) {
    *x = current_window().x;
    *y = current_window().y;
}

void fullscrn() {
    Window& w = current_window();
    w.screen_x = w.x;
    w.screen_y = w.y;
    w.old_width = w.width();
    w.old_height = w.height();
    move_to(0, 0, screen_width, screen_height);
    reshapeviewport();
}
void endfullscrn() {
    const Window& w = current_window();
    if (w.old_width > 0) move_to(w.screen_x, w.screen_y, w.old_width, w.old_height);
    reshapeviewport();
}

void ginit() {
    prefposition(0, screen_width - 1, 0, screen_height - 1);
    winopen("");
}
void gexit() {
    while (!program().windows.empty()) winclose(program().windows.begin()->first);
}

void textport(Screencoord, Screencoord, Screencoord, Screencoord) {}
void tpon() {}
void tpoff() {}
void blankscreen(Boolean) {}
void blanktime(long) {}
long scrnattach(long screen) { return screen == 0 || screen == INFOCUSSCRN ? 0 : -1; }
long scrnselect(long) { return 0; }
long getwscrn() { return 0; }
long ismex() { return 1; }
long getmonitor() { return 0; }
void setmonitor(short) {}

}  // namespace gw::irisgl::calls
