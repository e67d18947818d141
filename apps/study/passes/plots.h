// The study of passes against rays as plots, crossings and tables of text. Does not measure.
#pragma once

#include "apps/study/passes/results.h"
#include "image/plot/plot.h"

namespace gw::study {

struct StudyPlot {
    std::string name;  ///< of the file, without its extension
    plot::Plot plot;
};
/// The plots of a sweep with two rows or more: counts, estimated seconds, gain, measured processor
/// seconds, and the error of samples against the estimated time.
std::vector<StudyPlot> plots(const PassStudy& study, const std::string& sweep);

/// Where ordinary ray tracing and the item buffer take the same time, here and at each list's prices:
/// a sentence each, between rows by straight lines.
std::vector<std::string> crossings(const PassStudy& study, const std::string& sweep);

/// A row for each value: passes, fragments, rays, times, gains.
std::vector<std::vector<std::string>> table_of(const PassStudy& study, const std::string& sweep);

/// The page with plots, tables, prices and how it was measured.
std::string page(const PassStudy& study);

}  // namespace gw::study
