// The form factors of patches that have shot, kept for later shots up to a number of bytes.
#pragma once

#include "radiosity/hemicube/form_factors.h"

#include <unordered_map>

namespace gw::radiosity {

class Rows {
public:
    /// A patch's row, or those of its quarters. Null if they are not kept.
    const std::vector<Row>* find(std::size_t patch) const {
        const auto found = rows_.find(patch);
        return found == rows_.end() ? nullptr : &found->second;
    }

    /// Keeps rows in place of those of the patch before, unless all together would have more than
    /// `most` bytes.
    void keep(std::size_t patch, std::vector<Row> rows, std::size_t most) {
        const std::size_t more = size_of(rows);
        drop(patch);
        if (bytes_ + more > most) return;
        bytes_ += more;
        rows_.emplace(patch, std::move(rows));
    }

    void drop(std::size_t patch) {
        const auto found = rows_.find(patch);
        if (found == rows_.end()) return;
        bytes_ -= size_of(found->second);
        rows_.erase(found);
    }

    std::size_t bytes() const { return bytes_; }

private:
    static std::size_t size_of(const std::vector<Row>& rows) {
        std::size_t bytes = 0;
        for (const Row& row : rows)
            bytes += sizeof row + row.texels.size() * (sizeof(double) + sizeof(std::uint32_t));
        return bytes;
    }

    std::unordered_map<std::size_t, std::vector<Row>> rows_;
    std::size_t bytes_ = 0;
};

}  // namespace gw::radiosity
