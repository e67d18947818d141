// The rows of a study of passes against rays [K4f] with their estimated times, as CSV and JSON. Does
// not measure.
#pragma once

#include "inspect/report/prices.h"
#include "render/study/sweeps.h"

#include <string>
#include <vector>

namespace gw::study {

using report::Interval;

/// A row at the prices of one list.
struct RowEstimate {
    std::vector<Interval> seconds;  ///< by method
    Interval gain;                  ///< ordinary ray tracing over the item buffer; 0: neither costs
};
RowEstimate estimate(const render::StudyRow& row, const report::PriceList& list);

/// A sweep that was not run to its end, or not at all.
struct Omission {
    std::string sweep, why;
};

struct PassStudy {
    std::string scene, profile;  ///< names
    std::string scene_hash;      ///< as manifests have it; "": unknown
    std::string command;
    int runs = 0, color_bits = 8;
    std::vector<report::PriceList> lists;
    std::vector<render::StudyRow> rows;  ///< the scene's own first, then sweep by sweep
    std::vector<std::vector<RowEstimate>> estimates;  ///< by row, by list
    std::vector<Omission> omissions;

    void add(render::StudyRow row);
    /// The places of a sweep's rows.
    std::vector<std::size_t> rows_of(const std::string& sweep) const;
    /// The sweeps that have rows, in their order.
    std::vector<std::string> sweep_names() const;
    double measured_gain(std::size_t row) const;  ///< 0: nothing was timed
};

/// A whole number that is the same on every computer.
struct CountColumn {
    std::string name;
    std::uint64_t (*of)(const render::StudyRow&, const render::Cost&);
};
const std::vector<CountColumn>& count_columns();

/// The root mean square of a picture's difference, over pixels and channels, in units of 255.
double rms(const std::vector<Rgba>& a, const std::vector<Rgba>& b, int color_bits);

/// The error of the pictures of the sweep of samples against ordinary ray tracing with the most.
struct ErrorRow {
    std::size_t row = 0;
    std::size_t method = 0;
    double error = 0;
};
std::vector<ErrorRow> errors(const PassStudy& study);

/// The processor, compiler and program that measured, a line each.
std::vector<std::pair<std::string, std::string>> surroundings();

/// A row for every method of every row of the study.
std::string counts_csv(const PassStudy& study);
std::string times_csv(const PassStudy& study);
std::string estimates_csv(const PassStudy& study);
std::string errors_csv(const PassStudy& study);
std::string results_json(const PassStudy& study);

}  // namespace gw::study
