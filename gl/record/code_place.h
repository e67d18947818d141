// Where in the program an address of code is.
#pragma once

#include <string>

namespace gw::gl {

/// "main+0x1f in gears", if the program exports the name; else "gears+0x1a2f"; the bare address, if
/// no loaded file has it.
std::string code_place(const void* address);

}  // namespace gw::gl
