// A point or direction for the page: an array of 3 numbers.
#pragma once

#include "gw/base/types.h"

#include <nlohmann/json.hpp>

namespace gw::lab {

inline nlohmann::ordered_json json_of(const dvec3& p) {
    return nlohmann::ordered_json::array({p.x, p.y, p.z});
}

}  // namespace gw::lab
