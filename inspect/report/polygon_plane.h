// Which polygon each pixel shows: the one that was last to write its colour or Z. Polygons of a
// recording are numbered from 1, mesh after mesh in the order of their first draw. Does not observe
// a machine.
#pragma once

#include "gw/reference/observer.h"
#include "inspect/recording/recording.h"

#include <map>
#include <vector>

namespace gw::report {

class PolygonPlane {
public:
    explicit PolygonPlane(const inspect::Recording& recording);

    /// 0: none. Bottom row first.
    const std::vector<std::uint32_t>& ids() const { return ids_; }

    /// A written fragment of `draw`; `polygon`: its identifier in the mesh. Keeps the pixel's where
    /// `state` masks colour and Z.
    void written(const Fragment& fragment, const Draw& draw, std::uint32_t polygon,
                 const State& state);
    /// A pixel whose colour or Z was cleared shows no polygon.
    void cleared(int x, int y) { id_at(x, y) = 0; }

private:
    std::uint32_t& id_at(int x, int y) {
        return ids_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
    }

    int width_;
    std::vector<std::uint32_t> ids_;
    /// of a mesh's polygons, by address: looked up only
    std::map<const Mesh*, std::uint32_t> first_;
};

}  // namespace gw::report
