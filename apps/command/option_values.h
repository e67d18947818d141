// Words of the command line as values. Each throws UsageError "--size 0x0: expected ...", which is
// exit code 2. Does not know the options: they pass their names for the message.
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
/// Of a picture to be written: throws UsageError where no format has its extension, Error where the
/// file cannot be written.
void check_picture_target(const std::filesystem::path& file);
/// One of `known`; else the message lists them.
std::string one_of(const std::string& option, const std::string& word,
                   const std::vector<std::string>& known);

}  // namespace gw::apps
