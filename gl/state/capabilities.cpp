#include "gl/state/capabilities.h"

#include "gl/state/texture_objects.h"

#include "gw/base/leaked_static.h"

#include <algorithm>
#include <vector>

namespace gw::gl {

namespace {

std::vector<Capability> make_capabilities() {
    std::vector<Capability> table{
        {GL_POINT_SMOOTH, [](State& s, int) -> bool& { return s.point.smooth; }},
        {GL_POINT_SPRITE, [](State& s, int) -> bool& { return s.point.sprite; }},
        {GL_LINE_SMOOTH, [](State& s, int) -> bool& { return s.line.smooth; }},
        {GL_LINE_STIPPLE, [](State& s, int) -> bool& { return s.line.stipple; }},
        {GL_CULL_FACE, [](State& s, int) -> bool& { return s.polygon.cull; }},
        {GL_POLYGON_SMOOTH, [](State& s, int) -> bool& { return s.polygon.smooth; }},
        {GL_POLYGON_STIPPLE, [](State& s, int) -> bool& { return s.polygon.stipple; }},
        {GL_POLYGON_OFFSET_POINT, [](State& s, int) -> bool& { return s.polygon.offset_point; }},
        {GL_POLYGON_OFFSET_LINE, [](State& s, int) -> bool& { return s.polygon.offset_line; }},
        {GL_POLYGON_OFFSET_FILL, [](State& s, int) -> bool& { return s.polygon.offset_fill; }},
        {GL_LIGHTING, [](State& s, int) -> bool& { return s.lighting.enable; }},
        {GL_COLOR_MATERIAL, [](State& s, int) -> bool& { return s.lighting.color_material; }},
        {GL_NORMALIZE, [](State& s, int) -> bool& { return s.transform.normalize; }},
        {GL_RESCALE_NORMAL, [](State& s, int) -> bool& { return s.transform.rescale_normal; }},
        {GL_FOG, [](State& s, int) -> bool& { return s.fog.enable; }},
        {GL_COLOR_SUM, [](State& s, int) -> bool& { return s.fog.color_sum; }},
        {GL_DEPTH_TEST, [](State& s, int) -> bool& { return s.depth.test; }},
        {GL_STENCIL_TEST, [](State& s, int) -> bool& { return s.stencil.test; }},
        {GL_ALPHA_TEST, [](State& s, int) -> bool& { return s.color_buffer.alpha_test; }},
        {GL_BLEND, [](State& s, int) -> bool& { return s.color_buffer.blend; }},
        {GL_DITHER, [](State& s, int) -> bool& { return s.color_buffer.dither; }},
        {GL_COLOR_LOGIC_OP, [](State& s, int) -> bool& { return s.color_buffer.logic_op; }},
        {GL_INDEX_LOGIC_OP, [](State& s, int) -> bool& { return s.color_buffer.index_logic_op; }},
        {GL_SCISSOR_TEST, [](State& s, int) -> bool& { return s.scissor.test; }},
        {GL_AUTO_NORMAL, [](State& s, int) -> bool& { return s.eval.auto_normal; }},
        {GL_MULTISAMPLE, [](State& s, int) -> bool& { return s.multisample.multisample; }},
        {GL_SAMPLE_ALPHA_TO_COVERAGE,
         [](State& s, int) -> bool& { return s.multisample.alpha_to_coverage; }},
        {GL_SAMPLE_ALPHA_TO_ONE, [](State& s, int) -> bool& { return s.multisample.alpha_to_one; }},
        {GL_SAMPLE_COVERAGE, [](State& s, int) -> bool& { return s.multisample.coverage; }},
        {GL_TEXTURE_CUBE_MAP_SEAMLESS, [](State& s, int) -> bool& { return s.texture.seamless; }, 0,
         &Extensions::texture_seamless}};
    const auto add = [&](GLenum first, int count, bool& (*field)(State&, int)) {
        for (int i = 0; i < count; ++i) table.push_back({first + GLenum(i), field, i});
    };
    const auto add_of_unit = [&](GLenum name, int i, bool& (*field)(State&, int),
                                 bool Extensions::*feature = nullptr) {
        table.push_back({name, field, i, feature, true});
    };
    add(GL_LIGHT0, light_count,
        [](State& s, int i) -> bool& { return s.lighting.lights[std::size_t(i)].enable; });
    add(GL_CLIP_PLANE0, 6,
        [](State& s, int i) -> bool& { return s.transform.clip_enable[std::size_t(i)]; });
    for (int i = 0; i < int(texture_target_count); ++i)
        add_of_unit(
            texture_targets[std::size_t(i)], i,
            [](State& s, int target) -> bool& {
                return s.texture.unit().enable[std::size_t(target)];
            },
            texture_target_features[std::size_t(i)]);
    for (int i = 0; i < 4; ++i)
        add_of_unit(GL_TEXTURE_GEN_S + GLenum(i), i, [](State& s, int coordinate) -> bool& {
            return s.texture.unit().gen[std::size_t(coordinate)].enable;
        });
    add(GL_MAP1_COLOR_4, map_count,
        [](State& s, int i) -> bool& { return s.eval.map1[std::size_t(i)]; });
    add(GL_MAP2_COLOR_4, map_count,
        [](State& s, int i) -> bool& { return s.eval.map2[std::size_t(i)]; });
    std::ranges::sort(table, {}, &Capability::name);
    return table;
}

}  // namespace

std::span<const Capability> capabilities() {
    static const std::vector<Capability>& table = leaked_static(make_capabilities());
    return table;
}

const Capability* find_capability(const Profile& profile, GLenum name) {
    const auto table = capabilities();
    const auto found = std::ranges::lower_bound(table, name, {}, &Capability::name);
    if (found == table.end() || found->name != name) return nullptr;
    return found->feature == nullptr || profile.extensions.*found->feature ? &*found : nullptr;
}

}  // namespace gw::gl
