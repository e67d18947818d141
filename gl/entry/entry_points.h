// The entry points as a table: names, kinds and addresses, made from functions.txt.
#pragma once

#include "gl/api/kind.h"

#include <cstdint>
#include <span>

namespace gw::gl {

using Address = void (*)();
struct EntryPoint {
    const char* name;  ///< "glBegin"
    Kind kind;
    Address address;
};

/// The functions that exist, in the order of Function.
std::span<const EntryPoint> entry_points();
/// The functions of later versions.
std::span<const EntryPoint> later_entry_points();

/// The address of the function of this name; null if there is none.
Address find_entry_point(const char* name);

/// What a function of a later version does: INVALID_OPERATION, and returns 0.
std::intptr_t later();

}  // namespace gw::gl
