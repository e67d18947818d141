// The histories of all pixels, passes one after the other, as scripts of 64 x 64 pixels. A page
// loads one when a pixel is asked for (web/model/pixel_history.ts). Tiles and pixels are
// counted from the lower left corner. Does not observe a machine: PassObserver does.
#pragma once

#include "gw/planes.h"
#include "gw/reference/observer.h"
#include "inspect/report/report_folder.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::report {

/// An event: a fragment, or a command that touched the pixel without one.
struct TileEvent {
    int x = 0, y = 0;  ///< window coordinates
    std::size_t command = 0;
    PixelValues before, after;
    const Fragment* fragment = nullptr;
    Fate fate = Fate::Written;
    std::optional<std::size_t> draw;
    std::optional<std::uint32_t> polygon;
};

class TileHistory {
public:
    static constexpr int side = 64;

    /// `start`: the planes before the first event. The folder must outlive it.
    TileHistory(ReportFolder& folder, const Planes& start);

    /// Kept in memory until `flush`; after as many bytes as the folder may still hold nothing more
    /// is kept, and flush throws.
    void add(const TileEvent& event);
    /// Throws Error if the folder is full.
    void flush();
    void finish();

private:
    /// Neighbours to which one command did the same are one row: clears are short.
    struct Run {
        int pixel = 0, count = 0;
        std::size_t command = 0;
        std::string change;
    };
    struct Tile {
        std::string name, text;
        int width = 0;
        Run run;
    };

    Tile& tile_of(int x, int y);
    void close_run(Tile& tile);
    void put(Tile& tile, const std::string& row);
    std::string start_of(const Planes& planes, int x0, int y0) const;

    ReportFolder& folder_;
    int width_, height_, across_;
    std::vector<Tile> tiles_;
    std::uint64_t waiting_ = 0;  ///< bytes in memory
};

}  // namespace gw::report
