// Every state variable that queries answer, found by asking for all names of GL's ranges.
#pragma once

#include <GL/gl.h>

#include <map>
#include <string>
#include <vector>

namespace gw::gl {

/// By name ("0xb00", "light 2 0x1200"); the values as doubles.
using Snapshot = std::map<std::string, std::vector<double>>;

/// Needs no error to be set. Not inside Begin and End.
Snapshot snapshot();

/// The names whose values differ.
std::vector<std::string> changes(const Snapshot& before, const Snapshot& after);

/// The name of a variable of GetDoublev in a snapshot.
std::string variable(GLenum name);

}  // namespace gw::gl
