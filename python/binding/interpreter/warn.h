// Python's warnings.
#pragma once

#include <string>
#include <vector>

namespace gw::python {

/// A UserWarning for each line, said to be where Python's code called. Needs the interpreter's lock.
/// Throws what a filter of warnings makes of one.
void warn(const std::vector<std::string>& lines);

}  // namespace gw::python
