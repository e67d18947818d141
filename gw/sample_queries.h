// Counts of the fragments written between the begin and the end of a query: sums of the passes'
// counters, so early rejection does not change them. docs/manual/counters.md, "Queries".
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gw {

class SampleQueries {
public:
    /// `passes` count all commands before this one.
    void run(const Query& query, std::vector<PassReport>& passes) {
        if (passes.empty()) passes.emplace_back();
        if (query.begin) {
            active_ = query.key;
            first_pass_ = passes.size() - 1;
            before_ = passes.back().counters.written;
            forgotten_ = 0;
            return;
        }
        const std::uint64_t samples = written(passes);
        passes.back().queries.push_back({query.key, samples});
        active_.reset();
    }
    /// Call before the passes are forgotten.
    void forget(const std::vector<PassReport>& passes) {
        if (active_) forgotten_ = written(passes);
        first_pass_ = 0;
        before_ = 0;
    }
    std::optional<std::uint32_t> active() const { return active_; }

private:
    /// Since the begin of the active query.
    std::uint64_t written(std::span<const PassReport> passes) const {
        std::uint64_t sum = forgotten_;
        if (first_pass_ >= passes.size()) return sum;
        for (const PassReport& pass : passes.subspan(first_pass_)) sum += pass.counters.written;
        return sum - before_;
    }

    std::optional<std::uint32_t> active_;
    std::size_t first_pass_ = 0;   ///< in which it began
    std::uint64_t before_ = 0;     ///< fragments that this pass had written before
    std::uint64_t forgotten_ = 0;  ///< since the begin, in passes that were forgotten
};

}  // namespace gw
