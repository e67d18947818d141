// The state in both directions, by the fields of gw/describe/state_fields.h and of the schema: one
// name is one member. `ours` says where members stand that the schema keeps elsewhere.
#include "gw/describe/enumerators.h"
#include "gw/describe/state_fields.h"
#include "inspect/recording/file_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace gw::inspect {
namespace {

using inspect::from_file;
using inspect::to_file;

template <class Ours, class File>
inline constexpr bool has_same_values = names_of<Ours> == names_of<File>;
// As bytes in the schema's StencilFace, and in textures:
static_assert(has_same_values<StencilOp, gwt::StencilOp>);
static_assert(has_same_values<TextureFormat, gwt::TextureFormat>);

// ---- Groups: structs of the schema --------------------------------------------------------------

template <class Struct>
constexpr std::size_t place_of(std::string_view name) {
    std::size_t place = 0, found = std::tuple_size_v<decltype(fields_of<Struct>)>;
    for_each_field<Struct>([&](const auto& field) {
        if (field.name == name) found = place;
        ++place;
    });
    return found;
}
/// The member of that name, of a struct or a const one. A name that there is not does not compile.
template <std::size_t place, class Struct>
auto& member(Struct& object) {
    return object.*std::get<place>(fields_of<std::remove_const_t<Struct>>).member;
}

template <class File>
inline constexpr auto places_in = std::make_index_sequence<File::Traits::fields_number>();
template <class File, std::size_t i>
inline constexpr std::string_view name_in = File::Traits::field_names[i];

template <class File, class Value>
File stored(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        if constexpr (std::is_enum_v<File>) static_assert(has_same_values<Value, File>);
        return static_cast<File>(value);
    } else if constexpr (Described<Value>) {
        return [&]<std::size_t... i>(std::index_sequence<i...>) {
            return File(stored<typename File::Traits::template FieldType<i>>(
                member<place_of<Value>(name_in<File, i>)>(value))...);
        }
        (places_in<File>);
    } else if constexpr (std::is_same_v<File, Value>) {
        return value;
    } else {
        return to_file(value);
    }
}
template <>
gwt::Stencil stored(const StencilState& s) {
    return {s.test, stored<gwt::StencilFace>(s), s.two_side, stored<gwt::StencilFace>(s.back)};
}

template <class File, class Value>
void read(const File& file, Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        value = our_enum<Value>(file);
    } else if constexpr (Described<Value>) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (read(file.template get_field<i>(), member<place_of<Value>(name_in<File, i>)>(value)),
             ...);
        }
        (places_in<File>);
    } else if constexpr (std::is_same_v<File, Value>) {
        value = file;
    } else {
        value = from_file(file);
    }
}
void read(const gwt::Stencil& file, StencilState& s) {
    s.test = file.test();
    read(file.front(), s);
    s.two_side = file.two_side();
    read(file.back(), s.back);
}

// ---- The table State ----------------------------------------------------------------------------

template <std::size_t i>
inline constexpr std::string_view name_of_member = name_in<gwt::State, i>;

/// Our member for the schema's member i, of a State or a const one.
template <std::size_t i, class OurState>
auto& ours(OurState& s) {
    constexpr std::string_view name = name_of_member<i>;
    if constexpr (name == "blend_equation")
        return s.blend.equation;
    else if constexpr (name == "blend_color")
        return s.blend.color;
    else if constexpr (name == "blend_alpha")
        return s.blend.alpha;
    else if constexpr (name == "texture_lod")
        return s.texture.lod;
    else if constexpr (name == "combine_rgb")
        return s.texture.combine_rgb;
    else if constexpr (name == "combine_alpha")
        return s.texture.combine_alpha;
    else if constexpr (name == "color_material")
        return s.lighting.color_material;
    else if constexpr (name == "separate_specular")
        return s.lighting.separate_specular;
    else if constexpr (name == "fog_source")
        return s.fog.source;
    else if constexpr (name == "coordinates")
        return s.texture.coordinates;
    else if constexpr (name == "texture_matrix")
        return s.texture.matrix;
    else if constexpr (name == "border_color")
        return s.texture.border_color;
    else if constexpr (name == "compare_func")
        return s.texture.compare_func;
    else if constexpr (name == "wrap_r")
        return s.texture.wrap_r;
    else if constexpr (name == "seamless")
        return s.texture.seamless;
    else if constexpr (name == "exact_rho")
        return s.texture.exact_rho;
    else if constexpr (name == "coord_replace")
        return s.texture.coord_replace;
    else if constexpr (name == "offset_lines")
        return s.polygon_offset.lines;
    else if constexpr (name == "offset_points")
        return s.polygon_offset.points;
    else
        return member<place_of<State>(name)>(s);
}

/// point_size, line_width and sizes are one thing: two numbers, which version 1 has only whole.
constexpr bool is_size(std::string_view name) {
    return name == "point_size" || name == "line_width" || name == "sizes";
}
bool is_whole(float size) { return size == std::floor(size) && std::abs(size) < 65536; }
bool has_whole_sizes(const State& s) { return is_whole(s.point_size) && is_whole(s.line_width); }

const State& initial() {
    static const State state;
    return state;
}

template <std::size_t i>
bool is_initial(const State& s) {
    if constexpr (name_of_member<i> == "sizes")
        return has_whole_sizes(s);
    else if constexpr (is_size(name_of_member<i>))
        return true;
    else
        return ours<i>(s) == ours<i>(initial());
}

constexpr auto state_places = places_in<gwt::State>;
template <std::size_t i>
using FileMember = gwt::State::Traits::FieldType<i>;

template <class File>
inline constexpr bool is_vector = false;
template <class Element>
inline constexpr bool is_vector<const flatbuffers::Vector<Element>*> = true;

/// Vectors are stored before the table that has them; by member.
using Vectors = std::array<flatbuffers::Offset<void>, gwt::State::Traits::fields_number>;

template <class File, class Element, std::size_t size>
flatbuffers::Offset<void> vector_to_file(flatbuffers::FlatBufferBuilder& out,
                                         const std::array<Element, size>& elements) {
    using FileElement = std::remove_cvref_t<decltype(*std::declval<File>()->Get(0))>;
    std::vector<FileElement> all;
    for (const Element& element : elements) all.push_back(stored<FileElement>(element));
    return out.CreateVectorOfStructs(all).Union();
}
template <class File>
flatbuffers::Offset<void> vector_to_file(flatbuffers::FlatBufferBuilder& out,
                                         const PolygonStippleState& stipple) {
    return out.CreateVector(stipple.pattern->data(), stipple.pattern->size()).Union();
}

/// Each unit as a state that has nothing else.
template <class File>
flatbuffers::Offset<void> vector_to_file(flatbuffers::FlatBufferBuilder& out,
                                         const MoreTextures& more) {
    std::vector<flatbuffers::Offset<gwt::State>> all;
    for (const TextureState& unit : *more.units) {
        State s;
        s.texture = unit;
        all.push_back(inspect::to_file(out, s));
    }
    return out.CreateVector(all).Union();
}

template <std::size_t i>
void add_vector(flatbuffers::FlatBufferBuilder& out, const State& s, Vectors& vectors) {
    if constexpr (is_vector<FileMember<i>>)
        if (!is_initial<i>(s)) vectors[i] = vector_to_file<FileMember<i>>(out, ours<i>(s));
}

void add_size(gwt::StateBuilder& b, std::string_view name, const State& s) {
    const gwt::Sizes sizes{s.point_size, s.line_width};
    if (name == "sizes" && !has_whole_sizes(s)) b.add_sizes(&sizes);
    if (name == "point_size" && has_whole_sizes(s)) b.add_point_size(int(s.point_size));
    if (name == "line_width" && has_whole_sizes(s)) b.add_line_width(int(s.line_width));
}

/// The schema's member i, unless it is at its initial value.
template <std::size_t i>
void add(gwt::StateBuilder& b, const Vectors& vectors, const State& s) {
    using File = FileMember<i>;
    constexpr flatbuffers::voffset_t place = 4 + 2 * i;
    if constexpr (is_size(name_of_member<i>)) {
        add_size(b, name_of_member<i>, s);
    } else if constexpr (is_vector<File>) {
        b.fbb_.AddOffset(place, vectors[i]);
    } else if constexpr (std::is_pointer_v<File>) {
        if (is_initial<i>(s)) return;
        const auto value = stored<std::remove_cvref_t<std::remove_pointer_t<File>>>(ours<i>(s));
        b.fbb_.AddStruct(place, &value);
    } else {
        using Number = std::conditional_t<sizeof(File) == 1, std::uint8_t, File>;
        const auto number = [](const auto& v) { return static_cast<Number>(stored<File>(v)); };
        b.fbb_.AddElement<Number>(place, number(ours<i>(s)), number(ours<i>(initial())));
    }
}

/// "clip planes in a state"
std::string vector_words(std::string_view member) {
    if (member == "polygon_stipple") return "rows of a polygon stipple";
    std::string words(member == "coordinates" ? "texture_coordinates" : member);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words + " in a state";
}
/// None, or all.
void check_size(std::size_t size, std::size_t expected, std::string_view member) {
    if (size != 0 && size != expected)
        throw Error(fmt::format("{} {}; expected {}", size, vector_words(member), expected));
}
template <class Files, class Element, std::size_t size>
void read_elements(const Files& files, std::array<Element, size>& elements) {
    for (unsigned i = 0; i < files.size(); ++i) read(*files.Get(i), elements[i]);
}
constexpr std::size_t size_of(const auto& elements) { return elements.size(); }
constexpr std::size_t size_of(const PolygonStippleState&) { return 32; }
constexpr std::size_t size_of(const MoreTextures&) { return max_texture_units - 1; }

template <class Files>
void read_elements(const Files& files, MoreTextures& more) {
    if (files.size() == 0) return;
    std::array<TextureState, max_texture_units - 1> units;
    for (unsigned i = 0; i < files.size(); ++i)
        units[i] = inspect::from_file(*files.Get(i)).texture;
    more.units = std::make_shared<const decltype(units)>(units);
}

template <class Files>
void read_elements(const Files& files, PolygonStippleState& stipple) {
    std::array<std::uint32_t, 32> rows;
    if (files.size() == 0) return;
    std::copy(files.begin(), files.end(), rows.begin());
    stipple.pattern = std::make_shared<const std::array<std::uint32_t, 32>>(rows);
}

/// The schema's member i, if it is there.
template <std::size_t i>
void read_member(const gwt::State& f, State& s) {
    const auto file = f.get_field<i>();
    if constexpr (is_size(name_of_member<i>)) {
        s.point_size = f.sizes() ? f.sizes()->point() : float(f.point_size());
        s.line_width = f.sizes() ? f.sizes()->line() : float(f.line_width());
    } else if constexpr (is_vector<FileMember<i>>) {
        if (!file) return;
        check_size(file->size(), size_of(ours<i>(s)), name_of_member<i>);
        read_elements(*file, ours<i>(s));
    } else if constexpr (std::is_pointer_v<FileMember<i>>) {
        if (file) read(*file, ours<i>(s));
    } else {
        read(file, ours<i>(s));
    }
}

/// Enumerators of version 2 in members of version 1.
bool has_enumerator_of_version_2(const State& s) {
    const auto is_constant = [](BlendFactor f) { return f >= BlendFactor::ConstantColor; };
    return s.texture.env > TexEnv::Replace || is_constant(s.blend.src) ||
           is_constant(s.blend.dst) || s.texture.gen == TexGen::PerCoordinate ||
           s.texture.wrap_s >= Wrap::BorderClamp || s.texture.wrap_t >= Wrap::BorderClamp;
}

constexpr bool is_of_version_2(std::size_t place) {
    return 4 + 2 * place >= gwt::State::VT_BLEND_EQUATION;
}

}  // namespace

flatbuffers::Offset<gwt::State> to_file(flatbuffers::FlatBufferBuilder& out, const State& s) {
    Vectors vectors;
    [&]<std::size_t... i>(std::index_sequence<i...>) { (add_vector<i>(out, s, vectors), ...); }
    (state_places);
    gwt::StateBuilder b(out);
    [&]<std::size_t... i>(std::index_sequence<i...>) { (add<i>(b, vectors, s), ...); }
    (state_places);
    return b.Finish();
}

bool needs_version_2(const State& s) {
    return has_enumerator_of_version_2(s) || [&]<std::size_t... i>(std::index_sequence<i...>) {
        return ((is_of_version_2(i) && !is_initial<i>(s)) || ...);
    }
    (state_places);
}

State from_file(const gwt::State& f) {
    State s;
    [&]<std::size_t... i>(std::index_sequence<i...>) { (read_member<i>(f, s), ...); }
    (state_places);
    return s;
}

}  // namespace gw::inspect
