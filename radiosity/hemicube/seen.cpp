// Rows of pixels as bits: a comparison is made for a vector of pixels, the rest for 64 at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/hemicube/seen.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/hemicube/seen.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<std::uint32_t>;

/// bits: of each of `count` pixels, whether it is that at `other`.
void mark_same(const std::uint32_t* at, const std::uint32_t* other, std::size_t count,
               std::uint64_t* bits) {
    const D d;
    std::size_t i = 0;
    for (std::size_t word = 0; i < count; ++word) {
        std::uint64_t same = 0;
        const std::size_t end = HWY_MIN(count, i + 64);
        const std::size_t first = i;
        for (; i + hn::Lanes(d) <= end; i += hn::Lanes(d)) {
            std::uint64_t part = 0;
            hn::StoreMaskBits(d, hn::Eq(hn::LoadU(d, at + i), hn::LoadU(d, other + i)),
                              reinterpret_cast<std::uint8_t*>(&part));
            same |= part << (i - first);
        }
        for (; i < end; ++i) same |= std::uint64_t{at[i] == other[i]} << (i - first);
        bits[word] = same;
    }
}

/// The identifiers of a row, with more in their high bits where the bits of four lists are set.
void write_row(const std::uint32_t* row, std::size_t count, const std::uint64_t* const lists[4],
               std::uint32_t* to) {
    constexpr std::uint32_t more[4] = {1, 1, 2, 4};
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t i = 0;
    if (64 % lanes == 0)
        for (; i + lanes <= count; i += lanes) {
            auto pixel = hn::And(hn::LoadU(d, row + i), hn::Set(d, id_bits));
            for (int k = 0; k < 4; ++k) {
                const std::uint64_t bits = lists[k][i / 64] >> (i % 64);
                const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
                pixel = hn::Add(pixel, hn::IfThenElseZero(mask, hn::Set(d, more[k] << 24)));
            }
            hn::StoreU(pixel, d, to + i);
        }
    for (; i < count; ++i) {
        to[i] = row[i] & id_bits;
        for (int k = 0; k < 4; ++k)
            to[i] += std::uint32_t(lists[k][i / 64] >> (i % 64) & 1) * (more[k] << 24);
    }
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {
namespace {

HWY_EXPORT(mark_same);
HWY_EXPORT(write_row);

/// Bits of a face's pixels: rows of whole words, 0 beyond the face.
class Bits {
public:
    Bits(std::uint64_t* words, std::size_t width, std::size_t rows)
        : words_(words), rows_(rows), per_row_((width + 63) / 64) {}

    std::uint64_t* row(std::size_t y) { return words_ + y * per_row_; }
    const std::uint64_t* row(std::size_t y) const { return words_ + y * per_row_; }
    std::size_t per_row() const { return per_row_; }
    std::size_t rows() const { return rows_; }
    std::size_t word_count() const { return per_row_ * rows_; }

    /// A word of a row, with the bits `by` columns to the right in place; and to the left.
    std::uint64_t from_right(const std::uint64_t* r, std::size_t i, unsigned by) const {
        return r[i] >> by | (i + 1 < per_row_ ? r[i + 1] << (64 - by) : 0);
    }
    std::uint64_t from_left(const std::uint64_t* r, std::size_t i, unsigned by) const {
        return r[i] << by | (i > 0 ? r[i - 1] >> (64 - by) : 0);
    }

private:
    std::uint64_t* words_;
    std::size_t rows_, per_row_;
};

/// Whether the pixels `by` away in rows and columns have the bit too: of squares of bits, larger
/// ones. by: at most the squares' radius.
void erode(const Bits& from, unsigned by, Bits to, std::uint64_t* across) {
    for (std::size_t y = 0; y < from.rows(); ++y)
        for (std::size_t i = 0; i < from.per_row(); ++i) {
            const std::uint64_t* r = from.row(y);
            across[y * from.per_row() + i] =
                r[i] & from.from_left(r, i, by) & from.from_right(r, i, by);
        }
    for (std::size_t y = 0; y < from.rows(); ++y)
        for (std::size_t i = 0; i < from.per_row(); ++i) {
            const std::size_t at = y * from.per_row() + i, step = by * from.per_row();
            to.row(y)[i] = y < by || y + by >= from.rows()
                               ? 0
                               : across[at] & across[at - step] & across[at + step];
        }
}

/// Squares of three by three pixels of one identifier.
void find_squares(const IdBuffer& buffer, Bits& squares, std::uint64_t* right,
                  std::uint64_t* above) {
    const auto width = std::size_t(buffer.size), rows = std::size_t(buffer.rows);
    const std::size_t words = squares.per_row();
    for (std::size_t y = 0; y < rows; ++y) {
        const std::uint32_t* row = &buffer.pixels[y * width];
        // the last pixel has none to its right
        HWY_DYNAMIC_DISPATCH(mark_same)(row, row + 1, width - 1, right + y * words);
        if (width % 64 == 1) right[y * words + words - 1] = 0;
        if (y + 1 < rows)
            HWY_DYNAMIC_DISPATCH(mark_same)(row, row + width, width, above + y * words);
    }
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t i = 0; i < words; ++i) {
            std::uint64_t& bits = squares.row(y)[i];
            if (y == 0 || y + 1 == rows) {
                bits = 0;
                continue;
            }
            bits = above[(y - 1) * words + i] & above[y * words + i];
            for (std::size_t k = y - 1; k <= y + 1; ++k) {
                const std::uint64_t* r = right + k * words;
                bits &= r[i] & squares.from_left(r, i, 1);
            }
        }
}

}  // namespace

void find_seen(const IdBuffers& buffers, SeenIds& seen) {
    seen.size = buffers[0].size;
    std::size_t count = 0;
    for (const IdBuffer& buffer : buffers) count += buffer.pixels.size();
    seen.pixels.resize(count);
    std::uint32_t* to = seen.pixels.data();
    for (const IdBuffer& buffer : buffers) {
        const auto width = std::size_t(buffer.size), rows = std::size_t(buffer.rows);
        const std::size_t words = (width + 63) / 64 * rows;
        seen.bits_.resize(6 * words);
        std::uint64_t* const at = seen.bits_.data();
        const auto list = [&](std::size_t k) { return Bits(at + k * words, width, rows); };
        Bits one = list(0);
        find_squares(buffer, one, at + 4 * words, at + 5 * words);
        erode(list(0), 1, list(1), at + 4 * words);
        erode(list(1), 2, list(2), at + 4 * words);
        erode(list(2), 4, list(3), at + 4 * words);
        for (std::size_t y = 0; y < rows; ++y, to += width) {
            const std::uint64_t* const lists[4] = {list(0).row(y), list(1).row(y), list(2).row(y),
                                                   list(3).row(y)};
            HWY_DYNAMIC_DISPATCH(write_row)(&buffer.pixels[y * width], width, lists, to);
        }
    }
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
