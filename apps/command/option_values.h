// Words of the command line as values. Each function throws UsageError "--size 0x0: expected ...",
// exit code 2. Callers pass the option's name for the message.
#pragma once

#include "gw/base/types.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

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
/// Checks the name of a picture to write. Throws UsageError if no format has its extension, Error
/// if the file cannot be written.
void check_picture_target(const std::filesystem::path& file);
/// The word, which is one of `known`; the error message lists them.
std::string one_of(const std::string& option, const std::string& word,
                   const std::vector<std::string>& known);

}  // namespace gw::apps
