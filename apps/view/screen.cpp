#include "apps/view/screen.h"

#include "gw/base/arithmetic.h"

#include <algorithm>
#include <cstdlib>

namespace gw::apps {
namespace {

constexpr Color ground_color{28, 30, 34}, small_text{235, 235, 235};
constexpr int line_height = 18, small_line_height = 10;

void put_pixel(image::Picture& to, int x, int y, const Color& color) {
    if (x < 0 || y < 0 || x >= to.width || y >= to.height) return;
    std::copy(color.begin(), color.end(),
              to.values.begin() + std::ptrdiff_t(3 * (y * to.width + x)));
}

/// A row of `count` pixels as R, G, B of 8 bits.
void put_row(std::uint16_t* to, const std::uint16_t* from, int count,
             const image::Picture& picture) {
    const auto channels = std::size_t(picture.channels);
    if (picture.bits == 8 && channels == 3) {
        std::copy(from, from + 3 * count, to);
        return;
    }
    for (std::size_t x = 0; x < std::size_t(count); ++x)
        for (std::size_t c = 0; c < 3; ++c)
            to[3 * x + c] =
                std::uint16_t(rescale(from[x * channels + c % channels], picture.bits, 8));
}

/// `left`, `bottom`: where the picture's lower left corner comes. What does not fit is cut.
void put_picture_at(image::Picture& to, const image::Picture& picture, int left, int bottom) {
    const int width = std::min(picture.width, to.width - left);
    const int height = std::min(picture.height, to.height - bottom);
    for (int y = 0; y < height; ++y)
        put_row(&to.values[3 * pixel_index(left, bottom + y, to.width)],
                &picture.values[std::size_t(picture.channels) * pixel_index(0, y, picture.width)],
                width, picture);
}

/// A picture of one colour.
image::Picture painted(const Color& color, int width, int height) {
    image::Picture picture{.width = width, .height = height};
    std::vector<std::uint16_t> row;
    for (int x = 0; x < width; ++x) row.insert(row.end(), color.begin(), color.end());
    for (int y = 0; y < height; ++y)
        picture.values.insert(picture.values.end(), row.begin(), row.end());
    return picture;
}

void darken_rows(image::Picture& to, int width, int rows, int bottom) {
    for (int y = bottom; y < bottom + rows; ++y)
        for (int i = 0; i < 3 * width; ++i) to.values[std::size_t(3 * y * to.width + i)] /= 4;
}

void put_stroke(image::Picture& to, const std::array<int, 4>& stroke, int bottom) {
    const auto [x0, y0, x1, y1] = stroke;
    const int steps = std::min(std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1}), 10000);
    for (int i = 0; i <= steps; ++i)
        put_pixel(to, x0 + int(std::int64_t(x1 - x0) * i / steps),
                  bottom + y0 + int(std::int64_t(y1 - y0) * i / steps), {255, 230, 0});
}

std::string cut(const std::string& text, int letters) {
    return text.substr(0, std::size_t(std::max(letters, 0)));
}

}  // namespace

image::Picture screen_of(const ScreenContent& content, int width, int height) {
    image::Picture screen = painted(ground_color, width + panel_width, std::max(height, 480));
    const int bottom = screen.height - height;
    put_picture_at(screen, content.picture, 0, bottom);
    for (const auto& stroke : content.strokes) put_stroke(screen, stroke, bottom);
    const int rows = std::min(height, small_line_height * int(content.below.size()) + 4);
    if (!content.below.empty()) darken_rows(screen, width, rows, bottom);
    for (std::size_t i = 0; i < content.below.size(); ++i)
        write_text(screen, 4, height - rows + 3 + small_line_height * int(i), 1, small_text,
                   cut(content.below[i], (width - 8) / 6));
    for (std::size_t i = 0; i < content.panel.size(); ++i)
        write_text(screen, width + 8, 8 + line_height * int(i), 2, content.panel[i].color,
                   cut(content.panel[i].text, panel_letters));
    return screen;
}

image::Picture quarters(const std::vector<std::pair<std::string, image::Picture>>& planes) {
    const auto& first = planes.at(0).second;
    image::Picture out{.width = first.width, .height = first.height};
    out.values.resize(std::size_t(3 * out.width * out.height));
    for (std::size_t i = 0; i < planes.size() && i < 4; ++i) {
        const image::Picture half = image::downscaled(planes[i].second, 2);
        const int left = i % 2 == 0 ? 0 : out.width - half.width;
        const int low = i < 2 ? out.height - half.height : 0;
        put_picture_at(out, half, left, low);
        const int top = i < 2 ? 4 : out.height - half.height + 4;
        write_text(out, left + 5, top + 1, 2, {0, 0, 0}, planes[i].first);
        write_text(out, left + 4, top, 2, {255, 255, 255}, planes[i].first);
    }
    return out;
}

}  // namespace gw::apps
