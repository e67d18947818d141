// Words of options as values. Each function throws OptionError "size '0x0': expected ...", with the
// option's name as the caller has it. Does not know the options (options.h).
#pragma once

#include "gw/base/types.h"
#include "gw/error.h"

#include <string>
#include <utility>
#include <vector>

namespace gw::render {

/// A value that an option refuses. The text begins with the option's name, without dashes, unless
/// the caller named it with them.
class OptionError : public Error {
public:
    using Error::Error;
    OptionError(const std::string& option, const std::string& word, const std::string& expected);
};

struct Size {
    int width = 640, height = 480;
    bool operator==(const Size&) const = default;
};
/// "640x480", both 1 .. max_window_size.
Size size_from(const std::string& option, const std::string& word);

int whole_number_from(const std::string& option, const std::string& word, int low, int high);
/// "3-7" or "3": first and last, low <= first <= last <= high.
std::pair<int, int> range_from(const std::string& option, const std::string& word, int low,
                               int high);
/// Finite, low .. high.
double number_from(const std::string& option, const std::string& word, double low, double high);
/// "1,2.5,-3"
dvec3 point_from(const std::string& option, const std::string& word);
/// "a, b, c"
std::string listed(const std::vector<std::string>& words);
/// The word, which is one of `known`; the error message lists them.
std::string one_of(const std::string& option, const std::string& word,
                   const std::vector<std::string>& known);

}  // namespace gw::render
