// The page (web/report) and the price list, built in: a report needs nothing but the program.
#pragma once

#include <string_view>

namespace gw::report {

/// A file's bytes by its name: "report.html". Empty if it is not built in.
std::string_view embedded(std::string_view name);

}  // namespace gw::report
