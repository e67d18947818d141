// Price lists that turn counters into time and money, and rankings by them. A list (TOML) has the
// price of each operation on a machine, with its source. Recipes (TOML) give the operations for one
// of each counter. The results are estimates, and the files say so. Does not count.
#pragma once

#include "apps/study/growth.h"
#include "image/plot/plot.h"

#include <filesystem>

namespace gw::study {

struct Price {
    double value = 0;
    bool estimate = false;  ///< not from a document
    std::string source;
};

struct PriceList {
    std::string name, machine;
    /// Microseconds for "add", "compare", "multiply", "divide", "load", "store"; dollars a month
    /// for the "machine" and for a megabyte of "memory".
    std::map<std::string, Price> prices;
};
/// Throws Error "file:line: what; expected what". Every price must occur once.
PriceList read_prices(const std::filesystem::path& file);

/// The operations for one of each counter; counters of hidden lines begin with "lines.".
using Recipes = std::map<std::string, std::map<std::string, double>>;
/// Throws Error as read_prices; counters must exist.
Recipes read_recipes(const std::filesystem::path& file);

/// The cost of a picture: the time of its operations, and the rent of machine and memory (peak_bytes)
/// for that time.
struct Cost {
    double seconds = 0, dollars = 0;
};
Cost cost_of(const GrowthPoint& point, const PriceList& list, const Recipes& recipes);

/// The algorithms that claim to be right at one place of an axis, the cheapest first.
struct Ranking {
    double x = 0;
    std::vector<std::pair<std::string, Cost>> algorithms;
};
std::vector<Ranking> rankings(const Growth& growth, const std::string& axis, bool lines,
                              const PriceList& list, const Recipes& recipes);

/// Two algorithms that change places between two neighbouring x: below `x`, `before` is cheaper,
/// above it `after`. At `x` the two costs, as power laws between the neighbours, are equal.
struct Flip {
    std::string before, after;
    double x = 0;
};
/// The exchanges among the first `places` of either ranking, in the order of x.
std::vector<Flip> flips(const std::vector<Ranking>& rankings, std::size_t places = 3);

/// The dollars of every algorithm against the axis.
plot::Plot cost_plot(const std::vector<Ranking>& rankings, const GrowthAxis& axis,
                     const PriceList& list, bool lines);

}  // namespace gw::study
