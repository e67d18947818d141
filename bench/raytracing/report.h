// Measurements as plots, CSV and lines of a table. Does not measure.
#pragma once

#include "bench/raytracing/sweep.h"

#include <string>
#include <vector>

namespace gw::bench {

/// SVG: seconds of a frame; times faster, with the paper's 3 and 5 and the bound 1 + 1/g.
std::string times_plot(const Sweep& sweep, const std::vector<Row>& rows);
std::string gain_plot(const Sweep& sweep, const std::vector<Row>& rows);
/// With a line of names.
std::string csv(const std::vector<Row>& rows);

std::string heading(const Sweep& sweep);
std::string line(const Row& row);
/// The amount at which the item buffer's curve and the ordinary ray tracer's cross, by straight
/// lines between rows.
std::string crossings(const Sweep& sweep, const std::vector<Row>& rows);

/// Rays by kind and hierarchies built, ours and Embree's.
std::string race_heading();
std::string race_lines(const std::string& scene, std::size_t triangles, const RayRaces& races);
std::string race_csv(const std::string& scene, std::size_t triangles, const RayRaces& races);

}  // namespace gw::bench
