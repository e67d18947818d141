// A price list: the estimated time of a picture on a machine, as one of 1991, from its counts.
// Passes are drawn by stages that work at the same time; rays are traced by a processor. Estimates
// are labelled so; every price has its source and its limits. Does not count.
#pragma once

#include "gw/names.h"
#include "raytrace/tracer/tracer.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gw::report {

/// A count that has a price: a counter of the machine, or the work of rays.
struct PricedCount {
    std::string name;
    std::uint64_t Counters::*counter = nullptr;  ///< null: of rays
    std::uint64_t (*of_rays)(const raytrace::RayCounts&) = nullptr;
};
/// The counters of gw/names.h; then "rays" of all kinds, "boxes", "triangles" and "shaded".
const std::vector<PricedCount>& priced_counts();

struct Price {
    PricedCount count;
    std::string stage;         ///< "geometry" or "pixels", which work at the same time; "processor"
    double nanoseconds = 0;    ///< for one
    double low = 0, high = 0;  ///< its limits, nanoseconds; equal for a price that is known
    bool estimate = false;     ///< not read in a document
    std::string source;
};

/// A measured time of rays whose counts are known: the processor's prices are scaled to give it.
struct Calibration {
    double seconds = 0, low = 0, high = 0;  ///< and its limits
    raytrace::RayCounts rays;               ///< all of them as `primary`
    std::string source;
};

struct PriceList {
    std::string name;  ///< a short one: of the file
    std::string machine;
    std::vector<Price> prices;
    std::optional<Calibration> calibration;
};

/// Throws Error "file:line: REASON; expected ...".
PriceList read_prices(const std::filesystem::path& file);

/// inspect/report/prices/vgx.toml, built in.
PriceList vgx_prices();
/// All lists of inspect/report/prices, built in: the VGX's first.
const std::vector<PriceList>& built_in_prices();

/// Estimated, of one pass: the time of its slowest stage.
double estimated_seconds(const Counters& counters, const PriceList& list);
/// Of rays: on the processor, calibrated.
double traced_seconds(const raytrace::RayCounts& rays, const PriceList& list);
/// Of a picture. Passes do not overlap, and rays begin when the item buffer is read back: their times
/// add up.
double picture_seconds(std::span<const Counters> passes, const raytrace::RayCounts& rays,
                       const PriceList& list);

/// An estimate, and the least and the most that the prices' limits allow.
struct Interval {
    double value = 0, low = 0, high = 0;
};
/// What a picture takes.
struct PictureWork {
    std::span<const Counters> passes;
    raytrace::RayCounts rays;
};
Interval seconds_interval(const PictureWork& work, const PriceList& list);
/// Of the seconds of `work` over those of `other`, both at the same prices; 0 if `other` takes none.
Interval ratio_interval(const PictureWork& work, const PictureWork& other, const PriceList& list);

/// Every choice of limits: each price, and the calibration's time, at its low or its high. The
/// least and the most of an estimate among these lists are its interval. At most 2^16 lists; throws
/// Error for more than 16 prices with limits.
std::vector<PriceList> extremes(const PriceList& list);

}  // namespace gw::report
