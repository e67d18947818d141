#include "gw/command_name.h"

#include <iterator>

namespace gw {

const char* command_name(const Command& command) {
    static constexpr const char* names[] = {"BeginPass",   "Clear",       "SetState",   "Draw",
                                            "WriteSpans",  "WritePixels", "Accumulate", "Copy",
                                            "CopyTexture", "Read"};
    static_assert(std::size(names) == std::variant_size_v<Command>);
    return names[command.index()];
}

}  // namespace gw
