#include "inspect/report/tile_history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gw::report {
namespace {

/// The planes whose values changed, as a JavaScript object; "0" if none did.
std::string change_text(const PixelValues& before, const PixelValues& after) {
    if (before == after) return "0";
    std::string text;
    if (before.color != after.color) text += fmt::format("c:[{}],", fmt::join(after.color, ","));
    if (before.depth != after.depth) text += fmt::format("z:{},", after.depth);
    if (before.stencil != after.stencil) text += fmt::format("s:{},", after.stencil);
    if (before.accum != after.accum) text += fmt::format("a:[{}],", fmt::join(after.accum, ","));
    if (before.back != after.back) text += fmt::format("b:[{}],", fmt::join(after.back, ","));
    text.pop_back();
    return "{" + text + "}";
}

/// -1 if there is none.
std::string number_text(const auto& optional) {
    return optional ? std::to_string(*optional) : "-1";
}

}  // namespace

TileHistory::TileHistory(ReportFolder& folder, const Planes& start)
    : folder_(folder),
      width_(start.width),
      height_(start.height),
      across_((start.width + side - 1) / side) {
    for (int y = 0; y < height_; y += side)
        for (int x = 0; x < width_; x += side) {
            Tile tile{.name = fmt::format("{}_{}", x / side, y / side),
                      .width = std::min(side, width_ - x)};
            put(tile, fmt::format("gw_history(\"{}\",{{width:{},start:[{}],rows:[\n", tile.name,
                                  tile.width, start_of(start, x, y)));
            tiles_.push_back(std::move(tile));
        }
}

/// Runs of equal values: [count, change from 0].
std::string TileHistory::start_of(const Planes& planes, int x0, int y0) const {
    std::string text;
    PixelValues last;
    int count = 0;
    const auto close = [&] {
        if (count > 0) text += fmt::format("[{},{}],", count, change_text({}, last));
        count = 0;
    };
    for (int y = y0; y < std::min(y0 + side, height_); ++y)
        for (int x = x0; x < std::min(x0 + side, width_); ++x) {
            const PixelValues values = values_at(planes, planes.index(x, y));
            if (values != last) close();
            last = values;
            ++count;
        }
    close();
    return text;
}

TileHistory::Tile& TileHistory::tile_of(int x, int y) {
    return tiles_[std::size_t(y / side) * std::size_t(across_) + std::size_t(x / side)];
}

void TileHistory::put(Tile& tile, const std::string& row) {
    waiting_ += row.size();
    if (waiting_ <= folder_.bytes_left()) tile.text += row;
}

void TileHistory::close_run(Tile& tile) {
    const Run& run = tile.run;
    if (run.count > 0)
        put(tile, fmt::format("[{},{},{},{}],\n", run.pixel, run.count, run.command, run.change));
    tile.run.count = 0;
}

void TileHistory::add(const TileEvent& event) {
    Tile& tile = tile_of(event.x, event.y);
    const int pixel = event.y % side * tile.width + event.x % side;
    std::string change = change_text(event.before, event.after);
    Run& run = tile.run;
    if (!event.fragment) {
        const bool goes_on = run.count > 0 && run.command == event.command &&
                             run.pixel + run.count == pixel && run.change == change;
        if (!goes_on) {
            close_run(tile);
            run = {pixel, 0, event.command, std::move(change)};
        }
        ++run.count;
        return;
    }
    close_run(tile);
    const Fragment& f = *event.fragment;
    put(tile, fmt::format("[{},1,{},{},{},{},{},{},{},{},{}],\n", pixel, event.command, change,
                          number_text(event.draw), f.primitive, number_text(event.polygon),
                          static_cast<int>(event.fate), f.front ? 1 : 0, fmt::join(f.color, ","),
                          f.depth));
}

void TileHistory::flush() {
    folder_.expect_space(waiting_);
    for (Tile& tile : tiles_) {
        close_run(tile);
        if (!tile.text.empty()) folder_.append("history/" + tile.name + ".js", tile.text);
        tile.text.clear();
    }
    waiting_ = 0;
}

void TileHistory::finish() {
    flush();
    for (const Tile& tile : tiles_) folder_.append("history/" + tile.name + ".js", "]});\n");
}

}  // namespace gw::report
