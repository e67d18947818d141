#include "scene/draw/draw_commands.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

vec3 to_eye_direction(const View& view, const vec3& v_world) {
    return vec3(transform3(dmat3(view.eye_from_world), dvec3(v_world)));
}

vec3 to_eye_point(const View& view, const vec3& p_world) {
    const dvec3 turned = transform3(dmat3(view.eye_from_world), dvec3(p_world));
    return vec3(turned + dvec3(view.eye_from_world[3]));
}

/// a * b for affine matrices, each entry summed in one fixed order.
dmat4 affine_product(const dmat4& a, const dmat4& b) {
    dmat4 m(1);
    for (int column = 0; column < 4; ++column) {
        const dvec3 v = transform3(dmat3(a), dvec3(b[column]));
        m[column] = dvec4(v, b[column].w);
    }
    m[3] += dvec4(dvec3(a[3]), 0);
    return m;
}

/// The smallest and the largest of the mesh's own identifiers.
std::pair<std::uint32_t, std::uint32_t> id_range(const Mesh& mesh) {
    const auto& ids = mesh.data().polygon_ids;
    if (ids.empty()) return {0, mesh.polygon_count() == 0 ? 0 : mesh.polygon_count() - 1};
    const auto [low, high] = std::minmax_element(ids.begin(), ids.end());
    return {*low, *high};
}

}  // namespace

State view_state(const View& view) {
    State state;
    state.projection = view.clip_from_eye;
    state.viewport = {0, 0, view.width, view.height};
    if (view.only_rows)
        state.scissor = {true, {0, view.rows().first, view.width, view.rows().count()}};
    state.depth = {.test = true, .func = DepthFunc::Less, .mask = true};
    state.color_source = ColorSource::Lighting;
    state.lighting = {.local_viewer = !is_orthographic(view), .two_side = true};
    return state;
}

Draw placed(const Object& object, const View& view) {
    return {.mesh = object.mesh,
            .eye_from_object = affine_product(view.eye_from_world, object.world_from_object)};
}

gw::Light eye_light(const Light& light, const View& view) {
    gw::Light out;
    out.Ia = light.Ia;
    out.Id = light.Id;
    out.Is = light.Is.value_or(light.Id);
    if (light.kind == LightKind::Directional) {
        out.position = vec4(to_eye_direction(view, -light.direction), 0);
        return out;
    }
    out.position = vec4(to_eye_point(view, light.position), 1);
    out.constant_attenuation = light.constant_attenuation;
    out.linear_attenuation = light.linear_attenuation;
    out.quadratic_attenuation = light.quadratic_attenuation;
    if (light.kind == LightKind::Point) return out;
    out.spot_direction = to_eye_direction(view, light.direction);
    out.spot_exponent = light.spot_exponent;
    out.spot_cos_cutoff = static_cast<float>(cos_degrees(light.cone_angle));
    return out;
}

gw::Material machine_material(const Material& m) {
    return {.Ka = m.Ka, .Kd = m.Kd, .Ks = m.Ks, .Ke = m.Ke, .Ns = m.Ns, .alpha = m.d};
}

bool lights_object(const Light& light, const Object& object) {
    return light.only.empty() || light.only.contains(object.name);
}

TextureState texture_state(const Map& map) {
    TextureState state;
    state.min_filter = MinFilter::LinearMipmapLinear;
    state.wrap_s = map.wrap_s;
    state.wrap_t = map.wrap_t;
    return state;
}

MeshRef mapped_mesh(const MeshRef& mesh, const Map& map) {
    if ((map.scale == vec2(1) && map.offset == vec2(0)) || mesh->data().texcoords.empty())
        return mesh;
    MeshData data = mesh->data();
    for (vec2& st : data.texcoords) st = st * map.scale + map.offset;
    return make_mesh(std::move(data));
}

PolygonIds polygon_ids(const Scene& scene) {
    PolygonIds ids;
    for (const Object& object : scene.objects) {
        const auto [low, high] = id_range(*object.mesh);
        ids.first.push_back(ids.end);
        ids.lowest.push_back(low);
        ids.end += high - low + 1;
    }
    return ids;
}

std::optional<PolygonRef> polygon_of(const PolygonIds& ids, std::uint32_t id) {
    const auto after = std::upper_bound(ids.first.begin(), ids.first.end(), id);
    if (after == ids.first.begin()) return std::nullopt;
    const auto object = std::size_t(after - ids.first.begin()) - 1;
    return PolygonRef{object, id - ids.first[object]};
}

CommandList id_pass(const Scene& scene, const View& view, const IdPass& options) {
    State state = view_state(view);
    state.color_source = ColorSource::PolygonId;
    state.shade_model = ShadeModel::Flat;
    state.jitter = options.jitter;
    if (options.scissor.test) state.scissor = options.scissor;
    state.clip_planes[0] = options.clip;
    CommandList list;
    list.commands.reserve(3 + scene.objects.size());
    list.add(BeginPass{.name = options.name});
    list.add(SetState{state});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth))});
    const PolygonIds ids = polygon_ids(scene);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (options.opaque_only && scene.materials[scene.objects[i].material].d < 1) continue;
        if (const CullState cull = cull_of(scene.objects[i]); cull != state.cull) {
            state.cull = cull;
            list.add(SetState{state});
        }
        Draw draw = placed(scene.objects[i], view);
        draw.id_base = ids.first[i] - ids.lowest[i];  // modulo 2^32
        draw.id_shift = options.shift;
        list.add(std::move(draw));
    }
    return list;
}

void add_shapes(CommandList& list, const Scene& scene, const View& view) {
    for (const Object& object : scene.objects) list.add(placed(object, view));
}

}  // namespace gw::scene
