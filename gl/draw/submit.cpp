#include "gl/draw/submit.h"

#include "gl/context/context.h"
#include "gl/draw/machine_state.h"
#include "gl/draw/report.h"
#include "gw/base/leaked_static.h"

#include <algorithm>
#include <utility>

namespace gw::gl {

namespace {

std::shared_ptr<const CurrentValues> shared_values(const CurrentValues& values) {
    if (values == CurrentValues{}) return nullptr;
    return std::make_shared<const CurrentValues>(values);
}

/// Whether a draw can have pixels: products of matrices may overflow.
bool is_drawable(const Context& c) {
    return !is_empty(c.state.viewport) && is_finite(c.matrices.modelview.top()) &&
           is_finite(c.matrices.projection.top()) && is_finite(c.matrices.texture.top());
}

}  // namespace

void begin_change(Context& c) {
    flush_mesh(c);
    c.translated.changed = true;
}

FaceMaterials face_materials(const Context& c) {
    return {machine_material(c.state.lighting.material[0]),
            machine_material(c.state.lighting.material[1])};
}

void update_machine_state(Context& c) {
    if (!c.translated.changed) return;
    c.translated.state = machine_state(c);
    c.translated.lights = machine_lights(c.state.lighting);
    c.translated.changed = false;
}

TextureRef enabled_texture(Context& c) {
    const auto& enable = c.state.texture.enable;
    if (!enable[0] && !enable[1]) return nullptr;
    const std::size_t target = enable[1] ? 1 : 0;
    TextureObject& object = *c.textures.bound[target];
    TextureRef texture;
    std::size_t new_bytes = 0;
    {
        const auto lock = c.shared->exclusive();
        texture = machine_texture(object, target, c.profile);
        if (texture) new_bytes = std::exchange(object.new_bytes, 0);
    }
    if (new_bytes != 0 && c.drawable != nullptr) c.drawable->hold(new_bytes);
    return texture;
}

Draw make_draw(Context& c, MeshRef mesh, const AssembledVertex& values,
               const FaceMaterials& materials) {
    Draw draw;
    draw.mesh = std::move(mesh);
    draw.eye_from_object = c.matrices.modelview.top();
    draw.material = materials.front;
    if (c.state.lighting.two_side)
        draw.back_material = std::make_shared<const gw::Material>(materials.back);
    draw.current = shared_values({values.color, values.normal, values.texcoord});
    draw.lights = c.translated.lights;
    draw.map.texture = enabled_texture(c);
    return draw;
}

Draw with_texture_coordinates(Draw draw) {
    static const TextureRef& any =
        leaked_static(make_texture("", 1, 1, std::vector<std::uint16_t>(4)));
    draw.map.texture = any;
    return draw;
}

std::vector<CallRun> present_call(const Context& c) {
    if (!calls_are_kept) return {};
    return {{.call = c.calls.now}};
}

bool submit_state(Context& c, std::span<const CallRun> calls) {
    if (c.drawable == nullptr) return false;
    update_machine_state(c);
    c.drawable->set_state(c.translated.state, calls);
    return true;
}

void submit_command(Context& c, Command command, std::vector<CallRun> calls) {
    if (c.drawable == nullptr) return;
    if (calls.empty()) calls = present_call(c);
    const auto lock = c.drawable->exclusive();
    submit_state(c, std::span(calls).first(std::min<std::size_t>(calls.size(), 1)));
    c.drawable->add(std::move(command), calls);
}

void submit(Context& c, Draw draw, std::vector<CallRun> calls) {
    if (c.selection.mode != GL_RENDER) return report(c, draw);
    if (is_drawable(c)) submit_command(c, std::move(draw), std::move(calls));
}

void flush_mesh(Context& c) {
    Assembler& a = c.assembler;
    if (a.mesh.empty() || a.inside) return;
    update_machine_state(c);
    const AssembledVertex first = a.mesh.vertices.front();
    MeshRef mesh = c.meshes.mesh_of(a.mesh, a.materials,
                                    used_values(c.state, c.selection.mode == GL_FEEDBACK));
    submit(c, make_draw(c, std::move(mesh), first, a.materials.front()),
           std::exchange(c.calls.runs, {}));
    a.clear();
}

}  // namespace gw::gl
