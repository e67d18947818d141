#include "web/engine/recorded/frame_steps.h"

#include "inspect/replay/player.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace gw::lab {
namespace {

/// The corners of a primitive that shares none; 0: of a strip or a fan.
std::size_t corners_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::Points: return 1;
        case Primitive::Lines: return 2;
        case Primitive::Triangles: return 3;
        case Primitive::Quads: return 4;
        case Primitive::LineStrip:
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan:
        case Primitive::Polygons: return 0;
    }
    return 0;
}

bool can_be_cut(const MeshData& data) {
    return corners_of(data.primitive) != 0 || !data.polygon_sizes.empty();
}

/// The first corner of the primitive `number`.
std::size_t first_corner(const MeshData& data, std::size_t number) {
    if (const std::size_t corners = corners_of(data.primitive)) return number * corners;
    std::size_t first = 0;
    for (std::size_t i = 0; i < number; ++i) first += data.polygon_sizes[i];
    return first;
}

template <class Value>
std::vector<Value> chosen(const std::vector<Value>& all, const std::vector<std::size_t>& vertices) {
    std::vector<Value> some;
    if (!all.empty())
        for (const std::size_t vertex : vertices) some.push_back(all[vertex]);
    return some;
}

/// Primitives [from, end) of a mesh, with a vertex for each corner.
MeshRef part_of(const Mesh& mesh, std::size_t from, std::size_t end) {
    const MeshData& data = mesh.data();
    std::vector<std::size_t> vertices;
    for (std::size_t i = first_corner(data, from); i < first_corner(data, end); ++i)
        vertices.push_back(data.indices.empty() ? i : data.indices[i]);
    MeshData part{.primitive = data.primitive,
                  .positions = chosen(data.positions, vertices),
                  .normals = chosen(data.normals, vertices),
                  .texcoords = chosen(data.texcoords, vertices),
                  .colors = chosen(data.colors, vertices),
                  .w = chosen(data.w, vertices),
                  .texcoords_rq = chosen(data.texcoords_rq, vertices),
                  .edge_flags = chosen(data.edge_flags, vertices),
                  .materials = data.materials,
                  .material_indices = chosen(data.material_indices, vertices),
                  .secondary_colors = chosen(data.secondary_colors, vertices),
                  .fog_coordinates = chosen(data.fog_coordinates, vertices)};
    for (std::size_t unit = 0; unit < data.more_texcoords.size(); ++unit)
        part.more_texcoords[unit] = {chosen(data.more_texcoords[unit].st, vertices),
                                     chosen(data.more_texcoords[unit].rq, vertices)};
    for (std::size_t i = from; i < end; ++i) {
        if (!data.polygon_sizes.empty()) part.polygon_sizes.push_back(data.polygon_sizes[i]);
        part.polygon_ids.push_back(mesh.polygon_id(std::uint32_t(i)));
    }
    return make_mesh(std::move(part));
}

class StepMaker {
public:
    explicit StepMaker(std::size_t primitives_a_step) : most_(primitives_a_step) {
        list.add(BeginPass{.name = "before"});
    }
    void add(const Command& command) {
        std::visit([this](const auto& one) { take(one); }, command);
    }

    CommandList list;
    std::vector<FrameStep> steps;

private:
    using Kind = FrameStep::Kind;

    void begin(Kind kind) {
        steps.push_back({.kind = kind});
        primitives_ = 0;
        list.add(BeginPass{.name = "step " + std::to_string(steps.size())});
    }
    /// Commands of one kind in a row are one step.
    void go_on(Kind kind) {
        if (steps.empty() || steps.back().kind != kind) begin(kind);
    }

    void take(const BeginPass&) {}
    void take(const Clear& clear) {
        begin(Kind::Clear);
        list.add(clear);
    }
    void take(const SwapBuffers& swap) {
        begin(Kind::Shown);
        list.add(swap);
    }
    void take(const WritePixels& pixels) { take(Kind::Pixels, pixels); }
    void take(const WriteSpans& spans) { take(Kind::Pixels, spans); }
    void take(const DrawPixels& pixels) { take(Kind::Pixels, pixels); }
    void take(const Copy& copy) { take(Kind::Other, copy); }
    void take(const Accumulate& accumulate) { take(Kind::Other, accumulate); }
    void take(const Blit& blit) { take(Kind::Other, blit); }
    void take(Kind kind, const auto& command) {
        go_on(kind);
        list.add(command);
    }
    /// What changes no plane of the window.
    void take(const auto& command) { list.add(command); }

    void take(const Draw& draw) {
        const std::size_t count = draw.mesh->polygon_count();
        if (!can_be_cut(draw.mesh->data())) return take_part(draw, count);
        for (std::size_t from = 0; from < count;) {
            const std::size_t end = std::min(count, from + most_ - taken());
            Draw part = draw;
            if (end - from != count) part.mesh = part_of(*draw.mesh, from, end);
            take_part(part, end - from);
            from = end;
        }
    }
    /// Primitives of the step that goes on; fewer than most_.
    std::size_t taken() const {
        const bool goes_on = !steps.empty() && steps.back().kind == Kind::Primitives;
        return goes_on && primitives_ < most_ ? primitives_ : 0;
    }
    void take_part(const Draw& draw, std::size_t count) {
        go_on(Kind::Primitives);
        if (primitives_ >= most_) begin(Kind::Primitives);
        primitives_ += count;
        FrameStep& step = steps.back();
        switch (draw.mesh->kind()) {
            case MeshKind::Points: step.points += count; break;
            case MeshKind::Lines: step.lines += count; break;
            case MeshKind::Triangles: step.polygons += count; break;
        }
        list.add(draw);
    }

    std::size_t most_;
    std::size_t primitives_ = 0;  ///< of the last step
};

/// Calls `see` with the number of each command, and the command.
void for_each_command(const inspect::Recording& recording, const auto& see) {
    std::size_t number = 0;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) see(number++, command);
}

}  // namespace

FrameSteps steps_of(const inspect::Recording& recording, std::size_t pass, std::size_t most) {
    const inspect::PassRange range = inspect::pass_ranges(recording).at(pass);
    std::size_t primitives = 0;
    bool tests_depth = false;
    FrameSteps out;
    for_each_command(recording, [&](std::size_t number, const Command& command) {
        if (const auto* state = std::get_if<SetState>(&command))
            tests_depth = state->state->depth.test;
        if (number < range.first || number >= range.end) return;
        if (const auto* clear = std::get_if<Clear>(&command))
            out.uses_depth |= (clear->planes & mask_of(Plane::Depth)) != 0;
        out.uses_depth |= tests_depth && std::holds_alternative<Draw>(command);
        if (const auto* draw = std::get_if<Draw>(&command))
            primitives += draw->mesh->polygon_count();
        out.is_back |= std::holds_alternative<SwapBuffers>(command);
    });
    StepMaker maker(std::max<std::size_t>(1, (primitives + most - 1) / most));
    for_each_command(recording, [&](std::size_t number, const Command& command) {
        if (number >= range.first && number < range.end) return maker.add(command);
        if (number < range.first && !std::holds_alternative<BeginPass>(command))
            maker.list.add(command);
    });
    out.recording = {.producer = recording.producer,
                     .profile = recording.profile,
                     .width = recording.width,
                     .height = recording.height};
    out.recording.lists.push_back(std::move(maker.list));
    out.steps = std::move(maker.steps);
    return out;
}

}  // namespace gw::lab
