#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/vertices/light.cpp"
#include <hwy/foreach_target.h>

#include "gw/base/arithmetic.h"
#include "gw/fast/vertices/eye-inl.h"
#include "gw/fast/vertices/light.h"
#include "gw/fast/vertices/power-inl.h"
#include "gw/stages/resolve.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Any vertices.
inline void light_one_by_one(const VertexProgram& p, std::span<const std::uint32_t> indices,
                             bool back, std::span<Rgba> colors) {
    for (const std::uint32_t i : indices) {
        const Vertex vertex = run_vertex(p, i);
        const auto& v = back ? vertex.back_color : vertex.color;
        colors[i] = {std::uint16_t(v[0]), std::uint16_t(v[1]), std::uint16_t(v[2]),
                     std::uint16_t(v[3])};
    }
}

#if HWY_HAVE_FLOAT64

/// The materials of up to a vector of vertices.
struct MaterialLanes {
    Vec3 Ka, Kd, Ks, Ke;
    V64 alpha;
};

inline MaterialLanes one_material(const Material& m) {
    return {all3(m.Ka), all3(m.Kd), all3(m.Ks), all3(m.Ke), all(double(m.alpha))};
}

/// Lanes beyond the last vertex repeat the first.
inline MaterialLanes materials_of(const VertexProgram& p, std::span<const std::uint32_t> indices,
                                  Face side) {
    const D64 d;
    alignas(64) double lanes[13][8];
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const Material m = material_of(p, indices[i < indices.size() ? i : 0], side);
        for (int c = 0; c < 3; ++c) {
            lanes[c][i] = m.Ka[c];
            lanes[3 + c][i] = m.Kd[c];
            lanes[6 + c][i] = m.Ks[c];
            lanes[9 + c][i] = m.Ke[c];
        }
        lanes[12][i] = m.alpha;
    }
    const auto at = [&](int first) {
        return Vec3{hn::Load(d, lanes[first]), hn::Load(d, lanes[first + 1]),
                    hn::Load(d, lanes[first + 2])};
    };
    return {at(0), at(3), at(6), at(9), hn::Load(d, lanes[12])};
}

/// Component by component.
inline Vec3 product(const vec3& a, const Vec3& b) {
    return {hn::Mul(all(a.x), b.x), hn::Mul(all(a.y), b.y), hn::Mul(all(a.z), b.z)};
}

inline bool is_zero(const Vec3& v) {
    const D64 d;
    const auto zero = hn::Zero(d);
    return hn::AllTrue(d,
                       hn::And(hn::Eq(v.x, zero), hn::And(hn::Eq(v.y, zero), hn::Eq(v.z, zero))));
}

/// Finds the parts of a light's contribution that these materials need.
inline void set_needs(PreparedLight& t, const MaterialLanes& m) {
    t.glossy = !is_zero(product(t.light->Is, m.Ks));
    t.turns = t.glossy || !is_zero(product(t.light->Id, m.Kd));
}

struct IncidentLanes {
    Vec3 direction;
    V64 strength;
};

inline V64 spot_factor(const PreparedLight& t, const Vec3& to_light) {
    const auto c = dot(minus(to_light), all3(t.spot_direction));
    const auto outside =
        hn::Or(hn::Lt(c, all(t.light->spot_cos_cutoff)), hn::Le(c, hn::Zero(D64())));
    return power(at_most_one(c), t.light->spot_exponent, hn::Not(outside));
}

inline IncidentLanes incident(const PreparedLight& t, const Vec3& p_eye) {
    if (t.directional) return {all3(t.position), all(1)};
    const Vec3 v{hn::Sub(all(t.position.x), p_eye.x), hn::Sub(all(t.position.y), p_eye.y),
                 hn::Sub(all(t.position.z), p_eye.z)};
    const auto d = hn::Sqrt(dot(v, v));
    const Vec3 direction = t.turns || t.spot ? unit(v) : v;
    const auto linear =
        hn::Add(all(t.light->constant_attenuation), hn::Mul(all(t.light->linear_attenuation), d));
    const auto fall = hn::Add(linear, hn::Mul(all(t.light->quadratic_attenuation), hn::Mul(d, d)));
    const auto least = all(1e-30);
    const auto strength = t.spot ? spot_factor(t, direction) : all(1);
    return {direction, hn::Div(strength, hn::IfThenElse(hn::Gt(fall, least), fall, least))};
}

inline Vec3 sum(const Vec3& a, const Vec3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
inline Vec3 product(V64 a, const Vec3& b) {
    return {hn::Mul(a, b.x), hn::Mul(a, b.y), hn::Mul(a, b.z)};
}

/// The colour that a light adds.
inline Vec3 contribution(const PreparedLight& t, const MaterialLanes& m, double exponent,
                         const Vec3& p_eye, const Vec3& n_eye, const Vec3& to_eye) {
    const IncidentLanes in = incident(t, p_eye);
    Vec3 out = product(t.light->Ia, m.Ka);
    if (!t.turns) return product(in.strength, out);
    const D64 d;
    if (hn::AllTrue(d, hn::Eq(in.strength, hn::Zero(d)))) return product(in.strength, out);
    const auto cosine = dot(n_eye, in.direction);
    out = sum(out, product(positive(cosine), product(t.light->Id, m.Kd)));
    if (!t.glossy) return product(in.strength, out);
    const Vec3 half = unit(sum(in.direction, to_eye));
    const auto specular =
        power(at_most_one(positive(dot(n_eye, half))), exponent, hn::Gt(cosine, hn::Zero(D64())));
    return product(in.strength, sum(out, product(specular, product(t.light->Is, m.Ks))));
}

/// One side of a draw's vertices, whose materials have one exponent.
struct SideLighting {
    const VertexProgram& p;
    Face side;
    double exponent;
    std::span<PreparedLight> lights;
    MaterialLanes material;              ///< set by use()
    bool turns = false, glossy = false;  ///< some light's
    bool places = false;                 ///< the colours depend on the position

    SideLighting(const VertexProgram& program, Face face, double Ns, std::span<PreparedLight> terms)
        : p(program), side(face), exponent(Ns), lights(terms) {}

    void use(const MaterialLanes& m) {
        material = m;
        turns = glossy = places = false;
        for (PreparedLight& light : lights) {
            set_needs(light, m);
            turns = turns || light.turns;
            glossy = glossy || light.glossy;
            places = places || !light.directional;
        }
        places = places || (glossy && p.state->lighting.local_viewer);
    }

    /// Colours of up to a vector of vertices, before rounding.
    Vec3 colors(std::span<const std::uint32_t> indices) const {
        const LightingState& state = p.state->lighting;
        const Vec3 p_eye = places ? eye_position(p, indices) : all3({0, 0, 0});
        Vec3 n_eye = turns ? eye_normal(p, indices) : all3({0, 0, 1});
        if (side == Face::Back) n_eye = minus(n_eye);
        const Vec3 to_eye = state.local_viewer && glossy ? unit(minus(p_eye)) : all3({0, 0, 1});
        Vec3 out = sum(material.Ke, product(vec3(state.model_ambient), material.Ka));
        for (const PreparedLight& light : lights)
            out = sum(out, contribution(light, material, exponent, p_eye, n_eye, to_eye));
        return out;
    }
};

/// Whether all materials of the mesh's vertices have one exponent.
bool has_one_exponent(const MeshData& mesh, bool back) {
    if (mesh.material_indices.empty()) return true;
    const auto exponent = [&](const FaceMaterials& m) { return back ? m.back.Ns : m.front.Ns; };
    return std::all_of(mesh.materials.begin(), mesh.materials.end(), [&](const FaceMaterials& m) {
        return exponent(m) == exponent(mesh.materials[0]);
    });
}

void light_all(const VertexProgram& p, PreparedLights& lights,
               std::span<const std::uint32_t> indices, bool back, std::span<Rgba> colors) {
    if (indices.empty()) return;
    if (!p.is_affine || !has_one_exponent(p.draw->mesh->data(), back))
        return light_one_by_one(p, indices, back, colors);
    const D64 d;
    const std::size_t lanes = hn::Lanes(d);
    const Profile& profile = *p.profile;
    const bool same_bits = profile.lit_bits == profile.color_bits;
    const auto store = [&](double v) {
        const auto lit = std::uint32_t(v);
        return std::uint16_t(same_bits ? lit : rescale(lit, profile.lit_bits, profile.color_bits));
    };
    const Face side = back ? Face::Back : Face::Front;
    const Material first_material = material_of(p, indices[0], side);
    SideLighting lighting(p, side, first_material.Ns, lights.of(p.draw->lights));
    lighting.use(one_material(first_material));
    for (std::size_t first = 0; first < indices.size(); first += lanes) {
        const auto some = indices.subspan(first, std::min(lanes, indices.size() - first));
        if (!p.has_one_material) lighting.use(materials_of(p, some, side));
        const Vec3 color = lighting.colors(some);
        alignas(64) double out[4][8];
        hn::Store(quantized(color.x, profile.lit_bits), d, out[0]);
        hn::Store(quantized(color.y, profile.lit_bits), d, out[1]);
        hn::Store(quantized(color.z, profile.lit_bits), d, out[2]);
        hn::Store(quantized(lighting.material.alpha, profile.lit_bits), d, out[3]);
        for (std::size_t i = 0; i < some.size(); ++i)
            colors[some[i]] = {store(out[0][i]), store(out[1][i]), store(out[2][i]),
                               store(out[3][i])};
    }
}

void quantize_all(const GivenColors& given, std::span<Rgba> colors) {
    const hn::CappedTag<double, 4> d;
    const hn::Rebind<float, decltype(d)> f;
    const hn::Rebind<std::int32_t, decltype(d)> i32;
    const hn::Rebind<std::uint16_t, decltype(d)> u16;
    for (const std::uint32_t i : given.indices)
        for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
            const auto v = hn::PromoteTo(d, hn::LoadU(f, &given.all[i].x + c));
            const auto rounded = hn::DemoteTo(i32, quantized(v, given.bits));
            hn::StoreU(hn::DemoteTo(u16, rounded), u16, colors[i].data() + c);
        }
}

#else  // no vectors of doubles here

void quantize_all(const GivenColors& given, std::span<Rgba> colors) {
    for (const std::uint32_t i : given.indices)
        colors[i] = quantize_color(given.all[i], given.bits);
}

void light_all(const VertexProgram& p, PreparedLights&, std::span<const std::uint32_t> indices,
               bool back, std::span<Rgba> colors) {
    light_one_by_one(p, indices, back, colors);
}

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(light_all);
HWY_EXPORT(quantize_all);

namespace {

PreparedLight prepared(const Light& light) {
    PreparedLight t{&light, dvec3(light.position), dvec3(light.spot_direction)};
    t.directional = light.position.w == 0;
    if (t.directional)
        t.position = normalized(t.position);
    else
        t.position = {t.position.x / double(light.position.w),
                      t.position.y / double(light.position.w),
                      t.position.z / double(light.position.w)};
    t.spot = !t.directional && light.spot_cos_cutoff > -1;
    if (t.spot) t.spot_direction = normalized(t.spot_direction);
    return t;
}

}  // namespace

std::span<PreparedLight> PreparedLights::of(const LightsRef& lights) {
    if (lights.get() == lights_) return terms_;
    terms_.clear();
    if (lights)
        for (const Light& light : *lights) terms_.push_back(prepared(light));
    lights_ = lights.get();
    return terms_;
}

void light_vertices(const VertexProgram& program, PreparedLights& lights,
                    std::span<const std::uint32_t> indices, bool back, std::span<Rgba> colors) {
    HWY_DYNAMIC_DISPATCH(light_all)(program, lights, indices, back, colors);
}

void quantize_colors(const GivenColors& given, std::span<Rgba> colors) {
    HWY_DYNAMIC_DISPATCH(quantize_all)(given, colors);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
