// The form factors of patches that have shot, kept for later shots up to a number of bytes, and of
// patches that other processes have drawn.
#pragma once

#include "radiosity/hemicube/form_factors.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace gw::radiosity {

/// A row in less memory: form factors as float32, texels as runs.
class CompactRow {
public:
    explicit CompactRow(const Row& row);

    /// Calls visit(texel, form factor), texels ascending.
    template <class Visit>
    void for_each(const Visit& visit) const {
        const float* factor = factors_.data();
        for (const Run& run : runs_)
            for (std::uint32_t t = run.first; t < run.end; ++t) visit(t, *factor++ * scale_);
    }
    double backs() const { return backs_ * scale_; }
    double escaped() const { return escaped_ * scale_; }
    double sum() const { return sum_ * scale_; }  ///< of all
    std::size_t bytes() const;

    void scale(double by) { scale_ *= by; }

    /// As bytes of this machine's, and back: of a text that begins with them, which loses them. Throws
    /// Error if it is too short.
    void append_to(std::string& bytes) const;
    static CompactRow taken_from(std::string_view& bytes);

private:
    CompactRow() = default;

    struct Run {
        std::uint32_t first, end;
    };
    std::vector<Run> runs_;
    std::vector<float> factors_;
    double backs_ = 0, escaped_ = 0, sum_ = 0, scale_ = 1;
};

/// Of a patch's quarters, or one. The mean of their sums is 1.
using PatchRows = std::vector<CompactRow>;
PatchRows compact(const std::vector<Row>& rows);

/// As drawn, with the number of hemicubes that it took.
struct DrawnRows {
    PatchRows rows;
    int hemicubes = 0;
};
std::string to_bytes(const DrawnRows& drawn);
/// Throws Error if they are no rows.
DrawnRows rows_from(std::string_view bytes);

/// Processes that run the same solver and draw form factors for each other.
class RowExchange {
public:
    virtual ~RowExchange() = default;
    virtual std::size_t rank() const = 0;  ///< of this process, from 0
    virtual std::size_t processes() const = 0;
    /// Every process calls it at the same shot. Returns the texts of all, by rank. Throws Error if one
    /// is lost.
    virtual std::vector<std::string> exchange(const std::string& mine) = 0;
};

class Rows {
public:
    /// Null if the patch's rows are not kept.
    const PatchRows* find(std::size_t patch) const {
        const auto found = rows_.find(patch);
        return found == rows_.end() ? nullptr : &found->second;
    }

    /// Keeps rows, unless all together would have more than `most` bytes. Precondition: none of this
    /// patch are kept.
    void keep(std::size_t patch, const PatchRows& rows, std::size_t most) {
        const std::size_t more = size_of(rows);
        if (bytes_ + more > most) return;
        bytes_ += more;
        rows_.emplace(patch, rows);
    }

    void drop(std::size_t patch) {
        const auto found = rows_.find(patch);
        if (found == rows_.end()) return;
        bytes_ -= size_of(found->second);
        rows_.erase(found);
    }

    std::size_t bytes() const { return bytes_; }

    /// Rows of a patch that has not shot yet. If all of these have more than `most` bytes, they are
    /// dropped first.
    void expect(std::size_t patch, DrawnRows drawn, std::size_t most) {
        const std::size_t more = size_of(drawn.rows);
        if (expected_bytes_ + more > most) {
            expected_.clear();
            expected_bytes_ = 0;
        }
        expected_bytes_ += more;
        expected_.insert_or_assign(patch, std::move(drawn));
    }
    bool expects(std::size_t patch) const { return expected_.contains(patch); }
    /// Precondition: the patch is expected.
    DrawnRows take(std::size_t patch) {
        auto node = expected_.extract(patch);
        expected_bytes_ -= size_of(node.mapped().rows);
        return std::move(node.mapped());
    }

private:
    static std::size_t size_of(const PatchRows& rows) {
        std::size_t bytes = 0;
        for (const CompactRow& row : rows) bytes += row.bytes();
        return bytes;
    }

    std::unordered_map<std::size_t, PatchRows> rows_;
    std::size_t bytes_ = 0;
    std::unordered_map<std::size_t, DrawnRows> expected_;
    std::size_t expected_bytes_ = 0;
};

}  // namespace gw::radiosity
