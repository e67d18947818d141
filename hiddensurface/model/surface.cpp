#include "hiddensurface/model/surface.h"

#include "gw/stages/vertex.h"
#include "hiddensurface/model/normal.h"
#include "scene/draw/draw_commands.h"
#include "scene/geometry/weights.h"

namespace gw::hiddensurface {
namespace {

using scene::inside;
using scene::mix;
using scene::Weights;
using scene::weights_at;

}  // namespace

bool is_front(const WindowTriangle& t) {
    const auto& [a, b, c] = t.corners;
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) > 0;
}

Surfaces::Surfaces(const scene::Scene& scene, const scene::View& view) : view_(view) {
    for (const scene::Object& object : scene.objects) {
        const Draw draw = scene::placed(object, view);
        const State state = scene::view_state(view);
        const Profile profile = vgx();
        const VertexProgram program = vertex_program(state, draw, profile);
        const MeshData& data = object.mesh->data();
        Placed placed{object.mesh.get(), {}, {}};
        for (const vec3& p : data.positions)
            placed.p_eye.push_back(dvec3(transform(draw.eye_from_object, dvec4(dvec3(p), 1))));
        for (const vec3& n : data.normals)
            placed.n_eye.push_back(
                normalized(transform3(program.normal_eye_from_object, dvec3(n))));
        placed_.push_back(std::move(placed));
    }
}

Surfaces::Sight Surfaces::sight(double x, double y) const {
    const dmat4& m = view_.clip_from_eye;
    const double nx = 2 * x / view_.width - 1, ny = 2 * y / view_.height - 1;
    if (m[3].w == 0) return {dvec3(0), dvec3((nx + m[2].x) / m[0].x, (ny + m[2].y) / m[1].y, -1)};
    return {dvec3((nx - m[3].x) / m[0].x, (ny - m[3].y) / m[1].y, 0), dvec3(0, 0, -1)};
}

scene::SurfacePoint Surfaces::at(std::size_t object, std::uint32_t triangle, const dvec2& at,
                                 bool front) const {
    const Placed& placed = placed_[object];
    const auto& vertex = placed.mesh->triangles()[triangle].vertex;
    std::array<dvec3, 3> p, n;
    std::array<dvec2, 3> st{};
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = placed.p_eye[vertex[k]];
        n[k] = placed.n_eye.empty() ? dvec3(0, 0, 1) : placed.n_eye[vertex[k]];
        if (!placed.mesh->data().texcoords.empty())
            st[k] = dvec2(placed.mesh->data().texcoords[vertex[k]]);
    }
    const auto weights = [&](double i, double j) {
        const Sight s = sight(i, j);
        return weights_at(p, s.origin, s.direction);
    };
    const Weights here = weights(at.x, at.y), w = inside(here);
    scene::SurfacePoint out{.p = mix(w, p), .n = normalized(mix(w, n)), .st = mix(w, st)};
    if (!front) out.n = -out.n;
    out.to_eye =
        scene::is_orthographic(view_) ? dvec3(0, 0, 1) : normalized(-out.p);  // as the machine's
    out.st_dx = mix(weights(at.x + 1, at.y), st) - mix(here, st);
    out.st_dy = mix(weights(at.x, at.y + 1), st) - mix(here, st);
    return out;
}

}  // namespace gw::hiddensurface
