// The words of OBJ statements: numbers and the corners v/vt/vn. Does not know which statement has
// which.
#pragma once

#include "scene/obj/obj_data.h"
#include "scene/text/statements.h"

#include <span>

namespace gw::scene {

/// Reads all words of a text, in.rest() or a part of it, as numbers into `values`; returns how many
/// there are. Throws Error where a word is not a finite number or there are more than
/// values.size(); `form` is what is expected, "v x y z".
std::size_t read_numbers(const Statements& in, std::string_view text, std::span<float> values,
                         std::string_view form);

/// "Kd has 2 numbers; expected Kd r g b"
[[noreturn]] void fail_count(const Statements& in, std::size_t count, std::string_view form);

/// Reads one corner. Indices above the vertices read so far are taken: the file may bring them
/// later.
/// Throws Error for anything else than v, v/vt, v//vn, v/vt/vn, and for 0 and negative indices
/// before the first vertex.
Corner read_corner(const Statements& in, std::string_view word, const ObjData& obj);

}  // namespace gw::scene
