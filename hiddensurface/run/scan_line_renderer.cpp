#include "hiddensurface/run/scan_line_renderer.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/vertex.h"
#include "hiddensurface/faces/visible_spans.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/polygon.h"
#include "scene/draw/draw_commands.h"
#include "scene/draw/shading.h"
#include "scene/draw/world_triangles.h"

namespace gw::hiddensurface {
namespace {

/// The surface under a pixel: position, normal and texture coordinates in perspective, from the ray
/// through the pixel's centre.
class Surfaces {
public:
    Surfaces(const scene::Scene& scene, const scene::View& view);

    /// The point of the triangle on the ray through `p`, in pixels; if rounding puts it outside, the
    /// nearest point. `front`: the triangle's winding in the window shows its front.
    scene::SurfacePoint at(std::size_t object, std::uint32_t triangle, const dvec2& p,
                           bool front) const;

private:
    struct Placed {
        const Mesh* mesh = nullptr;
        std::vector<dvec3> p_eye, n_eye;
    };
    struct Sight {
        dvec3 origin, direction;
    };
    Sight sight(double x, double y) const;

    const scene::View& view_;
    std::vector<Placed> placed_;
};

using scene::inside;
using scene::mix;
using scene::Weights;
using scene::weights_at;

/// True if the triangle is counter-clockwise in the window.
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

class Shader {
public:
    Shader(const Input& input, const JitterState& jitter)
        : input_(input), surfaces_(input.scene, input.view) {
        const double unit = 1.0 / double(1 << input.subpixel_bits());
        center_ = dvec2(0.5) - dvec2(jitter.x, jitter.y) * unit;
        for (const scene::Object& object : input.scene.objects) {
            lights_.emplace_back();
            for (const scene::Light& light : input.scene.lights)
                if (scene::lights_object(light, object))
                    lights_.back().push_back(scene::eye_light(light, input.view));
        }
    }

    Rgba color(const VisibleSpan& span, int x) const {
        const Polygon& polygon = input_.polygons[span.polygon];
        const WindowTriangle& triangle = polygon.triangles[span.triangle];
        const scene::Object& object = input_.scene.objects[polygon.object];
        const scene::SurfacePoint point = surfaces_.at(
            polygon.object, triangle.source, dvec2(x, span.run.y) + center_, is_front(triangle));
        const dvec3 sum = scene::shade(input_.scene.materials.at(object.material),
                                       lights_[polygon.object], point);
        const auto store = [this](double v) {
            return static_cast<std::uint16_t>(quantize(v, input_.profile.color_bits));
        };
        return {store(sum.x), store(sum.y), store(sum.z), store(1)};
    }

private:
    const Input& input_;
    Surfaces surfaces_;
    dvec2 center_;                                ///< of pixel 0, 0 in the unjittered window
    std::vector<std::vector<gw::Light>> lights_;  ///< of each object
};

void add_line(CommandList& list, const Shader& shader, const std::vector<VisibleSpan>& line) {
    WriteSpans command;
    for (const VisibleSpan& span : line) {
        command.spans.push_back({.x = span.run.x0,
                                 .y = span.run.y,
                                 .length = span.run.x1 - span.run.x0,
                                 .first = static_cast<std::uint32_t>(command.colors.size()),
                                 .flat = false});
        for (int x = span.run.x0; x < span.run.x1; ++x)
            command.colors.push_back(shader.color(span, x));
    }
    if (!line.empty()) list.add(std::move(command));
}

}  // namespace

CommandList scan_line_picture(const scene::Scene& scene, const scene::View& view,
                              const Profile& profile, const JitterState& jitter) {
    const Input input{scene, view, profile, project(scene, view, profile, jitter)};
    CommandList list = begin_picture(input, "scan-line, eq. 3");
    std::get<Clear>(list.commands.back()).color = vec4(scene.background, 1);
    const Shader shader(input, jitter);
    Counts counts;
    StepLog none;
    for_visible_spans(input, counts, none, [&](const std::vector<VisibleSpan>& line) {
        if (view.rows().contains(line.front().run.y)) add_line(list, shader, line);
    });
    return list;
}

}  // namespace gw::hiddensurface
