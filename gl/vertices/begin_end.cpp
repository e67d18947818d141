// Begin and End, the values of vertices, rectangles. [GL11] 2.6, 2.7, 2.9
#include "gl/vertices/begin_end.h"

#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// The index of the material of vertices that are added now. `is_first`: the mesh has none yet.
std::uint32_t material_index(Context& context, bool is_first) {
    Assembler& a = context.assembler;
    if (is_first || a.material_changed) [[unlikely]] {
        a.materials.push_back(face_materials(context));
        a.material_changed = false;
    }
    return static_cast<std::uint32_t>(a.materials.size() - 1);
}

}  // namespace

void add_vertex(Context& context, AssembledVertex v) {
    Assembler& a = context.assembler;
    if (!a.inside || !all_finite(v.position)) return;
    v.edge_and_material = material_index(context, a.mesh.empty()) << 1 | (v.edge_and_material & 1u);
    a.mesh.add(v);
    if (a.keeps_further_texcoords) [[unlikely]]
        a.mesh.further_texcoords.push_back(context.state.current.further_texcoords);
    if (calls_are_kept) [[unlikely]]
        a.run_calls.add(context.calls.now);
}

void add_vertices(Context& context, std::span<const AssembledVertex> added,
                  std::span<const FurtherTexcoords> further) {
    Assembler& a = context.assembler;
    const bool whole = std::all_of(added.begin(), added.end(),
                                   [](const auto& v) { return all_finite(v.position); });
    if (!a.inside || !whole) {
        const FurtherTexcoords kept = context.state.current.further_texcoords;
        for (std::size_t i = 0; i < added.size(); ++i) {
            if (!further.empty()) context.state.current.further_texcoords = further[i];
            add_vertex(context, added[i]);
        }
        context.state.current.further_texcoords = kept;
        return;
    }
    const std::uint32_t material = material_index(context, a.mesh.empty());
    a.mesh.add(added, material);
    auto& kept = a.mesh.further_texcoords;
    if (a.keeps_further_texcoords) kept.insert(kept.end(), further.begin(), further.end());
    if (calls_are_kept)
        for (std::size_t i = 0; i < added.size(); ++i) a.run_calls.add(context.calls.now);
}

namespace execute {

void begin(Context& context, GLenum mode) {
    Assembler& a = context.assembler;
    if (a.inside) return set_error(context, GL_INVALID_OPERATION);
    if (mode > GL_POLYGON) return set_error(context, GL_INVALID_ENUM);
    if (!can_draw(context)) return;
    const bool whole_strips = context.state.line.stipple || context.selection.mode == GL_FEEDBACK;
    if (!a.mesh.takes(mode, whole_strips)) flush_mesh(context);
    a.mesh.begin(mode, whole_strips);
    a.keeps_further_texcoords = context.state.texture.uses_further_units();
    if (calls_are_kept) a.run_calls.begin(mode, a.mesh);
    a.inside = true;
}

void end(Context& context) {
    if (!context.assembler.inside) return set_error(context, GL_INVALID_OPERATION);
    context.assembler.mesh.end();
    if (calls_are_kept) context.assembler.run_calls.end(context.assembler.mesh, context.calls.runs);
    context.assembler.inside = false;
}

void vertex(Context& context, float x, float y, float z, float w) {
    AssembledVertex v = current_vertex(context.state.current);
    v.position = {x, y, z, w};
    add_vertex(context, v);
}

void color(Context& context, float red, float green, float blue, float alpha) {
    context.state.current.color = finite(vec4(red, green, blue, alpha));
}
void secondary_color(Context& context, float red, float green, float blue) {
    context.state.current.secondary_color = vec3(finite(vec4(red, green, blue, 0)));
}
void fog_coord(Context& context, float coordinate) {
    context.state.current.fog_coordinate = finite(vec4(coordinate, 0, 0, 0)).x;
}
void tex_coord(Context& context, float s, float t, float r, float q) {
    context.state.current.texcoord = finite(vec4(s, t, r, q));
}
void multi_tex_coord(Context& context, GLenum texture, float s, float t, float r, float q) {
    const auto unit = unit_index(context.profile, texture);
    if (!unit) return set_error(context, GL_INVALID_ENUM);
    if (*unit == 0) return tex_coord(context, s, t, r, q);
    context.state.current.further_texcoords[*unit - 1] = finite(vec4(s, t, r, q));
}
void normal(Context& context, float x, float y, float z) {
    context.state.current.normal = vec3(finite(vec4(x, y, z, 0)));
}
void edge_flag(Context& context, GLboolean flag) {
    context.state.current.edge_flag = flag != GL_FALSE;
}
void index(Context& context, float value) { context.state.current.index = value; }

void rect(Context& context, double x1, double y1, double x2, double y2) {
    begin(context, GL_POLYGON);
    vertex(context, float(x1), float(y1), 0, 1);
    vertex(context, float(x2), float(y1), 0, 1);
    vertex(context, float(x2), float(y2), 0, 1);
    vertex(context, float(x1), float(y2), 0, 1);
    end(context);
}

}  // namespace execute

}  // namespace gw::gl
