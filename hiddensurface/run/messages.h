// What is wrong with the steps of a program, and how it was graded, in another language: by the
// patterns of messages.ja.json, for the command and the pages. Messages are made in English.
#pragma once

#include <string>

namespace gw::hiddensurface {

/// Line by line in "en" or "ja". A line that fits no pattern, such as a program's own, stays; so
/// does what stands between quotation marks.
std::string messages_in(const std::string& text, const std::string& language);

}  // namespace gw::hiddensurface
