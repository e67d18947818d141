// Walks faces by scan lines, from the top down: the faces that begin at a line, and the two ends of
// each active face on it. One integer step for each edge and line [L7]. Does not sort in x or compare
// depths.
#pragma once

#include "hiddensurface/faces/face.h"
#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/structures/merge_sort.h"

#include <memory>

namespace gw::hiddensurface {

/// A face's segment of the line: pixels x0 .. x1 - 1, none if x0 >= x1.
struct ActiveFace {
    const Face* face = nullptr;
    int x0 = 0, x1 = 0;
    bool done = false;                  ///< its last line is past
    std::vector<EdgeWalk> left, right;  ///< the lowest first
};

class ActiveFaces {
public:
    /// Refers to the faces.
    ActiveFaces(const std::vector<Face>& faces, const Input& input);

    /// Goes to the line below, the first time to the top line. Updates every active face's ends;
    /// `done` if it has none.
    void next_line();
    /// The faces that begin at this line. Their addresses stay the same.
    const std::vector<ActiveFace*>& begun() const { return begun_; }
    std::uint64_t bytes() const;

private:
    void step(ActiveFace& active) const;

    int width_ = 0, y_ = 0;
    std::vector<std::vector<std::unique_ptr<ActiveFace>>> waiting_;  ///< by their first line
    std::vector<std::unique_ptr<ActiveFace>> active_;
    std::vector<ActiveFace*> begun_;
};

/// Sorts a list again that was sorted on the line above. Exchanges neighbours, only as many as
/// changed places; the last `more` elements are new. Counts crossings and swaps.
template <class T, class Before>
void sort_again(std::vector<T>& list, std::size_t more, Counts& counts, const Before& before) {
    counts.sorts += 1;
    const auto counted = [&](const T& a, const T& b) {
        counts.crossings += 1;
        return before(a, b);
    };
    const std::size_t old = list.size() - more;
    for (std::size_t i = 1; i < old; ++i)
        for (std::size_t k = i; k > 0 && counted(list[k], list[k - 1]); --k) {
            std::swap(list[k], list[k - 1]);
            counts.swaps += 1;
        }
    const auto middle = list.begin() + std::ptrdiff_t(old);
    merge_sort(middle, list.end(), counted);
    merge_sorted(list.begin(), middle, list.end(), counted);
}

}  // namespace gw::hiddensurface
