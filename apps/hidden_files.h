// What gw hidden writes: the folder of steps, the folder of a comparison, tables. All files appear or none.
#pragma once

#include "hiddensurface/compare.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// One algorithm's result, compared with the Z-buffer.
struct Compared {
    const hiddensurface::Algorithm* algorithm = nullptr;
    hiddensurface::Result result;
};

/// A line for each counter, a column for each algorithm.
std::string counts_text(const std::vector<Compared>& all);
std::string counts_csv(const std::vector<Compared>& all);
std::string counts_json(const std::vector<Compared>& all);

/// steps.jsonl, step_0001.png ... (at most `pictures`, evenly over the log), steps.gif, pieces.svg where
/// something was split, writes.png, picture.png, difference.png.
void write_steps(const std::filesystem::path& folder, const hiddensurface::Input& input, const Compared& run,
                 const std::vector<hiddensurface::Step>& steps, int pictures);

/// sheet.png (a row for each algorithm: picture, difference, writes), the same pictures one by one,
/// complexity.png, counts.csv, counts.json, index.html.
void write_comparison(const std::filesystem::path& folder, const hiddensurface::Input& input,
                      const std::vector<Compared>& all);

}  // namespace gw::apps
