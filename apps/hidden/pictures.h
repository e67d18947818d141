// Pictures of a hidden-surface algorithm's work: polygons in flat colours, differences, counts, and
// their captions. 3 channels of 8 bits. Does not run algorithms or write
// files.
#pragma once

#include "apps/hidden/lettering.h"
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/interface/steps.h"
#include "hiddensurface/run/compare.h"

#include <map>

namespace gw::apps {

using hiddensurface::hex_of;

inline constexpr Color white{255, 255, 255}, yellow{255, 230, 0}, grey{150, 150, 150},
    red{230, 20, 20}, cyan{0, 210, 230}, blue{70, 90, 255};

/// The colours of 0, 1, 2, 3, 4 and 5 times. More times turn this red towards white.
inline constexpr std::array<Color, 6> colors_of_counts{
    {{0, 0, 0}, {50, 90, 230}, {20, 150, 60}, {240, 210, 40}, {240, 130, 20}, red}};

/// Black, 3 channels of 8 bits.
image::Picture blank(int width, int height);
/// `pixel`: row by row from the bottom left one, 0.
void put(image::Picture& picture, std::size_t pixel, const Color& color);

image::Picture picture_of_ids(const hiddensurface::Input& input,
                              const std::vector<std::uint32_t>& ids,
                              const std::map<std::uint32_t, Color>& colors);

/// Each pixel is the sum of its polygons' colours, weighted by their parts; the background has the
/// rest.
image::Picture picture_of_shares(const hiddensurface::Input& input,
                                 const std::vector<hiddensurface::Share>& shares,
                                 const std::map<std::uint32_t, Color>& colors);

/// Equal pixels are dark, ties yellow, edges cyan, snapped blue, wrong pixels red.
image::Picture picture_of_difference(image::Picture picture,
                                     const std::vector<hiddensurface::Difference>& difference);

/// The counts in colors_of_counts.
image::Picture picture_of_counts(const std::vector<std::uint8_t>& counts, int width, int height);

/// A small picture, enlarged by a whole factor to a width of about 320 pixels.
image::Picture enlarged(const image::Picture& picture);

/// Rows of pictures of one size, 4 pixels apart. The first row is on top.
image::Picture sheet_of(const std::vector<std::vector<image::Picture>>& rows);

/// Captions for a comparison's picture and difference.
std::array<std::vector<TextLine>, 2> captions_of(const std::string& algorithm,
                                                 const hiddensurface::Counts& counts);

}  // namespace gw::apps
