// A stable merge sort that asks the same questions on every computer: counters and step logs show
// them, and the sorts of the C++ library differ. Counts nothing itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace gw::hiddensurface {

/// Joins two sorted neighbours. Asks once if they are in order already.
template <class Iterator, class Before>
void merge_sorted(Iterator first, Iterator middle, Iterator last, const Before& before) {
    if (first == middle || middle == last || !before(*middle, *(middle - 1))) return;
    std::vector<typename std::iterator_traits<Iterator>::value_type> left(
        std::make_move_iterator(first), std::make_move_iterator(middle));
    auto from = left.begin();
    while (from != left.end() && middle != last)
        *first++ = before(*middle, *from) ? std::move(*middle++) : std::move(*from++);
    std::move(from, left.end(), first);
}

template <class Iterator, class Before>
void merge_sort(Iterator first, Iterator last, const Before& before) {
    if (last - first < 2) return;
    const Iterator middle = first + (last - first) / 2;
    merge_sort(first, middle, before);
    merge_sort(middle, last, before);
    merge_sorted(first, middle, last, before);
}

}  // namespace gw::hiddensurface
