// From a recording to bytes: meshes, maps, lights and states once each, then the commands.
#include "inspect/recording/content.h"
#include "inspect/recording/file_draws.h"
#include "inspect/recording/file_values.h"
#include "inspect/recording/part.h"

#include <algorithm>

namespace gw::inspect {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

/// Space for the builder's additions to an array: its length, alignment, tables around it.
constexpr std::uint64_t largest_file = (std::uint64_t{1} << 31) - (1 << 20);

/// Whether it has what version 1 has not.
bool is_of_version_2(const Texture& t) { return t.given_levels || t.srgb; }

class Encoder {
public:
    explicit Encoder(StoredValues& stored) : stored_(stored) {}
    /// `window` empty: a whole recording.
    std::vector<std::uint8_t> encode(const Recording& recording, const std::string& window = "",
                                     WindowEvent event = {});

private:
    void need(std::uint64_t bytes) const {
        if (out_.GetSize() + bytes > largest_file)
            throw Error(
                "a recording of more than 2 GB; expected less: a smaller window or fewer samples");
    }

    template <typename File, typename T>
    auto structs(const std::vector<T>& values) {
        need(values.size() * sizeof(File));
        return values.empty()
                   ? Offset<flatbuffers::Vector<const File*>>()
                   : out_.CreateVectorOfStructs<File>(
                         values.size(), [&](std::size_t i, File* to) { *to = to_file(values[i]); });
    }
    template <typename T>
    auto numbers(const std::vector<T>& values) {
        need(values.size() * sizeof(T));
        return values.empty() ? Offset<flatbuffers::Vector<T>>() : out_.CreateVector(values);
    }

    std::uint32_t mesh(const MeshRef& ref);
    std::uint32_t texture(const TextureRef& ref);
    std::uint32_t texture(const TextureBinding& map) {
        return map.texture ? texture(map.texture) : no_place;
    }
    /// Of units 1 to 3; none if they are off.
    struct MorePlaces {
        std::vector<std::uint32_t> textures, slots, surfaces;
        std::vector<gwt::Plane> planes;
        std::vector<vec4> texcoords;
    };
    MorePlaces more(const std::shared_ptr<const MoreBindings>& maps,
                    const MoreTexcoords& texcoords);
    Offset<flatbuffers::Vector<Offset<gwt::UnitTexcoords>>> more_texcoords(const MeshData& m);
    std::uint32_t lights(const LightsRef& ref);
    std::uint32_t state(const State& state);

    Offset<void> command(const BeginPass& c) {
        return gwt::CreateBeginPass(out_, out_.CreateString(c.name), c.digests).Union();
    }
    Offset<void> command(const Clear& c) {
        const auto color = to_file(c.color), accum = to_file(c.accum);
        const bool is_plain = c.accum == vec4(0);
        uses_version_2_ = uses_version_2_ || !is_plain;
        return gwt::CreateClear(out_, c.planes, &color, c.depth, c.stencil,
                                is_plain ? nullptr : &accum)
            .Union();
    }
    Offset<void> command(const SetState& c) {
        return gwt::CreateSetState(out_, state(c.state)).Union();
    }
    Offset<void> command(const Draw& c);
    Offset<void> command(const WriteSpans& c) {
        const auto spans = structs<gwt::Span>(c.spans);
        return gwt::CreateWriteSpans(out_, spans, structs<gwt::Rgba>(c.colors), c.depth).Union();
    }
    Offset<void> command(const WritePixels& c) {
        const auto rect = to_file(c.rect);
        const auto colors = structs<gwt::Rgba>(c.colors);
        return gwt::CreateWritePixels(out_, &rect, file_enum<gwt::Plane>(c.plane), colors,
                                      numbers(c.values), c.depth)
            .Union();
    }
    Offset<void> command(const Accumulate& c) {
        return gwt::CreateAccumulate(out_, file_enum<gwt::AccumOp>(c.op), c.value).Union();
    }
    Offset<void> command(const Copy& c) {
        const auto source = to_file(c.source);
        return gwt::CreateCopy(out_, file_enum<gwt::Plane>(c.plane), &source, c.x, c.y).Union();
    }
    Offset<void> command(const CopyTexture& c) {
        const auto rect = to_file(c.rect);
        return gwt::CreateCopyTexture(out_, c.slot, file_enum<gwt::Plane>(c.plane), &rect).Union();
    }
    Offset<void> command(const Read& c) {
        const auto rect = to_file(c.rect);
        return gwt::CreateRead(out_, c.key, file_enum<gwt::Plane>(c.plane), &rect, c.packed)
            .Union();
    }
    Offset<void> command(const DrawPixels& c);
    Offset<void> command(const Query& c) {
        uses_version_2_ = true;
        return gwt::CreateQuery(out_, c.key, c.begin).Union();
    }
    Offset<void> command(const SwapBuffers&) { return gwt::CreateSwapBuffers(out_).Union(); }
    Offset<void> command(const MakeSurface& c) {
        const Surface& s = c.surface;
        return gwt::CreateMakeSurface(out_, c.number, s.width, s.height, s.planes, s.depth_bits,
                                      s.samples)
            .Union();
    }
    Offset<void> command(const UseSurface& c) {
        return gwt::CreateUseSurface(out_, c.number).Union();
    }
    Offset<void> command(const Blit& c) {
        const auto source = to_file(c.source), target = to_file(c.target);
        return gwt::CreateBlit(out_, c.from_surface, c.planes, &source, &target, c.flip_x, c.flip_y,
                               file_enum<gwt::MagFilter>(c.filter))
            .Union();
    }
    Offset<gwt::CommandList> list(const Recording& r, std::size_t i);
    Offset<gwt::Profile> profile(const Profile& p);
    std::uint32_t version(const Profile& profile) const;

    FlatBufferBuilder out_{1 << 16};
    StoredValues& stored_;
    std::vector<Offset<gwt::Mesh>> meshes_;
    std::vector<Offset<gwt::Texture>> textures_;
    std::vector<std::vector<Light>> light_sets_;
    std::vector<State> states_;
    bool uses_version_2_ = false;  ///< in a mesh or a command
};

std::uint32_t Encoder::mesh(const MeshRef& ref) {
    const auto [place, is_new] =
        stored_.meshes.place(ref, [](const Mesh& mesh) { return content(mesh.data()); });
    if (!is_new) return place;
    const MeshData& m = ref->data();
    const auto positions = structs<gwt::Vec3>(m.positions);
    const auto normals = structs<gwt::Vec3>(m.normals);
    const auto texcoords = structs<gwt::Vec2>(m.texcoords);
    const auto colors = structs<gwt::Vec4>(m.colors);
    const auto indices = numbers(m.indices);
    const auto sizes = numbers(m.polygon_sizes);
    const auto ids = numbers(m.polygon_ids);
    const auto w = numbers(m.w);
    const auto texcoords_rq = structs<gwt::Vec2>(m.texcoords_rq);
    const auto edge_flags = numbers(m.edge_flags);
    const auto materials = structs<gwt::FaceMaterials>(m.materials);
    const auto material_indices = numbers(m.material_indices);
    const auto secondary_colors = structs<gwt::Vec3>(m.secondary_colors);
    const auto fog_coordinates = numbers(m.fog_coordinates);
    const auto more = more_texcoords(m);
    meshes_.push_back(gwt::CreateMesh(out_, file_enum<gwt::Primitive>(m.primitive), positions,
                                      normals, texcoords, colors, indices, sizes, ids, w,
                                      texcoords_rq, edge_flags, materials, material_indices,
                                      secondary_colors, fog_coordinates, more));
    uses_version_2_ = uses_version_2_ || !w.IsNull() || !texcoords_rq.IsNull() ||
                      !edge_flags.IsNull() || !material_indices.IsNull() ||
                      !secondary_colors.IsNull() || !fog_coordinates.IsNull() || !more.IsNull();
    return place;
}

Offset<flatbuffers::Vector<Offset<gwt::UnitTexcoords>>> Encoder::more_texcoords(const MeshData& m) {
    if (std::ranges::all_of(m.more_texcoords, [](const auto& unit) { return unit.st.empty(); }))
        return {};
    std::vector<Offset<gwt::UnitTexcoords>> units;
    for (const UnitTexcoords& unit : m.more_texcoords) {
        const auto st = structs<gwt::Vec2>(unit.st), rq = structs<gwt::Vec2>(unit.rq);
        units.push_back(gwt::CreateUnitTexcoords(out_, st, rq));
    }
    return out_.CreateVector(units);
}

std::uint32_t surface_of(const TextureBinding& map) {
    return map.surface ? map.surface->surface : no_place;
}
gwt::Plane plane_of(const TextureBinding& map) {
    return file_enum<gwt::Plane>(map.surface ? map.surface->plane : Plane::Color);
}

Encoder::MorePlaces Encoder::more(const std::shared_ptr<const MoreBindings>& maps,
                                  const MoreTexcoords& texcoords) {
    MorePlaces places;
    if (maps)
        for (const TextureBinding& map : *maps) {
            places.textures.push_back(texture(map));
            places.slots.push_back(map.slot.value_or(no_place));
        }
    const auto is_plane = [](const TextureBinding& map) { return map.surface.has_value(); };
    if (maps && std::any_of(maps->begin(), maps->end(), is_plane))
        for (const TextureBinding& map : *maps) {
            places.surfaces.push_back(surface_of(map));
            places.planes.push_back(plane_of(map));
        }
    if (texcoords != initial_texcoords) places.texcoords.assign(texcoords.begin(), texcoords.end());
    uses_version_2_ = uses_version_2_ || maps || !places.texcoords.empty();
    return places;
}

std::uint32_t Encoder::texture(const TextureRef& ref) {
    const auto [place, is_new] =
        stored_.textures.place(ref, [](const Texture& t) { return content(t); });
    if (!is_new) return place;
    const TextureLevel& level = ref->levels.front();
    std::vector<std::uint16_t> texels16 = level.rgba;
    if (ref->given_levels)
        for (std::size_t i = 1; i < ref->levels.size(); ++i)
            texels16.insert(texels16.end(), ref->levels[i].rgba.begin(), ref->levels[i].rgba.end());
    const bool bytes =
        std::all_of(texels16.begin(), texels16.end(), [](std::uint16_t v) { return v % 257 == 0; });
    std::vector<std::uint8_t> texels8;
    if (bytes)
        for (const std::uint16_t v : texels16)
            texels8.push_back(static_cast<std::uint8_t>(v / 257));
    const auto name = out_.CreateString(ref->name);
    const auto stored8 = numbers(texels8);
    const auto stored16 = numbers(bytes ? std::vector<std::uint16_t>() : texels16);
    uses_version_2_ = uses_version_2_ || is_of_version_2(*ref);
    textures_.push_back(gwt::CreateTexture(
        out_, name, level.width, level.height, stored8, stored16,
        ref->given_levels ? int(ref->levels.size()) : 0, file_enum<gwt::TextureFormat>(ref->format),
        ref->dimensions, ref->border, ref->srgb, ref->dimensions == 3 ? level.layers : 1, ref->cube,
        ref->depths));
    return place;
}

/// The place of an equal value among the last ones stored; if there is none, it is stored. Looking
/// farther back would cost more than it saves.
template <typename T>
std::uint32_t place_of(std::vector<T>& stored, const T& value) {
    constexpr std::ptrdiff_t farthest = 64;
    const auto end = stored.rbegin() + std::min(std::ptrdiff_t(stored.size()), farthest);
    const auto found = std::find(stored.rbegin(), end, value);
    if (found != end) return static_cast<std::uint32_t>(stored.rend() - found - 1);
    stored.push_back(value);
    return static_cast<std::uint32_t>(stored.size() - 1);
}

std::uint32_t Encoder::lights(const LightsRef& ref) { return place_of(light_sets_, *ref); }
std::uint32_t Encoder::state(const State& state) { return place_of(states_, state); }

bool is_affine(const Draw& c) {
    const dmat4& m = c.eye_from_object;
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

Offset<void> Encoder::command(const Draw& c) {
    const std::uint32_t mesh_place = mesh(c.mesh);
    const std::uint32_t lights_place = c.lights ? lights(c.lights) : no_place;
    const std::uint32_t texture_place = texture(c.map);
    const std::uint32_t slot = c.map.slot.value_or(no_place);
    const auto matrix = to_file(c.eye_from_object);
    const auto material = to_file(c.material);
    gwt::Material back;
    gwt::CurrentValues current;
    if (c.back_material) back = to_file(*c.back_material);
    const CurrentValues values = c.current ? *c.current : CurrentValues();
    if (c.current) current = to_file(values);
    const auto secondary = to_file(values.secondary_color);
    const bool has_secondary = values.secondary_color != vec3(0);
    uses_version_2_ = uses_version_2_ || c.back_material || c.current || !is_affine(c);
    const MorePlaces places =
        more(c.more_maps, c.current ? c.current->more_texcoords : initial_texcoords);
    const auto more_textures = numbers(places.textures), more_slots = numbers(places.slots),
               more_surfaces = numbers(places.surfaces);
    const auto more_planes = numbers(places.planes);
    const auto more_texcoords = structs<gwt::Vec4>(places.texcoords);
    return gwt::CreateDraw(out_, mesh_place, &matrix, &material, lights_place, texture_place, slot,
                           c.id_base, c.id_shift, c.back_material ? &back : nullptr,
                           c.current ? &current : nullptr, has_secondary ? &secondary : nullptr,
                           values.fog_coordinate, more_textures, more_slots, more_texcoords,
                           surface_of(c.map), plane_of(c.map), more_surfaces, more_planes)
        .Union();
}

Offset<void> Encoder::command(const DrawPixels& c) {
    uses_version_2_ = true;
    const auto colors = structs<gwt::Rgba>(c.colors);
    const auto depths = numbers(c.depths), stencils = numbers(c.stencils);
    const auto bits = numbers(c.bits);
    const std::uint32_t texture_place = texture(c.map);
    const MorePlaces places = more(c.more_maps, c.raster.more_texcoords);
    const auto more_textures = numbers(places.textures), more_slots = numbers(places.slots),
               more_surfaces = numbers(places.surfaces);
    const auto more_planes = numbers(places.planes);
    const auto more_texcoords = structs<gwt::Vec4>(places.texcoords);
    const auto raster = to_file(c.raster);
    const auto secondary = to_file(c.raster.secondary_color);
    const bool has_secondary = c.raster.secondary_color != Rgba{};
    gwt::PixelSource source;
    if (c.source) source = {file_enum<gwt::Plane>(c.source->plane), c.source->x, c.source->y};
    return gwt::CreateDrawPixels(out_, c.width, c.height, &raster, c.zoom_x, c.zoom_y, colors,
                                 depths, stencils, bits, c.source ? &source : nullptr,
                                 texture_place, c.map.slot.value_or(no_place),
                                 has_secondary ? &secondary : nullptr, c.raster.fog_coordinate,
                                 more_textures, more_slots, more_texcoords, surface_of(c.map),
                                 plane_of(c.map), more_surfaces, more_planes)
        .Union();
}

Offset<gwt::CommandList> Encoder::list(const Recording& r, std::size_t i) {
    std::vector<gwt::CommandType> types;
    std::vector<Offset<gwt::AnyCommand>> commands;
    for (const Command& c : r.lists[i].commands) {
        need(sizeof(gwt::Matrix) + 256);
        types.push_back(static_cast<gwt::CommandType>(c.index() + 1));  // CommandType's 0 is NONE
        commands.emplace_back(
            std::visit([this](const auto& value) { return command(value); }, c).o);
    }
    const auto stored_types = out_.CreateVector(types);
    const auto stored_commands = out_.CreateVector(commands);
    Offset<gwt::CallTable> calls;
    if (i < r.calls.size()) {
        need(r.calls[i].runs.size() * sizeof(gwt::CallRun));
        calls = to_file(out_, r.calls[i]);
    }
    Offset<gwt::ColorMap> map;
    if (i < r.color_maps.size() && r.color_maps[i]) {
        need(r.color_maps[i]->entries.size() * sizeof(std::uint32_t));
        map = to_file(out_, *r.color_maps[i]);
    }
    return gwt::CreateCommandList(out_, stored_types, stored_commands, calls, map);
}

Offset<gwt::Profile> Encoder::profile(const Profile& p) {
    const Extensions& e = p.extensions;
    return gwt::CreateProfile(
        out_, out_.CreateString(p.name), p.color_bits, p.depth_bits, p.stencil_bits, p.accum_bits,
        p.subpixel_bits, p.lit_bits, p.max_lights, p.fragment_fog, p.perspective_color,
        e.polygon_offset, e.shadow_texture, e.stencil_wrap, e.two_sided_stencil, p.texel_bits,
        e.texture_border, e.texture_formats, e.stipple, e.two_sided_polygon_mode, e.logic_op,
        e.blend_color, e.blend_minmax, e.blend_subtract, e.draw_pixels, p.coverage_bits,
        p.color_planes, e.blend_separate, e.blend_square, e.texture_sizes, e.texture_wraps,
        e.texture_lod, e.texture_combine, e.texture_srgb, e.secondary_color, e.fog_coordinate,
        e.occlusion_query, e.clip_control, e.texture_units, e.texture_depth, e.texture_cube,
        e.texture_seamless, e.texture_3d, e.surfaces, e.point_parameters, e.point_sprite,
        e.multisample);
}

std::uint32_t Encoder::version(const Profile& profile) const {
    const bool second = uses_version_2_ || needs_version_2(profile) ||
                        std::any_of(states_.begin(), states_.end(),
                                    [](const State& s) { return inspect::needs_version_2(s); });
    return second ? 2 : 1;
}

std::vector<std::uint8_t> Encoder::encode(const Recording& r, const std::string& window,
                                          WindowEvent event) {
    uses_version_2_ = !window.empty();
    static_assert(std::variant_size_v<Command> == std::size_t(gwt::CommandType::MAX));
    std::vector<Offset<gwt::CommandList>> lists;
    for (std::size_t i = 0; i < r.lists.size(); ++i) lists.push_back(list(r, i));
    std::vector<Offset<gwt::State>> states;
    for (const State& s : states_) states.push_back(to_file(out_, s));
    std::vector<Offset<gwt::Lights>> light_sets;
    for (const auto& set : light_sets_)
        light_sets.push_back(gwt::CreateLights(out_, structs<gwt::Light>(set)));
    std::vector<Offset<gwt::ParameterSet>> sets;
    for (const ParameterSet& s : r.sets)
        sets.push_back(gwt::CreateParameterSetDirect(out_, s.pass.c_str(), s.set.c_str()));
    need(8 * (lists.size() + states.size() + meshes_.size()) + (1 << 16));
    const auto stored_profile = profile(r.profile);
    out_.Finish(
        gwt::CreateRecordingDirect(
            out_, version(r.profile), r.producer.c_str(), r.scene.c_str(), r.renderer.c_str(),
            stored_profile, r.width, r.height, &sets, &meshes_, &textures_, &light_sets, &states,
            &lists, window.empty() ? nullptr : window.c_str(), file_enum<gwt::WindowEvent>(event)),
        gwt::RecordingIdentifier());
    return {out_.GetBufferPointer(), out_.GetBufferPointer() + out_.GetSize()};
}

}  // namespace

std::vector<std::uint8_t> encode(const Recording& recording) {
    StoredValues stored;
    return Encoder(stored).encode(recording);
}

std::vector<std::uint8_t> encode_part(const Part& part, StoredValues& stored) {
    return Encoder(stored).encode(part.recording, part.window, part.event);
}

}  // namespace gw::inspect
