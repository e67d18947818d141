// The texels of a plane figure in one hemicube, one after the other and no vectors: the scalar twin
// of texel_rows.cpp.
#pragma once

#include "radiosity/hemicube/texel_rows.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {

class PlainTexels {
public:
    explicit PlainTexels(const TexelSight& sight) : sight_(sight), view_(sight.view) {
        for (int c = 0; c < 3; ++c)
            half_ = std::max(half_, 0.5 * (std::abs(view_.du[c]) + std::abs(view_.dv[c])));
    }

    float corner(int u, int v) const { return integrand(at(float(u), float(v))); }

    /// Of one texel.
    struct Found {
        float factor = 0;
        TexelKind kind = decided;
    };
    Found find(int u, int v) const {
        const float mu = float(u) + 0.5f, mv = float(v) + 0.5f;
        const Position p = at(mu, mv);
        const float corners =
            (corner(u, v) + corner(u + 1, v)) + (corner(u, v + 1) + corner(u + 1, v + 1));
        const float r2 = p.r2(), r4 = r2 * r2, along = p.along(), over = 1 / (along * r4);
        const float middle = std::max(p.z, 0.0f) * (over * along);
        const float whole = float(view_.flux / 3) * (middle * 2 + corners * 0.25f);
        const std::uint32_t pixel = look_at(p, over * r4);
        const bool shown = (pixel & id_bits) == sight_.id;
        const bool alone =
            float(pixel >> 24) * (along - float(half_)) >= float(sight_.seen.size * half_);
        const float above = float(0.5 * (std::abs(view_.du.z) + std::abs(view_.dv.z)));
        const bool dark = p.z + above <= 0 || (alone && !shown);
        if (dark) return {};
        return {whole, kind(p, mu, double(mv), over * r4, alone)};
    }

    float share(TexelKind kind, const dvec2& middle, const dvec2& inside) const {
        const bool border = kind > at_border;
        const auto number = std::size_t(kind - 1 - (border ? at_border : 0));
        const int count = sample_counts[number], step = number > 0 ? sample_counts[number - 1] : 3;
        Light light;
        if (border) add(float(inside.x), float(inside.y), border, true, light);
        for (int s = 0; s < count; ++s)
            add(float(middle.x) + float((s % count + 0.5) / count - 0.5),
                float(middle.y) + float((s * step % count + 0.5) / count - 0.5), border, false,
                light);
        return light.all > 0 ? light.shown / light.all : 0;
    }

private:
    struct Position {
        float x, y, z;
        float r2() const { return x * x + (y * y + z * z); }
        float along() const { return std::max(z, std::max(std::abs(x), std::abs(y))); }
    };
    struct Light {
        float all = 0, shown = 0;
    };

    Position at(float u, float v) const {
        const auto of = [&](int c) {
            return float(view_.origin[c]) + (u * float(view_.du[c]) + v * float(view_.dv[c]));
        };
        return {of(0), of(1), of(2)};
    }

    static float integrand(const Position& p) {
        const float r2 = p.r2();
        return std::max(p.z, 0.0f) / (r2 * r2);
    }

    struct Place {
        float x = 0, y = 0, last_row = 0;
        std::size_t first = 0;
    };
    Place place(const Position& p, float by_along) const {
        const int size = sight_.seen.size;
        const float half = float(size) * 0.5f, over = by_along * half;
        const bool by_x = std::abs(p.x) >= std::abs(p.y);
        const auto face = [&](int number) {
            return std::size_t(size * size + (number - 1) * (size * size / 2));
        };
        if (p.z >= std::max(std::abs(p.x), std::abs(p.y)))
            return {p.x * over + half, p.y * over + half, float(size - 1), 0};
        const float row = p.z * over, last = float(size / 2 - 1);
        if (by_x)
            return {(p.x < 0 ? -p.y : p.y) * over + half, row, last, p.x < 0 ? face(1) : face(2)};
        return {(p.y < 0 ? p.x : -p.x) * over + half, row, last, p.y < 0 ? face(3) : face(4)};
    }
    std::uint32_t pixel(const Place& place, float x, float y) const {
        const int column = static_cast<int>(std::clamp(x, 0.0f, float(sight_.seen.size - 1))),
                  row = static_cast<int>(std::clamp(y, 0.0f, place.last_row));
        return sight_.seen.pixels[place.first + pixel_index(column, row, sight_.seen.size)];
    }
    std::uint32_t look_at(const Position& p, float by_along) const {
        const Place found = place(p, by_along);
        return pixel(found, found.x, found.y);
    }
    bool is_shown(std::uint32_t seen) const { return (seen & id_bits) == sight_.id; }

    TexelKind kind(const Position& p, float u, double v, float by_along, bool alone) const {
        const double half_size = sight_.seen.size * 0.5,
                     longest = std::max(dot3(view_.du, view_.du), dot3(view_.dv, view_.dv));
        const float pixels =
            by_along * (by_along * by_along) * float(view_.depth * half_size * half_size);
        if (p.r2() < float(near_sides * near_sides * longest)) return near_point;
        if (alone) return decided;
        if (pixels > float(pixels_per_sample * sample_counts.back())) return near_point;
        TexelKind kind = 1;
        for (std::size_t i = 0; i + 1 < sample_counts.size(); ++i)
            kind += pixels > float(pixels_per_sample * sample_counts[i]) ? 1 : 0;
        return kind + (beside_border(u, v, p.along()) ? at_border : 0);
    }

    bool beside_border(float u, double v, float along) const {
        const double reach = reach_of_border(sight_.seen.size);
        for (std::size_t k = 0; k < view_.side_count; ++k) {
            const dvec3& side = view_.sides[k];
            const double least =
                side.x + v * side.z - 0.5 * (std::abs(side.y) + std::abs(side.z)) - reach * half_;
            if (u * float(side.y) + float(least) < along * float(reach)) return true;
        }
        return false;
    }

    void add(float u, float v, bool border, bool is_inside, Light& light) const {
        const Position p = at(u, v);
        const float r2 = p.r2(), r4 = r2 * r2, along = p.along(), over = 1 / (along * r4);
        float value = std::max(p.z, 0.0f) * (over * along);
        const Place found = place(p, over * r4);
        bool shown = is_shown(pixel(found, found.x, found.y));
        if (border) {
            float inward = 0;
            for (std::size_t k = 0; k < view_.side_count; ++k) {
                const dvec3& side = view_.sides[k];
                const float from = float(side.x) + (u * float(side.y) + v * float(side.z));
                inward = k == 0 ? from : std::min(inward, from);
            }
            if (!is_inside && inward < 0) value = 0;
            if (!shown && inward < along * float(reach_of_border(sight_.seen.size))) {
                const float x = found.x + 0.5f, y = found.y + 0.5f;
                for (const float row : {y - 1, y})
                    for (const float column : {x - 1, x})
                        shown = shown || is_shown(pixel(found, column, row));
            }
        }
        light.all += value;
        if (shown) light.shown += value;
    }

    const TexelSight& sight_;
    const FigureView& view_;
    double half_ = 0;
};

}  // namespace gw::radiosity
