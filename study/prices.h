// Price lists that turn counters into time and money, and the rankings that follow. A list (TOML)
// has the price of each operation on a machine, with its source; the recipes (TOML) say how many
// operations one of each counter stands for. Estimates, and labelled so in the files. Does not
// count.
#pragma once

#include "study/growth.h"
#include "study/plot/plot.h"

#include <filesystem>

namespace gw::study {

struct Price {
    double value = 0;
    bool estimate = false;  ///< not read in a document
    std::string source;
};

struct PriceList {
    std::string name, machine;
    /// Microseconds for "add", "compare", "multiply", "divide", "load", "store"; dollars a month
    /// for the "machine" and for a megabyte of "memory".
    std::map<std::string, Price> prices;
};
/// Throws Error "file:line: what; expected what"; every price must be there once.
PriceList read_prices(const std::filesystem::path& file);

/// Operations for one of each counter; of hidden lines with "lines." before.
using Recipes = std::map<std::string, std::map<std::string, double>>;
/// Throws Error as read_prices; counters must exist.
Recipes read_recipes(const std::filesystem::path& file);

/// What a picture costs: the time of its operations, and the rent of machine and memory
/// (peak_bytes) for that time.
struct Cost {
    double seconds = 0, dollars = 0;
};
Cost cost_of(const GrowthPoint& point, const PriceList& list, const Recipes& recipes);

/// At one place of an axis, cheapest first; only algorithms that claim to be right.
struct Ranking {
    double x = 0;
    std::vector<std::pair<std::string, Cost>> algorithms;
};
std::vector<Ranking> rankings(const Growth& growth, const std::string& axis, bool lines,
                              const PriceList& list, const Recipes& recipes);

/// Two algorithms that change places between two neighbouring x: up to there `before` is the
/// cheaper, from there on `after`. `x`: where the two costs, taken as power laws between the two,
/// are equal.
struct Flip {
    std::string before, after;
    double x = 0;
};
/// Among the first `places` of either ranking, in the order of x.
std::vector<Flip> flips(const std::vector<Ranking>& rankings, std::size_t places = 3);

/// Dollars of every algorithm against the axis.
plot::Plot cost_plot(const std::vector<Ranking>& rankings, const GrowthAxis& axis,
                     const PriceList& list, bool lines);

}  // namespace gw::study
