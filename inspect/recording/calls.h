// Which calls of a program made the commands of a list: numbers, functions, display lists. Optional:
// only recordings of OpenGL programs have them. Does not change what is drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gw::inspect {

inline constexpr std::uint32_t no_call = 0xFFFFFFFF;

/// A call, counted from 0: in its frame or, if a display list makes it, in that list.
struct Call {
    std::uint32_t number = 0;
    std::uint32_t function = 0;      ///< a place in functions: "glVertex3f"
    std::uint32_t source = no_call;  ///< a place in sources: "main+0x1f in gears"; no_call: unknown
    std::uint32_t list = no_call;    ///< a place in lists: the display list; no_call: the frame
    bool operator==(const Call&) const = default;
};

/// A display list that is being played.
struct PlayedList {
    std::uint32_t name = 0;
    Call caller;  ///< in an earlier list, or in the frame
    bool operator==(const PlayedList&) const = default;
};

/// The primitives of a command from `first` on: `call` completed the first, and the call `step`
/// numbers later each further one. Of commands without primitives: the call that made it.
struct CallRun {
    std::uint32_t command = 0;  ///< in its list
    std::uint32_t first = 0;
    Call call;
    std::uint32_t step = 0;
    std::uint32_t ordinal = 0;  ///< of the first primitive since Begin, or in its array
    bool operator==(const CallRun&) const = default;
};

/// Of one list of commands. Runs are in the order of commands and primitives.
struct CallTable {
    std::vector<std::string> functions, sources;
    std::vector<PlayedList> lists;
    std::vector<CallRun> runs;
    bool operator==(const CallTable&) const = default;
};

}  // namespace gw::inspect
