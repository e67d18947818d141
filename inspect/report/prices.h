// A price list: the estimated time of a pass on a machine of 1991, from its counters. Estimates are
// labelled so; every price has its source. Does not count.
#pragma once

#include "gw/names.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::report {

struct Price {
    CounterName counter{};
    std::string stage;       ///< "geometry" or "pixels": stages work at the same time
    double nanoseconds = 0;  ///< for one
    bool estimate = false;   ///< not read in a document
    std::string source;
};

struct PriceList {
    std::string machine;
    std::vector<Price> prices;
};

/// Throws Error "file:line: REASON; expected ...".
PriceList read_prices(const std::filesystem::path& file);

/// inspect/report/prices/vgx.toml, built in.
PriceList vgx_prices();

/// Estimated, of one pass: the time of its slowest stage. Passes do not overlap: their times add
/// up.
double estimated_seconds(const Counters& counters, const PriceList& list);

}  // namespace gw::report
