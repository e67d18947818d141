// The form factors of patches that have shot, kept for later shots up to a number of bytes.
#pragma once

#include "radiosity/hemicube/form_factors.h"

#include <unordered_map>

namespace gw::radiosity {

class Rows {
public:
    /// Null if the patch's row is not kept.
    const Row* find(std::size_t patch) const {
        const auto found = rows_.find(patch);
        return found == rows_.end() ? nullptr : &found->second;
    }

    /// Keeps a row, unless all together would have more than `most` bytes.
    void keep(std::size_t patch, Row row, std::size_t most) {
        const std::size_t more = size_of(row);
        if (bytes_ + more > most || rows_.contains(patch)) return;
        bytes_ += more;
        rows_.emplace(patch, std::move(row));
    }

    void drop(std::size_t patch) {
        const auto found = rows_.find(patch);
        if (found == rows_.end()) return;
        bytes_ -= size_of(found->second);
        rows_.erase(found);
    }

    std::size_t bytes() const { return bytes_; }

private:
    static std::size_t size_of(const Row& row) {
        return sizeof row + row.texels.size() * (sizeof(double) + sizeof(std::uint32_t));
    }

    std::unordered_map<std::size_t, Row> rows_;
    std::size_t bytes_ = 0;
};

}  // namespace gw::radiosity
