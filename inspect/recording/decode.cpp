// From untrusted bytes to a recording: FlatBuffers' verifier, then checks of our own, then gw's
// `validate`.
#include "gw/machine.h"
#include "inspect/recording/check_lists.h"
#include "inspect/recording/file_commands.h"
#include "inspect/recording/file_draws.h"
#include "inspect/recording/file_values.h"
#include "inspect/recording/part.h"
#include "inspect/recording/read_bytes.h"
#include "inspect/recording/recording.h"

#include <algorithm>
#include <optional>

namespace gw::inspect {
namespace {

using inspect::from_file;

class Decoder {
public:
    Decoder(const gwt::Recording& file, const Limits& limits, DecodedValues& values)
        : file_(file), limits_(limits), values_(values) {}
    Part decode();

private:
    /// The same bytes of a file may be referred to many times: the memory that they become counts.
    void charge(std::uint64_t bytes) {
        values_.charged += bytes;
        if (values_.charged > limits_.decoded_bytes)
            throw Error(fmt::format("commands, meshes and maps of more than {} MB; expected less",
                                    limits_.decoded_bytes >> 20));
    }
    std::string text(const flatbuffers::String* stored) {
        if (!stored) return "";
        charge(stored->size());
        return stored->str();
    }
    template <typename Ours, typename File>
    std::vector<Ours> structs(const flatbuffers::Vector<const File*>* stored) {
        std::vector<Ours> values;
        if (!stored) return values;
        charge(std::uint64_t{stored->size()} * sizeof(Ours));
        values.reserve(stored->size());
        for (const File* value : *stored) values.push_back(from_file(*value));
        return values;
    }
    template <typename T>
    std::vector<T> numbers(const flatbuffers::Vector<T>* stored) {
        if (!stored) return {};
        charge(std::uint64_t{stored->size()} * sizeof(T));
        return {stored->begin(), stored->end()};
    }
    template <typename T>
    const T& at(const std::vector<T>& values, std::uint32_t place, const char* what) const {
        if (place >= values.size())
            throw Error(fmt::format("{} {}; there are {}", what, place, values.size()));
        return values[place];
    }

    MeshRef mesh(const gwt::Mesh& m);
    TextureRef texture(const gwt::Texture& t);
    template <typename File>
    auto all(const flatbuffers::Vector<flatbuffers::Offset<File>>* stored, const char* what,
             const auto& decode_one);

    Command command(const gwt::BeginPass& c) { return BeginPass{text(c.name()), c.digests()}; }
    Command command(const gwt::Clear& c) {
        Clear clear{.planes = c.planes(), .depth = c.depth(), .stencil = c.stencil()};
        if (c.color()) clear.color = from_file(*c.color());
        if (c.accum()) clear.accum = from_file(*c.accum());
        return clear;
    }
    Command command(const gwt::SetState& c) { return SetState{at(states_, c.state(), "state")}; }
    TextureBinding binding(std::uint32_t texture, std::uint32_t slot, std::uint32_t surface,
                           gwt::Plane plane) const;
    std::shared_ptr<const MoreBindings> more_maps(const auto& command) const;
    Command command(const gwt::Draw& c);
    Command command(const gwt::WriteSpans& c) {
        return WriteSpans{structs<Span>(c.spans()), structs<Rgba>(c.colors()), c.depth()};
    }
    Command command(const gwt::WritePixels& c) {
        return WritePixels{rect_from_file(c.rect()), our_enum<Plane>(c.plane()),
                           structs<Rgba>(c.colors()), numbers(c.values()), c.depth()};
    }
    Command command(const gwt::Accumulate& c) {
        return Accumulate{our_enum<AccumOp>(c.op()), c.value()};
    }
    Command command(const gwt::Copy& c) {
        return Copy{our_enum<Plane>(c.plane()), rect_from_file(c.source()), c.x(), c.y()};
    }
    Command command(const gwt::CopyTexture& c) {
        return CopyTexture{c.slot(), our_enum<Plane>(c.plane()), rect_from_file(c.rect())};
    }
    Command command(const gwt::Read& c) {
        return Read{c.key(), our_enum<Plane>(c.plane()), rect_from_file(c.rect()), c.packed()};
    }
    Command command(const gwt::DrawPixels& c);
    Command command(const gwt::Query& c) { return Query{c.key(), c.begin()}; }
    Command command(const gwt::SwapBuffers&) { return SwapBuffers{}; }
    Command command(const auto& c) { return from_file(c); }
    Command command(gwt::CommandType type, const gwt::AnyCommand* stored);
    Recording heading();
    CommandList list(const gwt::CommandList& stored);
    CallTable calls(const gwt::CommandList& stored) {
        if (!stored.calls()) return {};
        charge(decoded_bytes(*stored.calls()));
        return from_file(*stored.calls(), stored.commands() ? stored.commands()->size() : 0);
    }
    std::optional<ColorMap> color_map(const gwt::CommandList& stored) {
        const gwt::ColorMap* const map = stored.color_map();
        if (map == nullptr) return {};
        if (map->entries()) charge(map->entries()->size() * sizeof(std::uint32_t));
        return from_file(*map);
    }

    const gwt::Recording& file_;
    const Limits& limits_;
    DecodedValues& values_;
    std::vector<LightsRef> light_sets_;
    std::vector<State> states_;
};

MeshRef Decoder::mesh(const gwt::Mesh& m) {
    MeshData data{.primitive = our_enum<Primitive>(m.primitive()),
                  .positions = structs<vec3>(m.positions()),
                  .normals = structs<vec3>(m.normals()),
                  .texcoords = structs<vec2>(m.texcoords()),
                  .colors = structs<vec4>(m.colors()),
                  .indices = numbers(m.indices()),
                  .polygon_sizes = numbers(m.polygon_sizes()),
                  .polygon_ids = numbers(m.polygon_ids()),
                  .w = numbers(m.w()),
                  .texcoords_rq = structs<vec2>(m.texcoords_rq()),
                  .edge_flags = numbers(m.edge_flags()),
                  .materials = structs<FaceMaterials>(m.materials()),
                  .material_indices = numbers(m.material_indices()),
                  .secondary_colors = structs<vec3>(m.secondary_colors()),
                  .fog_coordinates = numbers(m.fog_coordinates())};
    if (has_more(m.more_texcoords(), "units of a mesh"))
        for (unsigned i = 0; i < data.more_texcoords.size(); ++i) {
            const gwt::UnitTexcoords& unit = *m.more_texcoords()->Get(i);
            data.more_texcoords[i] = {structs<vec2>(unit.st()), structs<vec2>(unit.rq())};
        }
    charge(sizeof(Mesh) + std::max(data.positions.size(), data.indices.size()) * sizeof(Triangle));
    return make_mesh(std::move(data));
}

TextureRef Decoder::texture(const gwt::Texture& t) {
    const std::vector<std::uint8_t> texels8 = numbers(t.texels8());
    const std::vector<std::uint16_t> texels16 = numbers(t.texels16());
    if (!texels8.empty() && !texels16.empty())
        throw Error("both texels8 and texels16; expected one of them");
    charge((texels8.size() + texels16.size()) * 4);  // its levels, and the machine's
    if (t.level_count() != 0) return given_texture(t, text(t.name()), texels8, texels16);
    if (t.format() != gwt::TextureFormat::RGBA || t.dimensions() != 2 || t.border() ||
        t.layers() != 1 || t.cube() || t.depths())
        throw Error(
            "a format, one dimension or a border without given levels; expected level_count 1 "
            "or more");
    if (!texels16.empty())
        return make_whole_texture(text(t.name()), t.width(), t.height(), texels16, t.srgb());
    std::vector<std::uint16_t> wide;
    for (const std::uint8_t v : texels8) wide.push_back(static_cast<std::uint16_t>(257 * v));
    return make_whole_texture(text(t.name()), t.width(), t.height(), wide, t.srgb());
}

Command Decoder::command(const gwt::Draw& c) {
    Draw draw{.mesh = at(values_.meshes, c.mesh(), "mesh"),
              .id_base = c.id_base(),
              .id_shift = c.id_shift()};
    if (c.eye_from_object()) draw.eye_from_object = from_file(*c.eye_from_object());
    if (c.material()) draw.material = from_file(*c.material());
    if (c.back_material())
        draw.back_material = std::make_shared<const Material>(from_file(*c.back_material()));
    draw.current = current_values(c);
    if (c.lights() != no_place) draw.lights = at(light_sets_, c.lights(), "lights");
    draw.map = binding(c.texture(), c.slot(), c.surface(), c.surface_plane());
    draw.more_maps = more_maps(c);
    return draw;
}

Command Decoder::command(const gwt::DrawPixels& c) {
    DrawPixels draw{.width = c.width(),
                    .height = c.height(),
                    .zoom_x = c.zoom_x(),
                    .zoom_y = c.zoom_y(),
                    .colors = structs<Rgba>(c.colors()),
                    .depths = numbers(c.depths()),
                    .stencils = numbers(c.stencils()),
                    .bits = numbers(c.bits())};
    draw.raster = raster_position(c);
    if (c.source()) draw.source = from_file(*c.source());
    draw.map = binding(c.texture(), c.slot(), c.surface(), c.surface_plane());
    draw.more_maps = more_maps(c);
    return draw;
}

/// Of places in the file; no_place for none.
TextureBinding Decoder::binding(std::uint32_t texture, std::uint32_t slot, std::uint32_t surface,
                                gwt::Plane plane) const {
    if (texture != no_place && slot != no_place)
        throw Error("both a texture and a slot; expected one of them");
    TextureBinding map;
    if (texture != no_place) map.texture = at(values_.textures, texture, "texture");
    if (slot != no_place) map.slot = slot;
    if (surface != no_place) map.surface = {surface, our_enum<Plane>(plane)};
    return map;
}

std::shared_ptr<const MoreBindings> Decoder::more_maps(const auto& c) const {
    const bool textures = has_more(c.more_textures(), "textures of units"),
               slots = has_more(c.more_slots(), "slots of units"),
               surfaces = has_more(c.more_surfaces(), "surfaces of units"),
               planes = has_more(c.more_surface_planes(), "planes of units");
    if (!textures && !slots && !surfaces) return nullptr;
    MoreBindings maps;
    for (unsigned i = 0; i < maps.size(); ++i)
        maps[i] = binding(textures ? c.more_textures()->Get(i) : no_place,
                          slots ? c.more_slots()->Get(i) : no_place,
                          surfaces ? c.more_surfaces()->Get(i) : no_place,
                          planes ? c.more_surface_planes()->Get(i) : gwt::Plane::Color);
    return std::make_shared<const MoreBindings>(maps);
}

Command Decoder::command(gwt::CommandType type, const gwt::AnyCommand* stored) {
    Command result;
    if (!with_command(type, stored, [&](const auto& c) { result = command(c); }))
        throw Error(fmt::format("of the unknown kind {}", int(type)));
    return result;
}

/// Decodes every element; an error names which one it is.
template <typename File>
auto Decoder::all(const flatbuffers::Vector<flatbuffers::Offset<File>>* stored, const char* what,
                  const auto& decode_one) {
    std::vector<decltype(decode_one(*stored->Get(0)))> values;
    if (!stored) return values;
    charge(std::uint64_t{stored->size()} * sizeof(values[0]));
    for (unsigned i = 0; i < stored->size(); ++i) {
        try {
            values.push_back(decode_one(*stored->Get(i)));
        } catch (const Error& error) {
            throw Error(fmt::format("{} {}: {}", what, i, error.what()));
        }
    }
    return values;
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& values) {
    to.insert(to.end(), values.begin(), values.end());
}

CommandList Decoder::list(const gwt::CommandList& stored) {
    CommandList result;
    if (!stored.commands()) return result;
    const auto& commands = *stored.commands();
    const auto* types = stored.commands_type();
    charge(std::uint64_t{commands.size()} * sizeof(Command));
    result.commands.reserve(commands.size());
    for (unsigned i = 0; i < commands.size(); ++i) {
        const auto type = static_cast<gwt::CommandType>(types->Get(i));
        try {
            result.add(command(type, commands.Get(i)));
        } catch (const Error& error) {
            throw Error(fmt::format("command {} ({}): {}", i, gwt::EnumNameCommandType(type),
                                    error.what()));
        }
    }
    return result;
}

/// All that a machine begins with.
Recording Decoder::heading() {
    if (!file_.profile()) throw Error("a recording without a profile");
    Recording r{.producer = text(file_.producer()),
                .scene = text(file_.scene()),
                .renderer = text(file_.renderer()),
                .profile = from_file(*file_.profile()),
                .width = file_.width(),
                .height = file_.height()};
    r.profile.name = text(file_.profile()->name());
    validate(r.profile);
    check_window(r.width, r.height);
    r.sets = all(file_.sets(), "parameter set", [this](const gwt::ParameterSet& s) {
        return ParameterSet{text(s.pass()), text(s.set())};
    });
    return r;
}

Part Decoder::decode() {
    if (file_.version() < 1 || file_.version() > newest_version)
        throw Error(fmt::format("a recording of version {}; expected version 1 to {}",
                                file_.version(), newest_version));
    Part part{.window = text(file_.window()), .event = our_enum<WindowEvent>(file_.event())};
    Recording r;
    if (part.window.empty() || part.event == WindowEvent::Open) r = heading();
    append(values_.meshes,
           all(file_.meshes(), "mesh", [this](const gwt::Mesh& m) { return mesh(m); }));
    append(values_.textures,
           all(file_.textures(), "texture", [this](const gwt::Texture& t) { return texture(t); }));
    light_sets_ = all(file_.light_sets(), "lights", [this](const gwt::Lights& l) {
        return LightsRef(std::make_shared<const std::vector<Light>>(structs<Light>(l.lights())));
    });
    states_ = all(file_.states(), "state", [](const gwt::State& s) { return from_file(s); });
    r.lists = all(file_.lists(), "list", [this](const gwt::CommandList& l) { return list(l); });
    r.calls = all(file_.lists(), "list", [this](const gwt::CommandList& l) { return calls(l); });
    r.color_maps =
        all(file_.lists(), "list", [this](const gwt::CommandList& l) { return color_map(l); });
    part.recording = std::move(r);
    return part;
}

/// Bytes that begin anywhere in memory.
Part decoded(std::span<const std::uint8_t> bytes, DecodedValues& values, const Limits& limits) {
    constexpr std::size_t identifier_end = 8, alignment = 8;
    if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignment != 0)
        return decoded(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), values, limits);
    if (bytes.size() < identifier_end || !gwt::RecordingBufferHasIdentifier(bytes.data()))
        throw Error("not a recording; expected a file that gw record wrote");
    if (!is_whole(bytes))
        throw Error(
            "a recording that is cut short or damaged; expected a file as gw record wrote it");
    return Decoder(*gwt::GetRecording(bytes.data()), limits, values).decode();
}

}  // namespace

std::vector<std::uint8_t> read_recording_bytes(const std::filesystem::path& file) {
    return read_bytes(file, {[](std::string_view bytes) { return has_identifier(bytes, "GWT1"); },
                             "not a recording; expected a file that gw record wrote"});
}

Recording decode(std::span<const std::uint8_t> bytes, const Limits& limits) {
    DecodedValues values;
    Part part = decoded(bytes, values, limits);
    if (!part.window.empty()) throw Error("a part of a stream; expected a whole recording");
    check_lists(part.recording, limits);
    return std::move(part.recording);
}

Part decode_part(std::span<const std::uint8_t> bytes, DecodedValues& values, const Limits& limits) {
    return decoded(bytes, values, limits);
}

}  // namespace gw::inspect
