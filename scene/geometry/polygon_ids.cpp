#include "scene/geometry/polygon_ids.h"

#include <numeric>

namespace gw::scene {
namespace {

std::size_t polygon_count(const MeshData& data) {
    const std::size_t n = data.indices.empty() ? data.positions.size() : data.indices.size();
    switch (data.primitive) {
        case Primitive::Points: return n;
        case Primitive::Lines: return n / 2;
        case Primitive::LineStrip: return n < 2 ? 0 : n - 1;
        case Primitive::Triangles: return n / 3;
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan: return n < 3 ? 0 : n - 2;
        case Primitive::Quads: return n / 4;
        case Primitive::Polygons: return data.polygon_sizes.empty() ? 1 : data.polygon_sizes.size();
    }
    return 0;
}

}  // namespace

MeshRef make_numbered_mesh(MeshData data, std::uint32_t& next) {
    data.polygon_ids.resize(polygon_count(data));
    std::iota(data.polygon_ids.begin(), data.polygon_ids.end(), next);
    next += static_cast<std::uint32_t>(data.polygon_ids.size());
    return make_mesh(std::move(data));
}

}  // namespace gw::scene
