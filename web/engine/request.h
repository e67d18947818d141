// The options of a call as a picture's request: the words of the command's options.
#pragma once

#include "render/request.h"

#include <nlohmann/json.hpp>

namespace gw::lab {

/// Reads `width` and `height`, and every option of render::options() by its name: words and numbers,
/// points as arrays of 3. An empty word stands for an option that is not given. One thread. Throws
/// render::OptionError.
render::Request request_of(const nlohmann::ordered_json& options);

}  // namespace gw::lab
