// What gw hidden writes: the folder of steps, the folder of a comparison, tables. The caller makes
// the folders (before the work: they may be impossible) and commits.
#pragma once

#include "hiddensurface/run/compare.h"
#include "image/output/output_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// One algorithm's result, compared with the Z-buffer.
struct Compared {
    const hiddensurface::Algorithm* algorithm = nullptr;
    hiddensurface::Result result;
};

/// Of one algorithm a line for each counter; of several a line for each algorithm, the counters
/// side by side as far as they fit a terminal, then the next ones below.
std::string counts_text(const std::vector<Compared>& all);
std::string counts_csv(const std::vector<Compared>& all);
std::string counts_json(const std::vector<Compared>& all);

/// The places of a log that get a picture: evenly spread over 0 .. steps, at most `pictures`, the
/// last always.
std::vector<std::size_t> places(std::size_t steps, int pictures);

/// steps.jsonl, step_0001.png ... (at most `pictures`, evenly over the log), steps.gif, pieces.svg
/// where something was split, writes.png, picture.png, difference.png.
void put_steps(image::OutputSet& output, const std::filesystem::path& folder,
               const hiddensurface::Input& input, const Compared& run,
               const std::vector<hiddensurface::Step>& steps, int pictures);

/// sheet.png (for each algorithm picture, difference and writes side by side, each with a caption;
/// several algorithms in a row where there are many), the same pictures one by one, complexity.png,
/// counts.csv, counts.json, index.html.
void put_comparison(image::OutputSet& output, const std::filesystem::path& folder,
                    const hiddensurface::Input& input, const std::vector<Compared>& all);

}  // namespace gw::apps
