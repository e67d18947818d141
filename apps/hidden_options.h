// The options of gw hidden, and what each kind of run does with them. Parsing: hidden.cpp.
#pragma once

#include "apps/picture_options.h"
#include "hiddensurface/steps.h"

namespace gw::apps {

enum class Form { Text, Json, Csv };

struct HiddenOptions {
    PictureOptions picture{.size = {320, 240}};
    std::string algorithm;  ///< empty: all of hidden surfaces
    std::filesystem::path steps, compare;
    hiddensurface::Level level = hiddensurface::Level::Polygon;
    int pictures = 48;
    Form form = Form::Text;
};

/// `algorithm` is one of hidden lines: draws them, with counts and steps (hidden_lines.cpp).
int hidden_lines(const HiddenOptions& options);

}  // namespace gw::apps
