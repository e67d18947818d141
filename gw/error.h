// Error: the exception for wrong input, with a message of one line. Caught once, in apps/.
// Not for mistakes inside the program.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace gw {

class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}

    /// "rings.mtl:12: Kd has two numbers; expected three". Lines count from 1; line 0 stands for
    /// the whole file: "rings.mtl: ...".
    Error(std::string_view file, int line, std::string_view what);
};

/// The text of the second constructor.
std::string at_line(std::string_view file, int line, std::string_view what);

}  // namespace gw
