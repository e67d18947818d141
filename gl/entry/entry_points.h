// The entry points as a table: names, kinds and addresses, made from functions.txt.
#pragma once

#include "gl/api/kind.h"
#include "gl/api/offer.h"

#include <cstdint>
#include <span>

namespace gw::gl {

using Address = void (*)();
struct EntryPoint {
    const char* name;  ///< "glBegin"
    Kind kind;
    Address address;
    Offer offer;
};

/// The functions of the table, in the order of Function.
std::span<const EntryPoint> entry_points();

/// The address of the function of this name; null if there is none, or if the user's version and
/// profile do not offer it.
Address find_entry_point(const char* name);

/// What a function that is not offered does: INVALID_OPERATION, and returns 0.
std::intptr_t not_offered();

}  // namespace gw::gl
