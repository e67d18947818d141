#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/vertices/light.cpp"
#include <hwy/foreach_target.h>

#include "gw/base/arithmetic.h"
#include "gw/fast/vertices/eye-inl.h"
#include "gw/fast/vertices/light.h"
#include "gw/fast/vertices/power-inl.h"

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

/// The terms of a light and the material that do not depend on the vertex.
struct LightTerms {
    const Light& light;
    dvec3 position, spot_direction;
    dvec3 ambient, lambert, gloss;
    bool directional = true, spot = false, glossy = false;
    bool turns = false;  ///< its contribution depends on the normal
};

inline LightTerms light_terms(const Light& light, const Material& m) {
    LightTerms t{light, dvec3(light.position), normalized(dvec3(light.spot_direction)), {}, {}, {}};
    t.directional = light.position.w == 0;
    if (t.directional)
        t.position = normalized(t.position);
    else
        t.position = {t.position.x / double(light.position.w),
                      t.position.y / double(light.position.w),
                      t.position.z / double(light.position.w)};
    t.spot = !t.directional && light.spot_cos_cutoff > -1;
    for (int c = 0; c < 3; ++c) {
        t.ambient[c] = double(light.Ia[c]) * m.Ka[c];
        t.lambert[c] = double(light.Id[c]) * m.Kd[c];
        t.gloss[c] = double(light.Is[c]) * m.Ks[c];
    }
    const auto some = [](const dvec3& v) { return v.x != 0 || v.y != 0 || v.z != 0; };
    t.glossy = some(t.gloss);
    t.turns = t.glossy || some(t.lambert);
    return t;
}

struct IncidentLanes {
    Vec3 direction;
    V64 strength;
};

inline V64 spot_factor(const LightTerms& t, const Vec3& to_light) {
    const auto c = dot(minus(to_light), all3(t.spot_direction));
    const auto outside =
        hn::Or(hn::Lt(c, all(t.light.spot_cos_cutoff)), hn::Le(c, hn::Zero(D64())));
    return power(at_most_one(c), t.light.spot_exponent, hn::Not(outside));
}

inline IncidentLanes incident(const LightTerms& t, const Vec3& p_eye) {
    if (t.directional) return {all3(t.position), all(1)};
    const Vec3 v{hn::Sub(all(t.position.x), p_eye.x), hn::Sub(all(t.position.y), p_eye.y),
                 hn::Sub(all(t.position.z), p_eye.z)};
    const auto d = hn::Sqrt(dot(v, v));
    const Vec3 direction = t.turns || t.spot ? unit(v) : v;
    const auto linear =
        hn::Add(all(t.light.constant_attenuation), hn::Mul(all(t.light.linear_attenuation), d));
    const auto fall = hn::Add(linear, hn::Mul(all(t.light.quadratic_attenuation), hn::Mul(d, d)));
    const auto least = all(1e-30);
    const auto strength = t.spot ? spot_factor(t, direction) : all(1);
    return {direction, hn::Div(strength, hn::IfThenElse(hn::Gt(fall, least), fall, least))};
}

inline void add_light(const LightTerms& t, const Material& m, const Vec3& p_eye, const Vec3& n_eye,
                      const Vec3& to_eye, V64* sum) {
    const IncidentLanes in = incident(t, p_eye);
    if (!t.turns) {
        for (int c = 0; c < 3; ++c)
            sum[c] = hn::Add(sum[c], hn::Mul(in.strength, all(t.ambient[c])));
        return;
    }
    const auto cosine = dot(n_eye, in.direction);
    const auto diffuse = positive(cosine);
    auto specular = hn::Zero(D64());
    if (t.glossy) {
        const Vec3 half =
            unit({hn::Add(in.direction.x, to_eye.x), hn::Add(in.direction.y, to_eye.y),
                  hn::Add(in.direction.z, to_eye.z)});
        specular =
            power(at_most_one(positive(dot(n_eye, half))), m.Ns, hn::Gt(cosine, hn::Zero(D64())));
    }
    for (int c = 0; c < 3; ++c) {
        const auto body = hn::Add(all(t.ambient[c]), hn::Mul(all(t.lambert[c]), diffuse));
        sum[c] = hn::Add(sum[c],
                         hn::Mul(in.strength, hn::Add(body, hn::Mul(all(t.gloss[c]), specular))));
    }
}

void light_all(const VertexProgram& p, std::span<const std::uint32_t> indices, bool back,
               std::span<Rgba> colors) {
    if (!p.is_common) return light_one_by_one(p, indices, back, colors);
    const D64 d;
    const std::size_t lanes = hn::Lanes(d);
    const Material& m = p.draw->material;
    const LightingState& state = p.state->lighting;
    const Profile& profile = *p.profile;
    const bool same_bits = profile.lit_bits == profile.color_bits;
    const auto store = [&](double v) {
        const auto lit = std::uint32_t(v);
        return std::uint16_t(same_bits ? lit : rescale(lit, profile.lit_bits, profile.color_bits));
    };
    const std::uint16_t alpha = store(quantize(m.alpha, profile.lit_bits));
    thread_local std::vector<LightTerms> lights;  // a small mesh would spend its time allocating
    lights.clear();
    if (p.draw->lights)
        for (const Light& light : *p.draw->lights) lights.push_back(light_terms(light, m));

    const auto any = [&](auto has) { return std::any_of(lights.begin(), lights.end(), has); };
    const bool turns = any([](const LightTerms&t) { return t.turns; }),
               glossy = any([](const LightTerms&t) { return t.glossy; });
    for (std::size_t first = 0; first < indices.size(); first += lanes) {
        const auto some = indices.subspan(first, std::min(lanes, indices.size() - first));
        const EyeVertices v = eye_vertices(p, some, turns);
        const Vec3 n_eye = back ? minus(v.normal) : v.normal, p_eye = v.position;
        const Vec3 to_eye = state.local_viewer && glossy ? unit(minus(p_eye)) : all3({0, 0, 1});
        V64 sum[3];
        for (int c = 0; c < 3; ++c)
            sum[c] = all(m.Ke[c] + double(state.model_ambient[c]) * m.Ka[c]);
        for (const LightTerms& light : lights) add_light(light, m, p_eye, n_eye, to_eye, sum);

        alignas(64) double out[3][8];
        for (int c = 0; c < 3; ++c) hn::Store(quantized(sum[c], profile.lit_bits), d, out[c]);
        for (std::size_t i = 0; i < some.size(); ++i)
            colors[some[i]] = {store(out[0][i]), store(out[1][i]), store(out[2][i]), alpha};
    }
}

#else  // no vectors of doubles here

void light_all(const VertexProgram& p, std::span<const std::uint32_t> indices, bool back,
               std::span<Rgba> colors) {
    light_one_by_one(p, indices, back, colors);
}

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(light_all);

void light_vertices(const VertexProgram& program, std::span<const std::uint32_t> indices, bool back,
                    std::span<Rgba> colors) {
    HWY_DYNAMIC_DISPATCH(light_all)(program, indices, back, colors);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
