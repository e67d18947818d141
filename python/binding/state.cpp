// Enumerations, profiles and the pipeline's state.
#include "gw/state.h"

#include "gw/command_list.h"
#include "gw/describe/enumerators.h"
#include "gw/describe/state_fields.h"
#include "gw/profile.h"
#include "gw/profile_text.h"
#include "python/binding/fields.h"
#include "python/binding/module.h"

namespace gw::python {
namespace {

/// Words of Python's own cannot be names.
template <class Enum>
std::string python_name(Enum value) {
    const std::string_view name = enumerator(value);
    if (name != "None") return std::string(name);
    return std::is_same_v<Enum, DrawBuffer> ? "NoBuffer" : "Off";
}

template <class Enum>
void add_words(py::module_& m, const char* sentence) {
    std::vector<std::pair<std::string, Enum>> values;
    for (std::size_t i = 0; i < count_of<Enum>; ++i)
        values.emplace_back(python_name(static_cast<Enum>(i)), static_cast<Enum>(i));
    add_enum<Enum>(m, std::string(type_name<Enum>), sentence, values);
}

void add_profiles(py::module_& m) {
    Fields<Extensions> extensions(m, "Extensions", "Features that a machine may lack.");
    for (const ExtensionName& name : extension_names())
        extensions.field(name.name, name.member, "Whether the machine has it.");
    Fields<Profile> profile(m, "Profile", "A machine's bits of each value, and its extensions.");
    profile.field("name", &Profile::name, "For messages.")
        .field("color_bits", &Profile::color_bits, "Per channel, 8 .. 16.")
        .field("depth_bits", &Profile::depth_bits, "16 .. 32.")
        .field("stencil_bits", &Profile::stencil_bits, "1 .. 8.")
        .field("accum_bits", &Profile::accum_bits, "Per channel, signed, 16 .. 32.")
        .field("subpixel_bits", &Profile::subpixel_bits, "1 .. 8.")
        .field("lit_bits", &Profile::lit_bits, "Of a lit vertex colour, 4 .. color_bits.")
        .field("max_lights", &Profile::max_lights, "In one pass, 1 .. 1024.")
        .field("texel_bits", &Profile::texel_bits, "Of a texel's channel; 0: color_bits.")
        .field("coverage_bits", &Profile::coverage_bits, "Of antialiasing; 0: none.")
        .field("color_planes", &Profile::color_planes, "2: front and back.")
        .field("fragment_fog", &Profile::fragment_fog, "Fog at each fragment by default.")
        .field("perspective_color", &Profile::perspective_color, "Gouraud shading in perspective.")
        .field("extensions", &Profile::extensions, "The features that it has.");
    profile.type().def(py::init([](const std::string& text) { return profile_from_text(text); }),
                       py::arg("text"),
                       "A built-in profile with changes: \"vgx\", \"opengl,depth_bits=32\".");
    profile.type().def("__str__", [](const Profile& p) { return profile_text(p); });
    py::implicitly_convertible<py::str, Profile>();
    m.def("profiles", &profiles, "The built-in profiles: vgx, reality, ideal, opengl.");
}

using StipplePattern = std::array<std::uint32_t, 32>;

std::optional<StipplePattern> stipple_pattern(const State& s) {
    if (!s.polygon_stipple.pattern) return {};
    return *s.polygon_stipple.pattern;
}
void set_stipple_pattern(State& s, const std::optional<StipplePattern>& pattern) {
    s.polygon_stipple.pattern =
        pattern ? std::make_shared<const StipplePattern>(*pattern) : nullptr;
}

using UnitStates = std::array<TextureState, max_texture_units - 1>;

std::optional<UnitStates> unit_states(const State& s) {
    if (!s.more_textures.units) return {};
    return *s.more_textures.units;
}
void set_unit_states(State& s, const std::optional<UnitStates>& units) {
    s.more_textures.units = units ? std::make_shared<const UnitStates>(*units) : nullptr;
}

/// Adds a type of the state's description after its fields' types, once. Other types are
/// Python's own.
template <class T>
struct AddType {
    void operator()(py::module_& m) const {
        const std::string name(type_name<T>);
        if (py::hasattr(m, name.c_str())) return;
        if constexpr (std::is_enum_v<T>) add_words<T>(m, sentence_of<T>);
        if constexpr (Described<T>) {
            for_each_field<T>([&](const auto& f) {
                AddType<typename std::remove_cvref_t<decltype(f)>::Member>()(m);
            });
            Fields<T> fields(m, name.c_str(), sentence_of<T>);
            for_each_field<T>([&](const auto& f) { add_field(fields, f); });
        }
    }

    template <class Value>
    static void add_field(Fields<T>& fields, const gw::Field<T, Value>& f) {
        if constexpr (std::is_same_v<Value, PolygonStippleState>)
            fields.property(f.name, stipple_pattern, set_stipple_pattern, f.sentence);
        else if constexpr (std::is_same_v<Value, MoreTextures>)
            fields.property(f.name, unit_states, set_unit_states, f.sentence);
        else
            fields.field(f.name, f.member, f.sentence);
    }
};
template <class Element, std::size_t size>
struct AddType<std::array<Element, size>> : AddType<Element> {};

}  // namespace

void add_state(py::module_& module) {
    add_words<Plane>(module, "A plane of the machine.");
    add_words<AccumOp>(module, "An operation on the accumulation buffer.");
    add_profiles(module);
    AddType<State>()(module);
}

}  // namespace gw::python
