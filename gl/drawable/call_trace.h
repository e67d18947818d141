// The calls that made the machine's commands: their numbers in the frame, their functions, the
// display lists that played them. Kept while somebody records.
#pragma once

#include "generated/gl/function_names.h"
#include "generated/gl/functions.h"

#include <GL/gl.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gw::gl {

struct PlayedList;

struct CallPlace {
    std::uint32_t number = 0;      ///< from 0: in the frame, or in the display list
    const char* function = "";     ///< "glVertex3f"; never dies
    const void* source = nullptr;  ///< in the program, behind the call; null: a display list's
    std::shared_ptr<const PlayedList> list;  ///< null: the frame
};

inline const char* name_of(Function function) { return function_names[std::size_t(function)]; }

/// A display list that is being played.
struct PlayedList {
    GLuint name = 0;
    CallPlace caller;
};

/// The primitives of a command from `first` on: `call` completed the first, the call `step` numbers
/// later each further one.
struct CallRun {
    std::uint32_t command = 0;  ///< in its list of commands
    std::uint32_t first = 0;
    CallPlace call;
    std::uint32_t step = 0;
    std::uint32_t ordinal = 0;  ///< of the first primitive since Begin
};

/// Where a context is in its calls.
struct CallTrace {
    std::uint32_t next = 0;                  ///< the number of the frame's next call
    CallPlace now;                           ///< the call that is being carried out
    std::shared_ptr<const PlayedList> list;  ///< that is being played
    bool is_one_call = false;   ///< what is played is one call to the program: vertex arrays
    std::vector<CallRun> runs;  ///< of the assembled mesh
};

/// Whether calls are kept.
inline constinit std::atomic<bool> calls_are_kept = false;

}  // namespace gw::gl
