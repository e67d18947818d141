// Hears what the reference machine does with every fragment and passes it on: to the plane of
// polygons, and to the histories while they are kept.
#pragma once

#include "inspect/replay/following_observer.h"
#include "inspect/report/polygon_plane.h"
#include "inspect/report/tile_history.h"

namespace gw::report {

class PassObserver : public inspect::FollowingObserver {
public:
    explicit PassObserver(const inspect::Recording& recording)
        : FollowingObserver(recording), polygons_(recording) {}

    /// From now on; null: not kept.
    void keep_in(TileHistory* history) { history_ = history; }
    const PolygonPlane& polygons() const { return polygons_; }

    void begin_command(std::size_t command) override;
    void fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                  const PixelValues& after) override;
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override;

private:
    PolygonPlane polygons_;
    TileHistory* history_ = nullptr;
    State state_;
};

}  // namespace gw::report
