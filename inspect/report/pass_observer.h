// Observes every fragment of the reference machine and passes it on: to the plane of polygons, and
// to the histories while they are kept.
#pragma once

#include "inspect/replay/following_observer.h"
#include "inspect/report/tile_history.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace gw::report {

/// The polygon that each pixel shows: the one that last wrote its colour or Z. Polygons of a
/// recording are numbered from 1, object after object in the order of their first draw. An object is
/// a mesh at a place: those that share a mesh are different.
class PolygonPlane {
public:
    explicit PolygonPlane(const inspect::Recording& recording);

    /// 0: none. Bottom row first.
    const std::vector<std::uint32_t>& ids() const { return ids_; }

    /// The next fragments are of this draw.
    void begin(const Draw& draw) { drawn_ = first_.at(object_of(draw)); }
    /// A written fragment; `polygon`: its identifier in the mesh. Keeps the pixel's polygon if
    /// `state` masks colour and Z.
    void written(const Fragment& fragment, std::uint32_t polygon, const State& state);
    /// A pixel whose colour or Z was cleared shows no polygon.
    void cleared(int x, int y) { id_at(x, y) = 0; }

private:
    std::uint32_t& id_at(int x, int y) {
        return ids_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
    }

    /// A mesh, by address, and its place in eye space: looked up only.
    using Object = std::pair<const Mesh*, std::array<double, 16>>;
    static Object object_of(const Draw& draw);

    int width_;
    std::vector<std::uint32_t> ids_;
    std::map<Object, std::uint32_t> first_;  ///< of the object's polygons
    std::uint32_t drawn_ = 0;                ///< the first polygon of the draw
};

class PassObserver : public inspect::FollowingObserver {
public:
    /// `identifiers`: colours name polygons, also those of spans.
    PassObserver(const inspect::Recording& recording, bool identifiers)
        : FollowingObserver(recording), polygons_(recording), identifiers_(identifiers) {}

    /// From now on; null: not kept.
    void keep_in(TileHistory* history) { history_ = history; }
    const PolygonPlane& polygons() const { return polygons_; }

    void begin_command(std::size_t command) override;
    void fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                  const PixelValues& after) override;
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override;

private:
    std::optional<std::uint32_t> named(const Fragment& fragment) const;

    PolygonPlane polygons_;
    bool identifiers_;
    TileHistory* history_ = nullptr;
    State state_;
};

}  // namespace gw::report
