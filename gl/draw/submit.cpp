#include "gl/draw/submit.h"

#include "gl/context/context.h"
#include "gl/draw/machine_state.h"
#include "gl/draw/report.h"
#include "gl/draw/targets.h"
#include "gw/base/leaked_static.h"

#include <algorithm>
#include <utility>

namespace gw::gl {

namespace {

std::shared_ptr<const CurrentValues> shared_values(const CurrentValues& values) {
    if (values == CurrentValues{}) return nullptr;
    return std::make_shared<const CurrentValues>(values);
}

/// Looks at unit 0, and at the others that have textures.
bool has_finite_texture_matrices(const Context& context) {
    for (std::size_t unit = 0; unit < texture_unit_count; ++unit)
        if ((unit == 0 || context.state.texture.units[unit].is_enabled()) &&
            !is_finite(context.matrices.texture[unit].top()))
            return false;
    return true;
}

/// Whether a draw can have pixels: products of matrices may overflow.
bool is_drawable(const Context& context) {
    return !is_empty(context.state.viewport) && is_finite(context.matrices.modelview.top()) &&
           is_finite(context.matrices.projection.top()) && has_finite_texture_matrices(context);
}

}  // namespace

void begin_change(Context& context, StateParts parts) {
    flush_mesh(context);
    context.translated.stale = context.translated.stale | parts;
    ++context.translated.changes;
}

void begin_change_of(Context& context, const void* field) {
    begin_change(context, parts_of(context.state, field));
}

FaceMaterials face_materials(const Context& context) {
    return {machine_material(context.state.lighting.material[0]),
            machine_material(context.state.lighting.material[1])};
}

namespace {

/// If the state before last has come back, so does its object.
void share_state(TranslatedState& t) {
    if (t.now == *t.state) return;
    std::swap(t.state, t.before);
    if (t.now != *t.state) t.state = t.now;
}

}  // namespace

void update_machine_state(Context& context) {
    TranslatedState& t = context.translated;
    if (t.stale == no_state_part) return;
    translate_state(context, t.stale, t.now);
    share_state(t);
    if ((t.stale & lighting_part) != 0) t.lights = machine_lights(context.state.lighting);
    t.stale = no_state_part;
}

TextureRef enabled_texture(Context& context, std::size_t unit) {
    const auto target = enabled_target(context.state.texture.units[unit]);
    if (!target) return nullptr;
    TextureObject& object = *context.textures.bound[unit][*target];
    if (!object.rendered.empty()) update_texels(context, object);
    TextureRef texture;
    std::size_t new_bytes = 0;
    {
        const auto lock = context.shared->exclusive();
        texture = machine_texture(object, *target, context.profile);
        if (texture) new_bytes = std::exchange(object.new_bytes, 0);
    }
    if (new_bytes != 0 && context.drawable != nullptr) context.drawable->hold(new_bytes);
    return texture;
}

std::shared_ptr<const MoreBindings> further_textures(Context& context) {
    static_assert(texture_unit_count == max_texture_units);
    if (!context.state.texture.uses_further_units()) return nullptr;
    MoreBindings out;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        out[unit - 1].texture = enabled_texture(context, unit);
    return std::make_shared<const MoreBindings>(std::move(out));
}

Draw make_draw(Context& context, MeshRef mesh, const AssembledVertex& values,
               const FurtherTexcoords& further, const FaceMaterials& materials) {
    Draw draw;
    draw.mesh = std::move(mesh);
    draw.eye_from_object = context.matrices.modelview.top();
    draw.material = materials.front;
    if (context.state.lighting.two_side)
        draw.back_material = std::make_shared<const gw::Material>(materials.back);
    draw.current = shared_values({values.color, values.normal, values.texcoord,
                                  values.secondary_color, values.fog_coordinate, further});
    draw.lights = context.translated.lights;
    if (context.framebuffers.draw) return draw;  // submit_command() knows the planes
    draw.map.texture = enabled_texture(context);
    draw.more_maps = further_textures(context);
    return draw;
}

Draw with_texture_coordinates(Draw draw) {
    static const TextureRef& any =
        leaked_static(make_texture("", 1, 1, std::vector<std::uint16_t>(4)));
    draw.map.texture = any;
    return draw;
}

std::vector<CallRun> present_call(const Context& context) {
    if (!calls_are_kept) return {};
    return {{.call = context.calls.now}};
}

bool submit_state(Context& context, std::span<const CallRun> calls) {
    if (context.drawable == nullptr) return false;
    update_machine_state(context);
    context.drawable->set_state(context.translated.state, calls);
    return true;
}

namespace {

/// The textures of a draw to a framebuffer object.
template <class Drawing>
void bind_planes(Context& context, Drawing& command) {
    command.map = plane_or_texels(context, 0);
    if (!context.state.texture.uses_further_units()) return;
    MoreBindings more;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        more[unit - 1] = plane_or_texels(context, unit);
    command.more_maps = std::make_shared<const MoreBindings>(std::move(more));
}

/// Makes the surface of the framebuffer object ready for a command.
void use_object(Context& context, Command& command) {
    use_draw_surface(context);
    if (auto* draw = std::get_if<Draw>(&command)) bind_planes(context, *draw);
    if (auto* pixels = std::get_if<gw::DrawPixels>(&command)) bind_planes(context, *pixels);
    use_draw_surface(context);  // texels may have been read meanwhile
    note_drawing(context);
}

}  // namespace

void submit_command(Context& context, Command command, std::vector<CallRun> calls) {
    if (context.drawable == nullptr) return;
    if (calls.empty()) calls = present_call(context);
    const TargetLock lock = lock_target(context, *context.drawable);
    if (context.framebuffers.draw) {
        if (!is_draw_complete(context)) return;
        use_object(context, command);
    }
    submit_state(context, std::span(calls).first(std::min<std::size_t>(calls.size(), 1)));
    context.drawable->add(std::move(command), calls);
}

void submit(Context& context, Draw draw, std::vector<CallRun> calls) {
    if (context.selection.mode != GL_RENDER) return report(context, draw);
    if (is_drawable(context)) submit_command(context, std::move(draw), std::move(calls));
}

void flush_mesh(Context& context) {
    Assembler& a = context.assembler;
    if (a.mesh.empty() || a.inside) return;
    update_machine_state(context);
    const AssembledVertex first = a.mesh.vertices.front();
    const FurtherTexcoords further = a.mesh.further_texcoords.empty()
                                         ? initial_further_texcoords
                                         : a.mesh.further_texcoords.front();
    MeshRef mesh = context.meshes.mesh_of(
        a.mesh, a.materials, used_values(context.state, context.selection.mode == GL_FEEDBACK));
    submit(context, make_draw(context, std::move(mesh), first, further, a.materials.front()),
           std::exchange(context.calls.runs, {}));
    a.clear();
}

}  // namespace gw::gl
