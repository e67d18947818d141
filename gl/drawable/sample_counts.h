// The occlusion queries of a drawable. Its machine has one query at a time, and contexts have theirs
// at once. So the commands are cut into segments, each a query of the machine, and a count is the sum
// of its segments. [GL15] 4.1.7
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gw::gl {

/// What a query object has counted.
struct SampleCount {
    std::uint64_t samples = 0;
    int open = 0;  ///< segments that were not executed yet
};
using SampleCountRef = std::shared_ptr<SampleCount>;

class SampleCounts {
public:
    /// The commands that follow a cut are counted, or not any more.
    void begin(SampleCountRef count);
    void end(const SampleCountRef& count);

    /// The command that begins a segment, if commands are counted and none has begun.
    std::optional<Query> begin_segment();
    /// The command that ends the segment.
    std::optional<Query> end_segment();

    /// Whether segments wait for their execution.
    bool are_open() const { return !segments_.empty(); }
    /// Adds what executed segments counted.
    void add(std::span<const QueryResult> results);
    /// Segments that were not executed never will be.
    void forget_segments();

private:
    std::vector<SampleCountRef> counting_;
    bool has_begun_ = false;
    std::uint32_t key_ = 0;  ///< of the last segment
    std::map<std::uint32_t, std::vector<SampleCountRef>> segments_;
};

/// The results of all passes.
std::vector<QueryResult> query_results(std::span<const PassReport> passes);

}  // namespace gw::gl
