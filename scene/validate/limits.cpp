#include "scene/validate/limits.h"

#include "scene/text/number.h"

namespace gw::scene {

std::string range_text(std::string_view what, Range range) {
    std::string text(what);
    if (range.low > Range{}.low) text += " from " + number_text(range.low);
    if (range.high < Range{}.high) text += " to " + number_text(range.high);
    return text;
}

}  // namespace gw::scene
