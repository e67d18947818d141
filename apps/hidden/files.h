// The files of gw hidden: the folder of steps, the folder of a comparison, tables. The caller
// creates the folders before the work, so that a bad name is found early, and commits.
#pragma once

#include "hiddensurface/run/compare.h"
#include "hiddensurface/run/step_json.h"
#include "image/output/output_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// One algorithm's result, compared with the Z-buffer.
struct Compared {
    const hiddensurface::Algorithm* algorithm = nullptr;
    hiddensurface::Result result;
    hiddensurface::StepLog log{};
};

/// For one algorithm a line for each counter. For several a line for each algorithm, with as many
/// counters side by side as fit a terminal and the others below.
std::string counts_text(const std::vector<Compared>& all);
std::string counts_csv(const std::vector<Compared>& all);
std::string counts_json(const std::vector<Compared>& all);

/// Writes player.html with these logs, if the build has the page.
void put_player(image::OutputSet& output, const std::filesystem::path& folder,
                const std::vector<std::string>& logs);

/// Writes steps.jsonl, writes.png, picture.png, difference.png, and pieces.svg if a polygon was
/// split. Returns the log for the player.
std::string put_steps(image::OutputSet& output, const std::filesystem::path& folder,
                      const hiddensurface::Input& input, const Compared& run);

/// Writes sheet.png, the same pictures one by one, complexity.png, counts.csv, counts.json and, if
/// the build has the page, index.html. The sheet has each algorithm's picture, and the difference if
/// there is any, with captions.
void put_comparison(image::OutputSet& output, const std::filesystem::path& folder,
                    const hiddensurface::Input& input, const std::vector<Compared>& all);

}  // namespace gw::apps
