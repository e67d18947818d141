#include "gl/drawable/sample_counts.h"

#include <utility>

namespace gw::gl {

void SampleCounts::begin(SampleCountRef count) { counting_.push_back(std::move(count)); }
void SampleCounts::end(const SampleCountRef& count) { std::erase(counting_, count); }

std::optional<Query> SampleCounts::begin_segment() {
    if (counting_.empty() || std::exchange(has_begun_, true)) return std::nullopt;
    for (const SampleCountRef& count : counting_) ++count->open;
    segments_[++key_] = counting_;
    return Query{.key = key_, .begin = true};
}

std::optional<Query> SampleCounts::end_segment() {
    if (!std::exchange(has_begun_, false)) return std::nullopt;
    return Query{.key = key_, .begin = false};
}

void SampleCounts::add(std::span<const QueryResult> results) {
    for (const QueryResult& result : results) {
        const auto segment = segments_.extract(result.key);
        if (segment.empty()) continue;
        for (const SampleCountRef& count : segment.mapped()) {
            count->samples += result.samples;
            --count->open;
        }
    }
}

void SampleCounts::forget_segments() {
    for (const auto& [key, counts] : segments_)
        for (const SampleCountRef& count : counts) --count->open;
    segments_.clear();
    has_begun_ = false;
}

std::vector<QueryResult> query_results(std::span<const PassReport> passes) {
    std::vector<QueryResult> out;
    for (const PassReport& pass : passes)
        out.insert(out.end(), pass.queries.begin(), pass.queries.end());
    return out;
}

}  // namespace gw::gl
