// The words of OBJ statements: numbers and the corners v/vt/vn. Does not know the statements.
#pragma once

#include "scene/obj/obj_data.h"
#include "scene/text/statements.h"

#include <optional>
#include <span>
#include <string>

namespace gw::scene {

/// Reads all words of a text, in.rest() or a part of it, as numbers into `values`; returns their
/// count. Throws Error for a word that is not a finite number, and for more than values.size()
/// words; `form` is the expected form, "v x y z".
std::size_t read_numbers(const Statements& in, std::string_view text, std::span<float> values,
                         std::string_view form);

/// What is wrong with the first number that is not finite; none: all are, or a word is no number.
std::optional<std::string> not_finite(std::string_view text, std::string_view form);

/// "Kd has 2 numbers; expected Kd r g b"
[[noreturn]] void fail_count(const Statements& in, std::size_t count, std::string_view form);

/// Reads one corner. Accepts indices above the vertices read so far: the file may define them
/// later. Throws Error for anything else than v, v/vt, v//vn, v/vt/vn, for 0, and for negative
/// indices before the first vertex.
Corner read_corner(const Statements& in, std::string_view word, const ObjData& obj);

}  // namespace gw::scene
