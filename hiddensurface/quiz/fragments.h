// Compares a student's fragment list with the Z-buffer's picture. A list is text: a line
// "x,y,polygon" for each visible fragment. x counts from 0 at the left, y from 0 at the top; polygon
// is the identifier. Empty lines, lines that begin with '#' and a first line "x,y,polygon" are
// skipped. Does not draw.
#pragma once

#include "hiddensurface/interface/algorithm.h"

#include <string_view>

namespace gw::hiddensurface {

struct Fragment {
    int x = 0, y = 0;  ///< from the top left
    std::uint32_t id = 0;
    int line = 0;  ///< of the list
};

/// Throws Error "name:line: what; expected what" for a line without three whole numbers, a pixel
/// outside the window, or a polygon that the scene does not have.
std::vector<Fragment> read_fragments(const std::string& name, std::string_view text,
                                     const Input& input);

enum class Mistake : std::uint8_t {
    None,
    /// a pixel shows a polygon, and the list has no fragment of a polygon that is over it
    Missing,
    Doubled,    ///< a second fragment at one pixel, of polygons that are over it
    Misplaced,  ///< its polygon is not over the pixel
    Wrong       ///< its polygon is over the pixel, and hidden there
};
const char* name_of(Mistake mistake);

struct FragmentMistake {
    Mistake mistake = Mistake::None;
    int x = 0, y = 0, line = 0;             ///< line 0: the fragment is missing
    std::uint32_t given = 0, expected = 0;  ///< 0: none, or background
};

struct FragmentGrade {
    /// pixels that show a polygon; fragments that are right
    std::uint64_t expected = 0, right = 0;
    std::uint64_t missing = 0, doubled = 0, misplaced = 0, wrong = 0;
    std::vector<FragmentMistake> mistakes;  ///< in the order of the list, the missing ones last
    bool all_right() const { return mistakes.empty(); }
};
/// `z_buffer`: identifiers, bottom row first. If the depth plane cannot tell two polygons apart,
/// either is right.
FragmentGrade grade_fragments(const std::vector<Fragment>& list,
                              const std::vector<std::uint32_t>& z_buffer, const Input& input);

/// The Z-buffer's picture as a fragment list.
std::string fragments_text(const std::vector<std::uint32_t>& z_buffer, const Input& input);

}  // namespace gw::hiddensurface
