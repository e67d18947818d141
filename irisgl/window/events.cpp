#include "irisgl/state/events.h"

#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "gl/drawable/settings.h"

#include "irisgl/state/tokens.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace gw::irisgl {

namespace {

constexpr auto frame_time = std::chrono::milliseconds(16);

Events& events() { return program().events; }

/// Without a screen nothing but the script makes events.
bool has_screen() { return program().current != nullptr && program().current->host() != nullptr; }

[[noreturn]] void end_program(const char* why) {
    if (program().current != nullptr) program().current->show_front();
    std::fprintf(stderr, "gw: %s; the program ends\n", why);
    std::exit(0);
}

void play(const ScriptedEvent& e) {
    if (e.has_place && program().current != nullptr) {
        happen(MOUSEX, program().current->x + e.x);
        happen(MOUSEY, program().current->y + e.y);
    }
    happen(e.event.device, e.event.value);
}

void play_script(bool waits) {
    Events& all = events();
    if (!all.is_script_read) {
        all.is_script_read = true;
        all.script = read_script();
    }
    while (!all.script.empty() && all.script.front().frame <= all.frame) {
        const ScriptedEvent e = all.script.front();
        all.script.pop_front();
        play(e);
    }
    if (waits && all.queue.empty() && !all.script.empty()) {  // time passes
        all.frame = all.script.front().frame;
        play_script(waits);
    }
}

void listen(int milliseconds) {
    Window& w = *program().current;
    HostListener listener;
    listener.button = [](unsigned device, bool down) { happen(device, down ? 1 : 0); };
    listener.character = [](unsigned char c) { happen(KEYBD, c); };
    listener.pointer = [&](int x, int y) {
        happen(MOUSEX, w.x + x);
        happen(MOUSEY, w.y + y);
    };
    listener.size = [&](int width, int height) {
        if (width == w.width() && height == w.height()) return;
        w.take_size(width, height);
        happen(REDRAW, w.id());
    };
    listener.place = [&](int x, int y) {
        w.x = x;
        w.y = y;
    };
    listener.exposed = [&] {
        w.show_again();
        if (!w.state.double_buffered) happen(REDRAW, w.id());
    };
    listener.focused = [&] { happen(INPUTCHANGE, w.id()); };
    listener.closed = [&] {
        if (events().queued.contains(WINQUIT)) return happen(WINQUIT, w.id());
        std::exit(0);
    };
    wait_for_screen(milliseconds);
    w.host()->poll(listener);
}

/// Maps follow one another as cyclemap has said; `retraces` since the program began.
void cycle_maps(long retraces) {
    ColorMap& map = program().colors;
    static long since = 0;
    const auto now = map.cycles.find(map.number);
    if (!map.is_multi || now == map.cycles.end() || retraces - since < now->second.duration) return;
    since = retraces;
    map.number = now->second.next;
    ++map.changes;
}

/// Blinking colours exchange with each 60th of a second that the rate says.
void blink_colors() {
    ColorMap& map = program().colors;
    if (map.blinks.empty() && map.cycles.empty()) return;
    using Clock = std::chrono::steady_clock;
    static const auto begin = Clock::now();
    const long retraces =
        std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin).count() * 60 /
        1000;
    if (has_screen()) cycle_maps(retraces);
    for (auto& [index, blink] : map.blinks) {
        const bool other = has_screen() && retraces / std::max<long>(blink.rate, 1) % 2 == 1;
        if (other != blink.shows_other) ++map.changes;
        blink.shows_other = other;
    }
}

}  // namespace

void enter(unsigned device, long value) {
    Events& all = events();
    if (all.queue.size() >= queue_length) return;
    const auto at = [&](unsigned valuator) { return int(all.valuators[valuator].value); };
    all.queue.push_back({device, value, at(MOUSEX), at(MOUSEY)});
}

Event take() {
    Events& all = events();
    const Event first = all.queue.front();
    all.queue.pop_front();
    if (!is_valuator(first.device)) all.taken = first;
    return first;
}

void happen(unsigned device, long value) {
    Events& all = events();
    if (is_valuator(device)) {
        Valuator& v = all.valuators[device];
        v.value = std::clamp(value, v.low, std::max(v.low, v.high));
        const auto noise = all.noise.find(device);
        const long least = noise != all.noise.end() ? std::max(noise->second, 1L) : 1;
        if (std::abs(v.value - v.queued) < least) return;
        v.queued = v.value;
    } else if (device < 256) {
        value != 0 ? void(all.down.insert(device)) : void(all.down.erase(device));
    }
    if (!all.queued.contains(device)) return;
    enter(device, value);
    const auto tie = all.ties.find(device);
    if (tie == all.ties.end()) return;
    for (const unsigned valuator : {tie->second.first, tie->second.second})
        if (valuator != 0) enter(valuator, all.valuators[valuator].value);
}

void next_frame() {
    Events& all = events();
    ++all.frame;
    all.parts = 0;
    blink_colors();
    play_script(false);
    if (has_screen()) listen(0);
}

void poll(bool waits) {
    Events& all = events();
    blink_colors();
    play_script(waits);
    if (program().current == nullptr) {
        if (waits && all.queue.empty())
            end_program("qread: no window is open and no event can come");
        return;
    }
    Window& w = *program().current;
    using Clock = std::chrono::steady_clock;
    static Clock::time_point shown;
    if (has_screen()) {
        if (waits || Clock::now() - shown > frame_time) {
            w.state.double_buffered ? w.show_map() : w.show_front();
            shown = Clock::now();
        }
        listen(0);
        if (!waits) pass(parts_of_poll);
        while (waits && all.queue.empty()) {
            blink_colors();
            w.show_map();
            listen(20);
            play_script(true);
        }
        return;
    }
    if (waits) w.state.double_buffered ? w.show_map() : w.show_front();
    if (waits && all.queue.empty()) end_program("qread: no more events come");
    pass(parts_of_poll);
}

void wait_on_screen(int milliseconds) {
    if (program().current == nullptr) return;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    blink_colors();
    program().current->show_map();
    while (has_screen()) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        listen(int(std::max<long>(left, 0)));
        if (left <= 0) return;
    }
}

void pass(unsigned parts) {
    Events& all = events();
    if (program().current == nullptr) return;
    all.parts += parts;
    if (all.parts < parts_of_frame) return;
    all.parts = 0;
    const gl::FrameRange frames = gl::read_frame_range();
    const bool ends = frames.last != gl::FrameRange().last;
    if (has_screen() && !ends) return;  // whoever looks at it ends it
    ++all.frame;
    Window& w = *program().current;
    w.state.double_buffered ? w.show_map() : w.show_front();
    if (all.frame > frames.last) end_program("the last frame of GW_FRAMES is over");
}

}  // namespace gw::irisgl
