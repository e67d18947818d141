#include "scene/obj/read_obj.h"

#include "scene/obj/normals.h"
#include "scene/obj/obj_data.h"
#include "scene/obj/obj_tokens.h"
#include "scene/obj/origins.h"
#include "scene/obj/read_mtl.h"
#include "scene/text/encoding.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <span>

namespace gw::scene {
namespace {

// Statements that are not drawn: free-form geometry, display hints, superseded ones.
constexpr std::array obj_not_honoured = std::to_array<std::string_view>({
    "cstype",     "deg",       "bmat", "step", "curv", "curv2", "surf",   "parm",   "trim",
    "hole",       "scrv",      "sp",   "end",  "con",  "vp",    "ctech",  "stech",  "bevel",
    "c_interp",   "d_interp",  "lod",  "mg",   "call", "csh",   "usemap", "maplib", "res",
    "shadow_obj", "trace_obj", "bsp",  "bzp",  "cdc",  "cdp",
});
// Other programs' additions: tags of subdivision, weights of joints. Too short to be suggested.
constexpr std::array obj_additions = std::to_array<std::string_view>({"t", "vw"});

// Each word of an mtllib may end a name, which is searched for in its folder.
constexpr std::ptrdiff_t most_library_blanks = 1000;
constexpr std::size_t longest_library_name = 255;

class ObjReader {
public:
    /// Positions are rounded to float32, unless they shall be exact.
    ObjReader(const std::filesystem::path& path, std::string_view text, bool is_exact,
              Warnings& warnings)
        : folder_(path.parent_path()),
          in_(path.string(), text),
          warnings_(warnings),
          is_exact_(is_exact) {
        build_.obj.file = in_.file();
    }

    ObjData read() {
        while (in_.next()) statement();
        const ObjData& obj = build_.obj;
        if (obj.elements.empty()) {
            for (const auto* bad : {&obj.bad_positions, &obj.bad_texcoords, &obj.bad_normals})
                if (!bad->empty()) throw Error(in_.file(), bad->front().line, bad->front().fault);
            throw Error(in_.file(), 0, "has nothing to draw; expected f, l or p statements");
        }
        check_indices(obj);
        return std::move(build_.obj);
    }
    MaterialLibrary take_materials() { return std::move(materials_); }
    const std::string& missing_library() const { return missing_; }

private:
    struct Keyword {
        std::string_view name;
        void (ObjReader::*read)();
    };
    static const std::array<Keyword, 12> keywords;

    void statement() {
        if (read_as(in_.keyword()) || read_as(lower(in_.keyword()))) return;
        std::vector<std::string> known(obj_not_honoured.begin(), obj_not_honoured.end());
        for (const Keyword& keyword : keywords) known.emplace_back(keyword.name);
        in_.fail(unknown("statement", in_.keyword(), known));
    }

    bool read_as(std::string_view name) {
        for (const Keyword& keyword : keywords)
            if (name == keyword.name) {
                (this->*keyword.read)();
                return true;
            }
        if (std::ranges::find(obj_not_honoured, name) == obj_not_honoured.end() &&
            std::ranges::find(obj_additions, name) == obj_additions.end())
            return false;
        warn(name, std::string(name) + " statements are not drawn");
        return true;
    }

    void warn(std::string_view kind, std::string_view text) {
        warnings_.add(in_.file(), in_.line(), std::string(kind), text);
    }

    /// The numbers of a v, vt or vn. None if one of them is not finite, which counts when it is used.
    std::optional<std::size_t> numbers(std::span<float> n, std::size_t index,
                                       std::vector<NotFinite>& bad, std::string_view form) {
        try {
            return read_numbers(in_, in_.rest(), n, form);
        } catch (const Error&) {
            auto fault = not_finite(in_.rest(), form);
            if (!fault) throw;
            bad.push_back({static_cast<std::uint32_t>(index), in_.line(), std::move(*fault)});
            return std::nullopt;
        }
    }

    void position() {
        constexpr std::string_view form = "v x y z, v x y z w, v x y z r g b or v x y z r g b a";
        std::array<float, 7> n{0, 0, 0, 1, 1, 1, 1};
        ObjData& obj = build_.obj;
        auto read = numbers(n, obj.positions.size(), obj.bad_positions, form);
        if (!read && is_place_with_color(in_.rest())) {
            obj.bad_positions.pop_back();
            warn("colour", color_warning);
            read = read_numbers(in_, place_of(in_.rest()), n, form);
        }
        const std::size_t count = read.value_or(3);
        if (count < 3 || count == 5) fail_count(in_, count, form);
        if (count == 4 && n[3] != 1) warn("w", "the weight w of v is not used");
        obj.positions.push_back(read ? place(n) : dvec3(0));
        if (count >= 6 && vec3(n[3], n[4], n[5]) != vec3(1)) warn("colour", color_warning);
        if (count < 6 && obj.colors.empty()) return;
        obj.colors.resize(obj.positions.size(), vec4(1, 1, 1, 1));
        if (count >= 6) obj.colors.back() = {n[3], n[4], n[5], n[6]};
    }

    static constexpr std::string_view color_warning =
        "colours of v are not drawn; expected them in a map (map_Kd)";

    /// x y z alone.
    static std::string_view place_of(std::string_view text) {
        std::string_view rest = text;
        for (int k = 0; k < 3; ++k) take_word(rest);
        return text.substr(0, text.size() - rest.size());
    }
    /// Is x y z finite, and followed by a colour?
    static bool is_place_with_color(std::string_view text) {
        std::string_view rest = text.substr(place_of(text).size());
        int words = 0;
        while (!take_word(rest).empty()) ++words;
        return (words == 3 || words == 4) && !not_finite(place_of(text), {});
    }

    /// As float32, or as in the text.
    dvec3 place(const std::array<float, 7>& n) const {
        dvec3 p(n[0], n[1], n[2]);
        if (!is_exact_) return p;
        std::string_view rest = in_.rest();
        for (int k = 0; k < 3; ++k) {
            std::string_view word = take_word(rest);
            if (word.starts_with('+')) word.remove_prefix(1);
            p[k] = read_double(word).value_or(p[k]);
        }
        return p;
    }

    void texcoord() {
        constexpr std::string_view form = "vt s, vt s t or vt s t r";
        std::array<float, 3> n{};
        ObjData& obj = build_.obj;
        const auto read = numbers(n, obj.texcoords.size(), obj.bad_texcoords, form);
        if (read && *read < 1) fail_count(in_, *read, form);
        obj.texcoords.emplace_back(read ? vec2(n[0], n[1]) : vec2(0));
    }

    void normal() {
        constexpr std::string_view form = "vn x y z";
        std::array<float, 3> n{};
        ObjData& obj = build_.obj;
        const auto read = numbers(n, obj.normals.size(), obj.bad_normals, form);
        if (read && *read < 3) fail_count(in_, *read, form);
        if (n == std::array<float, 3>{})
            warn("vn", "vn of length 0: the faces' own normals stand in");
        obj.normals.emplace_back(n[0], n[1], n[2]);
    }

    // Appends the statement's corners; returns their number.
    std::uint32_t corners(std::uint32_t least) {
        std::uint32_t count = 0;
        std::string_view rest = in_.rest();
        for (std::string_view word = take_word(rest); !word.empty();
             word = take_word(rest), ++count)
            build_.obj.corners.push_back(read_corner(in_, word, build_.obj));
        if (count < least)
            in_.fail(std::string(in_.keyword()) + " has " + std::to_string(count) +
                     (count == 1 ? " corner" : " corners") + "; expected at least " +
                     std::to_string(least));
        return count;
    }
    void face() { build_.add_face(corners(3), in_.line()); }
    void line() { build_.add_segments(corners(2), in_.line()); }
    void point() { build_.add_points(corners(1), in_.line()); }

    void object() { build_.set_object(in_.rest()); }
    void group() { build_.set_group(in_.rest()); }
    void material() {
        build_.set_material(in_.rest() == "(null)" ? std::string_view() : in_.rest(), in_.line());
    }

    void smoothing() {
        std::string_view rest = in_.rest();
        const std::string_view word = take_word(rest);
        std::uint32_t group = word == "on";
        const auto result = std::from_chars(word.data(), word.data() + word.size(), group);
        const bool number = result.ec == std::errc{} && result.ptr == word.data() + word.size() &&
                            group <= 0x7fffffff;
        if (!number && word != "on" && word != "off")
            in_.fail("s has '" + printable(word) + "'; expected off, on or a number from 0");
        build_.smoothing = static_cast<std::int32_t>(group);
    }

    // File names may hold blanks, and a line may hold several: the longest existing names are
    // taken.
    void library() {
        std::string_view rest = in_.rest();
        if (rest.empty()) in_.fail("mtllib names no file; expected one or more");
        if (std::ranges::count_if(rest, is_blank) >= most_library_blanks)
            in_.fail("mtllib has too many words; expected fewer than " +
                     std::to_string(most_library_blanks));
        while (!rest.empty()) {
            const std::string_view name = first_name(rest);
            rest = trim(rest.substr(name.size()));
            library(name, find_file(folder_, trim(name)));
        }
    }
    void library(std::string_view name, const std::filesystem::path& path) {
        const std::string fault = file_fault(path);
        if (fault == not_there) return missing(name);
        if (!fault.empty())
            in_.fail("mtllib '" + printable(name) + "' " + fault + "; expected an MTL file");
        if (!libraries_.insert(path).second) return;
        materials_.add(read_mtl(path, warnings_));
    }
    /// No error: a scene may bring its own materials, or the default one stands in.
    void missing(std::string_view name) {
        const std::string text = "mtllib '" + printable(name) + "' " + std::string(not_there);
        if (missing_.empty()) missing_ = "line " + std::to_string(in_.line()) + ": " + text;
        warn("mtllib " + std::string(name), text + "; expected an MTL file");
    }
    /// The longest one that exists; if there is none, all that stands before one.
    std::string_view first_name(std::string_view names) const {
        if (const std::size_t size = longest_file(names); size > 0) return names.substr(0, size);
        for (std::size_t at = names.find_first_of(" \t"); at != names.npos;
             at = names.find_first_of(" \t", at + 1))
            if (!is_blank(names[at + 1]) && longest_file(names.substr(at + 1)) > 0)
                return names.substr(0, at);
        return names;
    }
    /// 0: no file has a name that begins here.
    std::size_t longest_file(std::string_view names) const {
        for (const std::size_t size : ends_of_names(names))
            if (existing_file(folder_, trim(names.substr(0, size)))) return size;
        return 0;
    }
    /// Where the first name may end: after the whole text, or a word within the longest name.
    static std::vector<std::size_t> ends_of_names(std::string_view names) {
        std::vector<std::size_t> ends;
        for (std::size_t at = names.find_first_of(" \t"); at <= longest_library_name;
             at = names.find_first_of(" \t", at + 1))
            ends.push_back(at);
        ends.push_back(names.size());
        std::ranges::reverse(ends);
        return ends;
    }
    const std::filesystem::path folder_;
    Statements in_;
    Warnings& warnings_;
    const bool is_exact_;
    ObjBuilder build_;
    MaterialLibrary materials_;
    std::string missing_;
    std::set<std::filesystem::path> libraries_;  ///< read already
};

const std::array<ObjReader::Keyword, 12> ObjReader::keywords{{
    {"v", &ObjReader::position},
    {"f", &ObjReader::face},
    {"vn", &ObjReader::normal},
    {"vt", &ObjReader::texcoord},
    {"s", &ObjReader::smoothing},
    {"g", &ObjReader::group},
    {"o", &ObjReader::object},
    {"usemtl", &ObjReader::material},
    {"mtllib", &ObjReader::library},
    {"l", &ObjReader::line},
    {"p", &ObjReader::point},
    {"fo", &ObjReader::face},
}};

}  // namespace

ObjFile read_obj(const std::filesystem::path& path, const ObjOptions& options, Warnings& warnings) {
    warnings.add_file(path);
    const std::string text = utf8_of_statements(path.string(), read_text(path));
    ObjReader reader(path, text, false, warnings);
    ObjData obj = reader.read();
    if (const std::vector<dvec3> origins = origins_of_parts(obj); !origins.empty()) {
        Warnings again;
        obj = ObjReader(path, text, true, again).read();
        for (std::size_t p = 0; p < origins.size(); ++p) obj.parts[p].origin = origins[p];
    }
    for (Part& part : obj.parts)
        if (part.name.empty()) part.name = path.stem().string();
    warn_rounded(obj, warnings);
    if (options.crease)
        for (Element& element : obj.elements) element.smoothing = smooth_by_angle;
    if (const Element* flat = add_normals(obj, options.crease.value_or(default_crease)))
        warnings.add(
            path.string(), flat->line, "flat",
            "more than " + std::to_string(most_compared) +
                " faces meet at a corner of this one and stay flat there; expected normals "
                "(vn) or a smoothing group (s)");

    ObjFile file{path.string(), {}, reader.take_materials(), reader.missing_library()};
    std::vector<MeshData> meshes = make_meshes(obj);
    for (std::size_t p = 0; p < meshes.size(); ++p) {
        const Part& part = obj.parts[p];
        file.parts.push_back(
            {part.name, part.material, part.material_line, part.origin, std::move(meshes[p])});
    }
    return file;
}

}  // namespace gw::scene
