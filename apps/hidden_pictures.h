// Pictures that show what a hidden-surface algorithm does: polygons in flat colours, steps with highlights,
// differences, counts. 3 channels of 8 bits. Does not run algorithms or write files.
#pragma once

#include "hiddensurface/compare.h"
#include "hiddensurface/replay.h"
#include "image/picture.h"

#include <map>

namespace gw::apps {

using Color = std::array<std::uint16_t, 3>;

/// A colour for each identifier: Kd of its material, darker the more it is turned from the eye; 0 is the
/// background.
std::map<std::uint32_t, Color> flat_colors(const hiddensurface::Input& input);

image::Picture picture_of_ids(const hiddensurface::Input& input, const std::vector<std::uint32_t>& ids,
                              const std::map<std::uint32_t, Color>& colors);

/// The replay's picture, and in it the last step: the border of its first polygon white, of the second
/// yellow, of others grey; its scan line lighter; its span white.
image::Picture picture_of_step(const hiddensurface::Input& input, const hiddensurface::Replay& replay,
                               const std::map<std::uint32_t, Color>& colors);

/// Dark where equal; ties yellow, edges cyan, snapped blue, wrong pixels red.
image::Picture picture_of_difference(image::Picture picture,
                                     const std::vector<hiddensurface::Difference>& difference);

/// 0 black, 1 blue, 2 green, 3 yellow, 4 orange, 5 red, more towards white.
image::Picture picture_of_counts(const std::vector<std::uint8_t>& counts, int width, int height);

/// Rows of pictures of one size, 4 pixels apart, the first row on top.
image::Picture sheet_of(const std::vector<std::vector<image::Picture>>& rows);

std::string hex_of(const Color& color);

}  // namespace gw::apps
