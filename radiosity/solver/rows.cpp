#include "radiosity/solver/rows.h"

namespace gw::radiosity {

CompactRow::CompactRow(const Row& row)
    : backs_(row.backs), escaped_(row.escaped), sum_(backs_ + escaped_) {
    factors_.reserve(row.factors.size());
    for (std::size_t i = 0; i < row.texels.size(); ++i) {
        const std::uint32_t texel = row.texels[i];
        if (runs_.empty() || runs_.back().end != texel) runs_.push_back({texel, texel});
        runs_.back().end = texel + 1;
        factors_.push_back(static_cast<float>(row.factors[i]));
        sum_ += double(factors_.back());
    }
    runs_.shrink_to_fit();
}

std::size_t CompactRow::bytes() const {
    return sizeof *this + runs_.size() * sizeof(Run) + factors_.size() * sizeof(float);
}

PatchRows compact(const std::vector<Row>& rows) {
    PatchRows all(rows.begin(), rows.end());
    double sum = 0;
    for (const CompactRow& row : all) sum += row.sum();
    for (CompactRow& row : all) row.scale(double(all.size()) / sum);
    return all;
}

}  // namespace gw::radiosity
