// What gw is called today and what it was made with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

std::string version();
/// Name, number; in a fixed order.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace gw::apps
