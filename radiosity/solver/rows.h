// The form factors of patches that have shot, kept for later shots up to a number of bytes.
#pragma once

#include "radiosity/hemicube/form_factors.h"

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

private:
    struct Run {
        std::uint32_t first, end;
    };
    std::vector<Run> runs_;
    std::vector<float> factors_;
    double backs_, escaped_, sum_, scale_ = 1;
};

/// Of a patch's quarters, or one. The mean of their sums is 1.
using PatchRows = std::vector<CompactRow>;
PatchRows compact(const std::vector<Row>& rows);

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

private:
    static std::size_t size_of(const PatchRows& rows) {
        std::size_t bytes = 0;
        for (const CompactRow& row : rows) bytes += row.bytes();
        return bytes;
    }

    std::unordered_map<std::size_t, PatchRows> rows_;
    std::size_t bytes_ = 0;
};

}  // namespace gw::radiosity
