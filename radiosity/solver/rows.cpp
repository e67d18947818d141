#include "radiosity/solver/rows.h"

#include "gw/error.h"

#include <cstring>
#include <type_traits>

namespace gw::radiosity {
namespace {

template <class Value>
void append(std::string& bytes, const Value* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (count > 0) bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

template <class Value>
void take(std::string_view& bytes, Value* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (bytes.size() / sizeof(Value) < count)
        throw Error("rows of another process are too short; expected as many as it drew");
    if (count > 0) std::memcpy(values, bytes.data(), count * sizeof(Value));
    bytes.remove_prefix(count * sizeof(Value));
}

template <class Value>
void append(std::string& bytes, const std::vector<Value>& values) {
    const std::uint64_t count = values.size();
    append(bytes, &count, 1);
    append(bytes, values.data(), values.size());
}

template <class Value>
void take(std::string_view& bytes, std::vector<Value>& values) {
    std::uint64_t count = 0;
    take(bytes, &count, 1);
    if (count > bytes.size()) count = bytes.size();  // too short, then
    values.resize(count);
    take(bytes, values.data(), count);
}

}  // namespace

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

void CompactRow::append_to(std::string& bytes) const {
    append(bytes, runs_);
    append(bytes, factors_);
    for (const double v : {backs_, escaped_, sum_, scale_}) append(bytes, &v, 1);
}

CompactRow CompactRow::taken_from(std::string_view& bytes) {
    CompactRow row;
    take(bytes, row.runs_);
    take(bytes, row.factors_);
    for (double* const v : {&row.backs_, &row.escaped_, &row.sum_, &row.scale_}) take(bytes, v, 1);
    return row;
}

std::string to_bytes(const DrawnRows& drawn) {
    std::string bytes;
    const std::uint64_t numbers[] = {drawn.rows.size(), std::uint64_t(drawn.hemicubes)};
    append(bytes, numbers, 2);
    for (const CompactRow& row : drawn.rows) row.append_to(bytes);
    return bytes;
}

DrawnRows rows_from(std::string_view bytes) {
    std::uint64_t numbers[2];
    take(bytes, numbers, 2);
    DrawnRows drawn{{}, int(numbers[1])};
    for (std::uint64_t i = 0; i < numbers[0]; ++i)
        drawn.rows.push_back(CompactRow::taken_from(bytes));
    if (!bytes.empty()) throw Error("rows of another process are too long; expected as it drew");
    return drawn;
}

PatchRows compact(const std::vector<Row>& rows) {
    PatchRows all(rows.begin(), rows.end());
    double sum = 0;
    for (const CompactRow& row : all) sum += row.sum();
    for (CompactRow& row : all) row.scale(double(all.size()) / sum);
    return all;
}

}  // namespace gw::radiosity
