// Devices, the event queue, and the text of events that a program without a screen gets.
#pragma once

#include "irisgl/state/tokens.h"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gw::irisgl {

inline constexpr std::size_t queue_length = 101;
/// Parts of a frame that calls are worth, in programs that swap no buffers. docs/irisgl.md
inline constexpr unsigned parts_of_frame = 100'000, parts_of_poll = 100, parts_of_flush = 5'000,
                          parts_of_primitive = 10, parts_of_unshown_primitive = 1;

/// Mouse, dials and time are valuators; smaller numbers are buttons and keys.
constexpr bool is_valuator(unsigned device) { return device >= 256 && device < 512; }

struct Event {
    unsigned device = 0;
    long value = 0;
    int x = 0, y = 0;  ///< where the pointer was, on the screen
};

struct Valuator {
    long value = 0, low = 0, high = 1279;
    long queued = 0;  ///< the value of the last change that counted: noise
};

/// A line of GW_INPUT: what happens before frame `frame` is drawn.
struct ScriptedEvent {
    std::uint64_t frame = 0;
    Event event;
    bool has_place = false;
    int x = 0, y = 0;  ///< pixels of the window
};

struct Events {
    std::deque<Event> queue;
    Event taken;  ///< the last one that left the queue, valuators aside: ties follow a button
    std::set<unsigned> queued;
    std::map<unsigned, std::pair<unsigned, unsigned>> ties;
    std::set<unsigned> down;
    std::map<unsigned, Valuator> valuators{
        {MOUSEX, {.value = 639, .low = 0, .high = 1279, .queued = 639}},
        {MOUSEY, {.value = 511, .low = 0, .high = 1023, .queued = 511}}};
    std::map<unsigned, long> noise;
    std::deque<ScriptedEvent> script;
    bool is_script_read = false;
    std::uint64_t frame = 0;  ///< swaps, or parts_of_frame
    unsigned parts = 0;
};

/// Adds an event that a device makes: if it is queued, with the valuators that are tied to it.
void happen(unsigned device, long value);
/// Puts into the queue whatever is queued.
void enter(unsigned device, long value);
/// The queue's first event, which leaves it. Precondition: there is one.
Event take();
/// Takes what the screen and the script have, shows what was drawn, and ends a program that waits in
/// vain (`waits`), or has shown its last frame.
void poll(bool waits);
/// Shows the map. On a screen, time passes and events come.
void wait_on_screen(int milliseconds);
/// Counts a call as `parts` of a frame: a loop of such calls ends with GW_FRAMES.
void pass(unsigned parts);
/// The script's next events are due: a swap.
void next_frame();
/// The device of this name, as LEFTMOUSE or AKEY; 0: there is none.
unsigned device_named(const std::string& name);

/// Lines "frame 3 LEFTMOUSE down 100 200": before frame 3 is drawn, in pixels of the window; a value
/// is down, up, a number, or a character for KEYBD. A wrong line is reported and left out.
std::deque<ScriptedEvent> read_script();

}  // namespace gw::irisgl
