// Gives a program the values of a query.
#pragma once

#include "gl/context/context.h"
#include "gl/query/values.h"

#include <optional>

namespace gw::gl {

/// None: INVALID_ENUM.
template <class T>
void get(Context& context, const std::optional<QueryValues>& values, T* params) {
    if (!values) return set_error(context, GL_INVALID_ENUM);
    if (params != nullptr) store(*values, params);
}

}  // namespace gw::gl
