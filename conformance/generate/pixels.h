// Commands on pixels: clears, spans, rectangles, accumulation, copies, read-backs. Does not set
// state.
#pragma once

#include "conformance/generate/case.h"

namespace gw::conformance {

struct Script;

Clear any_clear(Random& random);
WriteSpans any_spans(Random& random, const Case& where);
WritePixels any_pixels(Random& random, const Case& where);
Accumulate any_accumulate(Random& random, const Profile& profile);
Copy any_copy(Random& random, const Case& where);
Read any_read(Random& random, const Case& where);
/// A rectangle of any kind, zoomed, around the window, with a map or without.
DrawPixels any_draw_pixels(Script& script);
/// Fills a slot and notes it in the script.
void copy_texture(Script& script, Plane plane);

Rgba any_pixel(Random& random, int color_bits);

}  // namespace gw::conformance
