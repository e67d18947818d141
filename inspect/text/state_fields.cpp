#include "inspect/text/state_fields.h"

#include "inspect/text/value_text.h"

#include <fmt/format.h>

namespace gw::inspect {
namespace {

/// Bits, not a number.
std::string hex(std::uint32_t mask) { return fmt::format("{:#x}", mask); }

/// Rows from the bottom; "none" where there is no stipple.
std::string stipple_rows(const PolygonStippleState& stipple) {
    if (!stipple.pattern) return "none";
    std::string rows;
    for (const std::uint32_t row : *stipple.pattern) rows += fmt::format("{:08x} ", row);
    rows.pop_back();
    return rows;
}

void add_geometry(const State& s, const auto& add) {
    add("projection", s.projection);
    add("normalize", s.normalize);
    add("viewport", Rect{s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height});
    add("depth_range.near_value", s.depth_range.near_value);
    add("depth_range.far_value", s.depth_range.far_value);
    for (std::size_t i = 0; i < s.clip_planes.size(); ++i) {
        add(fmt::format("clip_planes.{}.enable", i), s.clip_planes[i].enable);
        add(fmt::format("clip_planes.{}.plane", i), s.clip_planes[i].plane);
    }
    add("cull.enable", s.cull.enable);
    add("cull.face", s.cull.face);
    add("cull.front", s.cull.front);
    add("polygon_mode", s.polygon_mode);
    add("polygon_offset.enable", s.polygon_offset.enable);
    add("polygon_offset.factor", s.polygon_offset.factor);
    add("polygon_offset.units", s.polygon_offset.units);
    add("polygon_offset.lines", s.polygon_offset.lines);
    add("polygon_offset.points", s.polygon_offset.points);
    add("two_side_polygon_mode", s.two_side_polygon_mode);
    add("back_polygon_mode", s.back_polygon_mode);
    add("line_stipple.enable", s.line_stipple.enable);
    add("line_stipple.factor", s.line_stipple.factor);
    add("line_stipple.pattern", hex(s.line_stipple.pattern));
    add("polygon_stipple", stipple_rows(s.polygon_stipple));
    add("jitter.x", s.jitter.x);
    add("jitter.y", s.jitter.y);
    add("point_size", s.point_size);
    add("line_width", s.line_width);
    add("point_smooth", s.point_smooth);
    add("line_smooth", s.line_smooth);
    add("polygon_smooth", s.polygon_smooth);
}

void add_shading(const State& s, const auto& add) {
    add("shade_model", s.shade_model);
    add("color_source", s.color_source);
    add("lighting.local_viewer", s.lighting.local_viewer);
    add("lighting.two_side", s.lighting.two_side);
    add("lighting.model_ambient", s.lighting.model_ambient);
    add("lighting.color_material.enable", s.lighting.color_material.enable);
    add("lighting.color_material.face", s.lighting.color_material.face);
    add("lighting.color_material.mode", s.lighting.color_material.mode);
    add("fog.enable", s.fog.enable);
    add("fog.mode", s.fog.mode);
    add("fog.density", s.fog.density);
    add("fog.start", s.fog.start);
    add("fog.end", s.fog.end);
    add("fog.color", s.fog.color);
    add("fog.coordinate", s.fog.coordinate);
    add("texture.min_filter", s.texture.min_filter);
    add("texture.mag_filter", s.texture.mag_filter);
    add("texture.wrap_s", s.texture.wrap_s);
    add("texture.wrap_t", s.texture.wrap_t);
    add("texture.env", s.texture.env);
    add("texture.env_color", s.texture.env_color);
    add("texture.gen", s.texture.gen);
    add("texture.eta", s.texture.eta);
    add("texture.eye_linear", s.texture.eye_linear);
    for (std::size_t i = 0; i < 4; ++i) {
        add(fmt::format("texture.coordinates.{}.mode", i), s.texture.coordinates[i].mode);
        add(fmt::format("texture.coordinates.{}.plane", i), s.texture.coordinates[i].plane);
    }
    add("texture.matrix", s.texture.matrix);
    add("texture.border_color", s.texture.border_color);
    add("texture.shadow_compare", s.texture.shadow_compare);
}

void add_stencil_face(const std::string& name, const auto& face, const auto& add) {
    add(name + ".func", face.func);
    add(name + ".ref", face.ref);
    add(name + ".mask", hex(face.mask));
    add(name + ".fail", face.fail);
    add(name + ".zfail", face.zfail);
    add(name + ".zpass", face.zpass);
    add(name + ".write_mask", hex(face.write_mask));
}

void add_fragment_operations(const State& s, const auto& add) {
    add("scissor.test", s.scissor.test);
    add("scissor.box", s.scissor.box);
    add("alpha.test", s.alpha.test);
    add("alpha.func", s.alpha.func);
    add("alpha.ref", s.alpha.ref);
    add("stencil.test", s.stencil.test);
    add_stencil_face("stencil", s.stencil, add);
    add("stencil.two_side", s.stencil.two_side);
    add_stencil_face("stencil.back", s.stencil.back, add);
    add("depth.test", s.depth.test);
    add("depth.func", s.depth.func);
    add("depth.mask", s.depth.mask);
    add("blend.enable", s.blend.enable);
    add("blend.src", s.blend.src);
    add("blend.dst", s.blend.dst);
    add("blend.equation", s.blend.equation);
    add("blend.color", s.blend.color);
    add("logic_op.enable", s.logic_op.enable);
    add("logic_op.op", s.logic_op.op);
    add("color_mask", s.color_mask);
    add("draw_buffer", s.draw_buffer);
    add("read_buffer", s.read_buffer);
}

}  // namespace

std::vector<Field> fields(const State& state) {
    std::vector<Field> all;
    const auto add = [&]<typename T>(std::string name, const T& value) {
        if constexpr (std::is_same_v<T, std::string>)
            all.push_back({std::move(name), value});
        else
            all.push_back({std::move(name), text(value)});
    };
    add_geometry(state, add);
    add_shading(state, add);
    add_fragment_operations(state, add);
    return all;
}

std::vector<Field> changed_fields(const State& before, const State& state) {
    const std::vector<Field> old = fields(before), now = fields(state);
    std::vector<Field> changed;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (old[i] != now[i]) changed.push_back(now[i]);
    return changed;
}

}  // namespace gw::inspect
