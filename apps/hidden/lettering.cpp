#include "apps/hidden/lettering.h"

#include <algorithm>

namespace gw::apps {
namespace {

constexpr int glyph_width = 5, glyph_height = 7, tail_height = 2, glyphs_in_row = 16;
/// The distance from letter to letter, and from line to line.
constexpr int letter_width = 6, line_height = 10;
constexpr std::uint16_t ground = 24;

/// ' ' to '~', and a box for all other characters: six rows of sixteen glyphs, seven lines each.
// clang-format off
constexpr std::string_view glyphs =
    "..... ..#.. .#.#. .#.#. ..#.. ##... .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... ..... "
    "..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... ....# "
    "..... ..#.. .#.#. ##### #.#.. ...#. #.#.. .#... .#... ...#. #.#.# ..#.. ..... ..... ..... ...#. "
    "..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... ##### ..... ..#.. "
    "..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..##. ..... ..... .#... "
    "..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. ..#.. ..... .##.. #.... "
    "..... ..#.. ..... .#.#. ..#.. ...## .##.# ..... ...#. .#... ..... ..... .#... ..... .##.. ..... "

    ".###. ..#.. .###. ##### ...#. ##### ..##. ##### .###. .###. ..... ..... ...#. ..... .#... .###. "
    "#...# .##.. #...# ...#. ..##. #.... .#... ....# #...# #...# .##.. .##.. ..#.. ..... ..#.. #...# "
    "#..## ..#.. ....# ..#.. .#.#. ####. #.... ...#. #...# #...# .##.. .##.. .#... ##### ...#. ....# "
    "#.#.# ..#.. ...#. ...#. #..#. ....# ####. ..#.. .###. .#### ..... ..... #.... ..... ....# ...#. "
    "##..# ..#.. ..#.. ....# ##### ....# #...# .#... #...# ....# .##.. .##.. .#... ##### ...#. ..#.. "
    "#...# ..#.. .#... #...# ...#. #...# #...# .#... #...# ...#. .##.. ..#.. ..#.. ..... ..#.. ..... "
    ".###. .###. ##### .###. ...#. .###. .###. .#... .###. .##.. ..... .#... ...#. ..... .#... ..#.. "

    ".###. .###. ####. .###. ###.. ##### ##### .###. #...# .###. ..### #...# #.... #...# #...# .###. "
    "#...# #...# #...# #...# #..#. #.... #.... #...# #...# ..#.. ...#. #..#. #.... ##.## #...# #...# "
    "#.### #...# #...# #.... #...# #.... #.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# ##..# #...# "
    "#.#.# ##### ####. #.... #...# ####. ####. #.### ##### ..#.. ...#. ##... #.... #.#.# #.#.# #...# "
    "#.##. #...# #...# #.... #...# #.... #.... #...# #...# ..#.. ...#. #.#.. #.... #...# #..## #...# "
    "#.... #...# #...# #...# #..#. #.... #.... #...# #...# ..#.. #..#. #..#. #.... #...# #...# #...# "
    ".###. #...# ####. .###. ###.. ##### #.... .#### #...# .###. .##.. #...# ##### #...# #...# .###. "

    "####. .###. ####. .#### ##### #...# #...# #...# #...# #...# ##### .###. ..... .###. ..#.. ..... "
    "#...# #...# #...# #.... ..#.. #...# #...# #...# #...# #...# ....# .#... #.... ...#. .#.#. ..... "
    "#...# #...# #...# #.... ..#.. #...# #...# #...# .#.#. .#.#. ...#. .#... .#... ...#. #...# ..... "
    "####. #...# ####. .###. ..#.. #...# #...# #.#.# ..#.. ..#.. ..#.. .#... ..#.. ...#. ..... ..... "
    "#.... #.#.# #.#.. ....# ..#.. #...# #...# #.#.# .#.#. ..#.. .#... .#... ...#. ...#. ..... ..... "
    "#.... #..#. #..#. ....# ..#.. #...# .#.#. ##.## #...# ..#.. #.... .#... ....# ...#. ..... ..... "
    "#.... .##.# #...# ####. ..#.. .###. ..#.. #...# #...# ..#.. ##### .###. ..... .###. ..... ##### "

    ".#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. ..... ..... ..... "
    "..#.. ..... #.... ..... ....# ..... .#..# ..... #.... ..... ..... #.... ..#.. ..... ..... ..... "
    "...#. .###. ####. .###. .#### .###. .#... .#### #.##. .##.. ..##. #..#. ..#.. ##.#. #.##. .###. "
    "..... ....# #...# #.... #...# #...# ###.. #...# ##..# ..#.. ...#. #.#.. ..#.. #.#.# ##..# #...# "
    "..... .#### #...# #.... #...# ##### .#... .#### #...# ..#.. ...#. ##... ..#.. #.#.# #...# #...# "
    "..... #...# #...# #...# #...# #.... .#... ....# #...# ..#.. #..#. #.#.. ..#.. #...# #...# #...# "
    "..... .#### ####. .###. .#### .###. .#... .###. #...# .###. .##.. #..#. .###. #...# #...# .###. "

    "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ...#. ..#.. .#... ..... ##### "
    "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..#.. ..#.. ..#.. ..... #...# "
    "####. .##.# #.##. .#### ###.. #...# #...# #...# #...# #...# ##### ..#.. ..#.. ..#.. ..... #...# "
    "#...# #..## ##..# #.... .#... #...# #...# #...# .#.#. #...# ...#. .#... ..#.. ...#. .#... #...# "
    "####. .#### #.... .###. .#... #...# #...# #.#.# ..#.. .#### ..#.. ..#.. ..#.. ..#.. #.#.# #...# "
    "#.... ....# #.... ....# .#..# #..## .#.#. #.#.# .#.#. ....# .#... ..#.. ..#.. ..#.. ...#. #...# "
    "#.... ....# #.... ####. ..##. .##.# ..#.. .#.#. #...# .###. ##### ...#. ..#.. .#... ..... ##### ";
// clang-format on

constexpr int line_length = glyphs_in_row * (glyph_width + 1);
static_assert(glyphs.size() == 6 * glyph_height * line_length);

/// The tails of these are below the line: row 3, the side of the bowl, stands three times.
bool descends(char letter) {
    return std::string_view("gpqy").find(letter) != std::string_view::npos;
}

/// `x` from the left, `y` from the top.
bool is_ink(char letter, int x, int y) {
    if (descends(letter)) y = y <= 3 ? y : std::max(3, y - tail_height);
    if (y >= glyph_height) return false;
    const int code = letter >= ' ' && letter <= '~' ? letter : 127;
    const int row = (code - ' ') / glyphs_in_row, column = (code - ' ') % glyphs_in_row;
    return glyphs[std::size_t((row * glyph_height + y) * line_length + column * (glyph_width + 1) +
                              x)] == '#';
}

void put_square(image::Picture& picture, int left, int top, int size, const Color& color) {
    for (int y = std::max(top, 0); y < std::min(top + size, picture.height); ++y)
        for (int x = std::max(left, 0); x < std::min(left + size, picture.width); ++x)
            std::copy(color.begin(), color.end(),
                      picture.values.begin() +
                          std::ptrdiff_t(3 * ((picture.height - 1 - y) * picture.width + x)));
}

int length_of(const TextLine& line) {
    int letters = int(line.size()) - 1;  // a space between words
    for (const Word& word : line) letters += int(word.text.size());
    return std::max(letters, 1);
}

}  // namespace

void write_text(image::Picture& picture, int left, int top, int scale, const Color& color,
                std::string_view text) {
    for (const char letter : text) {
        for (int y = 0; y < glyph_height + tail_height; ++y)
            for (int x = 0; x < glyph_width; ++x)
                if (is_ink(letter, x, y))
                    put_square(picture, left + x * scale, top + y * scale, scale, color);
        left += letter_width * scale;
    }
}

image::Picture captioned(const image::Picture& picture, const std::vector<TextLine>& lines) {
    const int largest = std::max(picture.width / 160, 1), step = line_height * largest;
    image::Picture out = picture;
    out.height += int(lines.size()) * step + 2 * largest;
    // the last rows are the upper ones
    out.values.resize(std::size_t(3 * out.width * out.height), ground);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int fits = picture.width / (letter_width * length_of(lines[i]));
        const int scale = std::clamp(fits, 1, largest);
        int left = scale;
        for (const Word& word : lines[i]) {
            write_text(out, left, int(i) * step + 2 * largest, scale, word.color, word.text);
            left += (int(word.text.size()) + 1) * letter_width * scale;
        }
    }
    return out;
}

}  // namespace gw::apps
