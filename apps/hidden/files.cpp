#include "apps/hidden/files.h"

#include "apps/command/table.h"
#include "apps/hidden/comparison.h"
#include "apps/hidden/page.h"
#include "apps/hidden/pictures.h"
#include "hiddensurface/run/svg.h"
#include "image/write.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace gw::apps {

namespace hs = hiddensurface;
using Colors = std::map<std::uint32_t, Color>;

namespace {

void put_pieces(image::OutputSet& output, const std::filesystem::path& folder,
                const hs::Input& input, const std::vector<hs::Piece>& pieces,
                const Colors& colors) {
    std::vector<std::string> hex;
    for (const hs::Polygon& polygon : input.polygons) hex.push_back(hex_of(colors.at(polygon.id)));
    output.add(folder / "pieces.svg").write_text(hs::pieces_svg(input, pieces, hex));
}

/// Picture, difference, writes.
std::vector<image::Picture> pictures_of(const hs::Input& input, const hs::Result& result,
                                        const Colors& colors) {
    const image::Picture picture = picture_of_ids(input, result.ids, colors);
    return {picture, picture_of_difference(picture, result.difference),
            picture_of_counts(result.writes, input.view.width, input.view.height)};
}

/// Only for an algorithm that finds parts of pixels.
void put_shares(image::OutputSet& output, const std::filesystem::path& file, const hs::Input& input,
                const hs::Result& result, const Colors& colors) {
    if (!result.shares.empty())
        image::put_picture(output.add(file), picture_of_shares(input, result.shares, colors));
}

bool has_difference(const hs::Result& result) {
    return std::ranges::any_of(result.difference,
                               [](hs::Difference d) { return d != hs::Difference::None; });
}

/// Its picture for the sheet; after it the difference from the Z-buffer's, if there is any.
std::vector<image::Picture> panels_of(const std::vector<image::Picture>& pictures,
                                      const Compared& run) {
    const auto captions = captions_of(run.algorithm->name, run.result.counts);
    std::vector<image::Picture> panels{captioned(enlarged(pictures[0]), captions[0])};
    if (has_difference(run.result)) panels.push_back(captioned(enlarged(pictures[1]), captions[1]));
    return panels;
}

/// Rows so that the sheet is about as high as it is wide; what belongs to an algorithm stays in one.
std::vector<std::vector<image::Picture>> in_rows(std::vector<std::vector<image::Picture>> all) {
    const image::Picture& one = all.front().front();
    std::size_t count = 0, abreast = 2;
    for (const auto& panels : all) count += panels.size();
    while (abreast * std::size_t(one.width) <
           (count + abreast - 1) / abreast * std::size_t(one.height))
        ++abreast;
    std::vector<std::vector<image::Picture>> rows(1);
    for (auto& panels : all) {
        if (rows.back().size() + panels.size() > abreast) rows.emplace_back();
        std::ranges::move(panels, std::back_inserter(rows.back()));
    }
    return rows;
}

constexpr const char* kinds[] = {"", "_difference", "_writes"};

}  // namespace

std::string counts_text(const std::vector<Compared>& all) {
    std::vector<std::vector<std::string>> rows{{""}};
    if (all.size() == 1) {
        rows[0].push_back(all[0].algorithm->name);
        for (const auto& [name, count] : hs::count_names())
            rows.push_back({name, std::to_string(all[0].result.counts.*count)});
        return table(rows);
    }
    for (const auto& [name, count] : hs::count_names()) rows[0].push_back(name);
    for (const Compared& run : all) {
        rows.push_back({run.algorithm->name});
        for (const auto& [name, count] : hs::count_names())
            rows.back().push_back(std::to_string(run.result.counts.*count));
    }
    constexpr std::size_t terminal = 120;
    return table_in_parts(rows, terminal);
}

std::string counts_csv(const std::vector<Compared>& all) {
    std::string text = "algorithm";
    for (const auto& [name, count] : hs::count_names()) text += std::string(",") + name;
    text += "\n";
    for (const Compared& run : all) {
        text += run.algorithm->name;
        for (const auto& [name, count] : hs::count_names())
            text += fmt::format(",{}", run.result.counts.*count);
        text += "\n";
    }
    return text;
}

std::string counts_json(const std::vector<Compared>& all) {
    auto list = nlohmann::ordered_json::array();
    for (const Compared& run : all) {
        auto counts = nlohmann::ordered_json::object();
        for (const auto& [name, count] : hs::count_names()) counts[name] = run.result.counts.*count;
        list.push_back({{"algorithm", run.algorithm->name},
                        {"title", run.algorithm->title},
                        {"counts", counts}});
    }
    return list.dump(2) + "\n";
}

void put_player(image::OutputSet& output, const std::filesystem::path& folder,
                const std::vector<std::string>& logs) {
    if (const std::string page = page_with("player.html", logs); !page.empty())
        output.add(folder / "player.html").write_text(page);
}

std::string put_steps(image::OutputSet& output, const std::filesystem::path& folder,
                      const hs::Input& input, const Compared& run) {
    const Colors colors = flat_colors(input);
    const std::vector<hs::Step>& steps = run.log.steps();
    const hs::LogSubject subject{.algorithm = run.algorithm->name,
                                 .title = run.algorithm->title,
                                 .in_world = run.algorithm->in_world,
                                 .level = run.log.finest()};
    std::string log = hs::log_text(input, subject, steps,
                                   hs::log_end(steps.size(), run.result.counts, hs::grid_of(input),
                                               hs::blame_of(steps, run.result, input.view.width)));
    output.add(folder / "steps.jsonl").write_text(log);
    if (run.result.counts.splits > 0) put_pieces(output, folder, input, run.result.pieces, colors);
    const auto last = pictures_of(input, run.result, colors);
    image::put_picture(output.add(folder / "picture.png"), last[0]);
    image::put_picture(output.add(folder / "difference.png"), last[1]);
    image::put_picture(output.add(folder / "writes.png"), last[2]);
    put_shares(output, folder / "smooth.png", input, run.result, colors);
    return log;
}

void put_comparison(image::OutputSet& output, const std::filesystem::path& folder,
                    const hs::Input& input, const std::vector<Compared>& all) {
    const Colors colors = flat_colors(input);
    std::vector<std::vector<image::Picture>> rows;
    for (const Compared& run : all) {
        const auto pictures = pictures_of(input, run.result, colors);
        for (std::size_t k = 0; k < pictures.size(); ++k)
            image::put_picture(output.add(folder / (run.algorithm->name + kinds[k] + ".png")),
                               pictures[k]);
        put_shares(output, folder / (run.algorithm->name + "_smooth.png"), input, run.result,
                   colors);
        rows.push_back(panels_of(pictures, run));
    }
    image::put_picture(output.add(folder / "sheet.png"), sheet_of(in_rows(std::move(rows))));
    image::put_picture(
        output.add(folder / "complexity.png"),
        picture_of_counts(hs::depth_complexity(input), input.view.width, input.view.height));
    output.add(folder / "counts.csv").write_text(counts_csv(all));
    output.add(folder / "counts.json").write_text(counts_json(all));
    const std::string page = page_with("compare.html", {comparison_json(input, all, colors)});
    if (!page.empty()) output.add(folder / "index.html").write_text(page);
}

}  // namespace gw::apps
