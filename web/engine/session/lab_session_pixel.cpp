// One triangle and one pixel: every number between the corners and the planes, by the functions of
// the reference machine, and the fragment that the machine itself makes.
#include "gw/error.h"
#include "gw/reference/make.h"
#include "gw/reference/texture_unit.h"
#include "gw/stages/tables.h"
#include "gw/stages/vertex.h"
#include "inspect/replay/pixel_history.h"
#include "render/options.h"
#include "scene/draw/view.h"
#include "web/engine/method.h"
#include "web/engine/rgba.h"

#include <cmath>

namespace gw::lab {
namespace {

namespace ref = gw::reference;

/// Exact, of any size.
std::string decimal(int128 v) {
    std::string text;
    for (int128 rest = v < 0 ? -v : v; rest != 0; rest /= 10)
        text.insert(text.begin(), char('0' + int(rest % 10)));
    if (text.empty()) text = "0";
    return v < 0 ? "-" + text : text;
}

/// The shortest decimal of which a float is the nearest.
std::string shortest(float v) { return Json(v).dump(); }

int128 shifted(const ref::PlaneEquation& p, int x, int y) {
    const int s = p.subpixel_bits;
    const std::int64_t px = (std::int64_t{x} << s) + (std::int64_t{1} << (s - 1)),
                       py = (std::int64_t{y} << s) + (std::int64_t{1} << (s - 1));
    const int128 step = (p.gx * (px - p.x0) + p.gy * (py - p.y0)) >> s;
    return (int128{p.a0} << 16) + (1 << 15) + step;
}

/// The plane at a pixel: R9.6 and R9.8.
Json plane_json(const char* name, const ref::PlaneEquation& p, int x, int y) {
    return {{"name", name},
            {"a0", p.a0},
            {"x0", p.x0},
            {"y0", p.y0},
            {"gx", decimal(p.gx)},
            {"gy", decimal(p.gy)},
            {"sum", decimal(shifted(p, x, y))},
            {"value", p.at(x, y)}};
}

/// The plane along a row: the closed form, and the sum that grows by Gx from pixel to pixel [L8].
Json steps_json(const ref::PlaneEquation& p, int first, int last, int y) {
    Json steps = Json::array();
    int128 stepped = shifted(p, first, y);
    for (int x = first; x <= last; ++x, stepped += p.gx)
        steps.push_back({{"x", x},
                         {"closed", decimal(shifted(p, x, y))},
                         {"stepped", decimal(stepped)},
                         {"value", p.at(x, y)}});
    return steps;
}

constexpr int pattern_side = 8;

/// A pattern whose texels differ: red to the right, green upwards, a chequer in blue.
TextureRef pattern() {
    std::vector<std::uint8_t> texels;
    for (int j = 0; j < pattern_side; ++j)
        for (int i = 0; i < pattern_side; ++i)
            for (const int channel : {40 + i * 30, 40 + j * 30, (i + j) % 2 ? 200 : 30, 255})
                texels.push_back(std::uint8_t(channel));
    return make_texture8("pattern", pattern_side, pattern_side, texels);
}

template <class Enum>
Enum chosen(const Json& options, const char* key,
            std::initializer_list<std::pair<const char*, Enum>> known) {
    const std::string word = options.value(key, known.begin()->first);
    for (const auto& [name, value] : known)
        if (word == name) return value;
    throw Error(std::string(key) + " '" + word + "'; expected " + known.begin()->first + ", ...");
}

struct CornerChoice {
    std::int64_t x = 0, y = 0;  ///< sub-pixel units
    double z = 0, w = 1;
    vec4 color{1};
    dvec2 st{0};
};

/// The triangle, the state and the window that the page asks about.
struct Asked {
    Profile profile;
    int width = 0, height = 0;
    std::array<CornerChoice, 3> corners;
    State state;
    TextureRef texture;
    Clear clear;
};

vec4 color_from(const Json& json) { return {json.at(0), json.at(1), json.at(2), json.at(3)}; }

Asked asked_from(const Json& options) {
    render::Request request;
    render::set(request, "profile", options.value("profile", request.profile));
    Asked asked{.profile = render::load_profile(request),
                .width = options.at("width"),
                .height = options.at("height")};
    for (std::size_t i = 0; i < 3; ++i) {
        const Json& from = options.at("corners").at(i);
        asked.corners[i] = {.x = from.at("x"),
                            .y = from.at("y"),
                            .z = from.at("z"),
                            .w = from.at("w"),
                            .color = color_from(from.at("color")),
                            .st = {from.at("s"), from.at("t")}};
        if (!(asked.corners[i].w > 0)) throw Error("w is not above 0; expected a distance");
    }
    State& state = asked.state;
    state.projection = scene::ortho(0, asked.width, 0, asked.height, 0, -1);
    state.depth = {.test = true, .func = DepthFunc::Less, .mask = true};
    using Filter = std::pair<MinFilter, MagFilter>;
    const auto filter = chosen<Filter>(options, "filter",
                                       {{"none", {}},
                                        {"nearest", {MinFilter::Nearest, MagFilter::Nearest}},
                                        {"linear", {MinFilter::Linear, MagFilter::Linear}}});
    state.texture.min_filter = filter.first;
    state.texture.mag_filter = filter.second;
    state.texture.env = chosen<TexEnv>(options, "env",
                                       {{"modulate", TexEnv::Modulate},
                                        {"replace", TexEnv::Replace},
                                        {"decal", TexEnv::Decal},
                                        {"blend", TexEnv::Blend}});
    if (options.value("filter", "none") != "none") asked.texture = pattern();
    using B = BlendFactor;
    state.blend = chosen<BlendState>(
        options, "blend",
        {{"none", {}},
         {"add", {.enable = true, .src = B::One, .dst = B::One}},
         {"over", {.enable = true, .src = B::SrcAlpha, .dst = B::OneMinusSrcAlpha}},
         {"modulate", {.enable = true, .src = B::DstColor, .dst = B::Zero}}});
    asked.clear = {.planes = mask_of(Plane::Color) | mask_of(Plane::Depth),
                   .color = color_from(options.at("background")),
                   .depth = options.value("depth", 1.0)};
    return asked;
}

/// What the machine executes.
CommandList list_of(const Asked& asked) {
    MeshData data;
    const double scale = double(1 << asked.profile.subpixel_bits);
    for (const CornerChoice& c : asked.corners) {
        data.positions.push_back(vec3(dvec3(double(c.x) / scale, double(c.y) / scale, c.z) * c.w));
        data.w.push_back(float(c.w));
        data.colors.push_back(c.color);
        data.texcoords.push_back(vec2(c.st));
    }
    CommandList list;
    list.add(SetState{asked.state});
    list.add(BeginPass{.name = "triangle"});
    list.add(asked.clear);
    list.add(Draw{.mesh = make_mesh(std::move(data)), .map = {.texture = asked.texture}});
    return list;
}

/// Every fragment of the triangle.
class Fragments : public Observer {
public:
    struct Seen {
        Fragment fragment;
        Fate fate;
        PixelValues before, after;
    };
    std::vector<Seen> all;

    void begin_command(std::size_t) override {}
    void fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        all.push_back({fragment, fate, before, after});
    }
    void pixel(int, int, const PixelValues&, const PixelValues&) override {}
};

Json seen_json(const Fragments::Seen& seen) {
    return {{"color", seen.fragment.color},        {"depth", seen.fragment.depth},
            {"fate", inspect::name_of(seen.fate)}, {"stored", seen.before.color},
            {"stored_depth", seen.before.depth},   {"after", seen.after.color},
            {"after_depth", seen.after.depth}};
}

Json texture_json(const ref::Interpolants& pixel, const Texels& texels, const Resolved& state,
                  int x, int y) {
    const ref::TextureValues& values = pixel.textures[0];
    const TexelLevel& level = texels.levels[0];
    const TextureState& s = state.state.texture;
    const float w = ref::reciprocal(values.q, x, y);
    const int u = ref::level_coordinate(values.s, values.s.at(x, y, w), level.log2_width, s.wrap_s);
    const int v =
        ref::level_coordinate(values.t, values.t.at(x, y, w), level.log2_height, s.wrap_t);
    const bool linear = s.mag_filter == MagFilter::Linear;
    const int half = linear ? 128 : 0, i = (u - half) >> 8, j = (v - half) >> 8;
    Json looked_up = Json::array();
    for (int row = j; row <= j + (linear ? 1 : 0); ++row)
        for (int column = i; column <= i + (linear ? 1 : 0); ++column)
            looked_up.push_back(
                {{"i", wrap_index(s.wrap_s, column, level.width)},
                 {"j", wrap_index(s.wrap_t, row, level.height)},
                 {"color", filter_texel(texels, level, addressing(s, texels, {}), column, row)}});
    return {{"planes",
             Json::array({plane_json("Q", values.q, x, y), plane_json("U", values.s.plane, x, y),
                          plane_json("V", values.t.plane, x, y)})},
            {"w", shortest(w)},
            {"u", u},
            {"v", v},
            {"weights", Json::array({(u - half) & 255, (v - half) & 255})},
            {"side", pattern_side},
            {"texels", looked_up},
            {"texel", ref::texel_at(pixel, 0, texels, state, x, y)}};
}

Json blend_json(const BlendState& state, const Rgba& src, const Rgba& dst, int bits) {
    const BlendColors colors{src, dst, {}};
    Json factors = Json::array(), products = Json::array();
    for (const auto& [color, factor] : {std::pair{src, state.src}, std::pair{dst, state.dst}}) {
        Rgba f{}, product{};
        for (int c = 0; c < 4; ++c) {
            const auto i = std::size_t(c);
            f[i] = std::uint16_t(blend_factor(factor, colors, c, max_of_bits(bits)));
            product[i] = std::uint16_t(mul(color[i], f[i], bits));
        }
        factors.push_back(f);
        products.push_back(product);
    }
    return {{"src", src},
            {"dst", dst},
            {"factors", factors},
            {"products", products},
            {"result", blend(state, colors, bits)}};
}

/// The corners as the machine's vertex stage leaves them.
std::vector<ref::Corner> corners_of(const Draw& draw, const Resolved& state,
                                    const Profile& profile) {
    std::vector<ref::Corner> corners;
    const VertexProgram program = vertex_program(state.state, draw, profile);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Vertex v = run_vertex(program, i);
        ref::Corner corner{to_window(v, state.viewport, state.state.depth_range, profile),
                           v.texcoord,
                           {},
                           {},
                           v.fog};
        for (std::size_t c = 0; c < 4; ++c) corner.color[c] = std::int64_t(v.color[c]);
        corners.push_back(corner);
    }
    return corners;
}

}  // namespace

Json LabSession::pixel(const Json& options) {
    const Asked asked = asked_from(options);
    const int x = options.at("x"), y = options.at("y");
    Fragments fragments;
    const auto machine = ref::make(asked.profile, asked.width, asked.height, &fragments);
    const CommandList list = list_of(asked);
    machine->execute(list);
    const Planes& planes = machine->planes();
    picture_ = rgba_of(
        image::picture_of(planes.color, planes.width, planes.height, asked.profile.color_bits));

    const int bits = asked.profile.color_bits;
    const Resolved state = resolve(asked.state, asked.profile, asked.width, asked.height);
    const auto corners = corners_of(std::get<Draw>(list.commands.back()), state, asked.profile);
    const std::array<WindowVertex, 3> window{corners[0].window, corners[1].window,
                                             corners[2].window};
    Json answer{{"subpixel_bits", asked.profile.subpixel_bits},
                {"color_bits", bits},
                {"depth_bits", asked.profile.depth_bits},
                {"area2", ref::area2(window[0], window[1], window[2])},
                {"covered", Json::array()},
                {"order", Json::array()},
                {"sides", Json::array()},
                {"steps", Json::array()}};
    for (const ref::Corner& corner : corners)
        answer["corners"].push_back({{"x", corner.window.x},
                                     {"y", corner.window.y},
                                     {"z", corner.window.z},
                                     {"color", corner.color}});
    for (const auto& seen : fragments.all) {
        answer["covered"].push_back({seen.fragment.x, seen.fragment.y});
        if (seen.fragment.x == x && seen.fragment.y == y) answer["machine"] = seen_json(seen);
    }
    if (answer["area2"] == 0) return answer;

    const ref::SnappedTriangle t = ref::snapped_triangle(window, {}, asked.profile.subpixel_bits);
    answer["order"] = t.source;
    for (std::size_t i = 0; i < 3; ++i) {
        const ref::Side side = ref::side_at(t, i, x, y);
        answer["sides"].push_back(
            {{"dx", side.dx}, {"dy", side.dy}, {"top_left", side.top_left}, {"e", side.e}});
    }
    const ref::Interpolants values = ref::interpolants(
        corners,
        [&](const std::array<std::int64_t, 3>& a) {
            return ref::plane_through(t, {a[t.source[0]], a[t.source[1]], a[t.source[2]]});
        },
        state, asked.profile, {asked.texture ? ref::TextureUse::Plain : ref::TextureUse::None});
    answer["depth"] = plane_json("Z", values.depth, x, y);
    answer["steps"] = steps_json(values.depth, std::max(0, x - 3), x, y);
    const bool inside = ref::covers(t, x, y);
    answer["inside"] = inside;
    if (!inside) return answer;  // a plane ends with its triangle

    static constexpr const char* channels[] = {"R", "G", "B", "A"};
    const auto& color_planes =
        values.perspective_color ? values.color.numerator : values.color.plane;
    for (std::size_t c = 0; c < 4; ++c)
        answer["color_planes"].push_back(plane_json(channels[c], color_planes[c], x, y));
    answer["perspective"] = values.perspective_color;
    Rgba color = ref::color_at(values, values.color, x, y, bits);
    answer["color"] = color;
    if (asked.texture) {
        const Texels texels = make_texels(*asked.texture, texel_bits_of(asked.profile));
        answer["texture"] = texture_json(values, texels, state, x, y);
        const Rgba texel = ref::texel_at(values, 0, texels, state, x, y);
        color = texture_environment(state.state.texture, texels.format, color, texel,
                                    state.env_color, bits);
    }
    answer["shaded"] = color;
    const Rgba stored = quantize_color(asked.clear.color, bits);
    if (state.state.blend.enable)
        answer["blend"] = blend_json(state.state.blend, color, stored, bits);
    return answer;
}

const Method pixel_methods[] = {
    {"pixel", &LabSession::pixel, {{"picture", &LabSession::picture}}},
};

}  // namespace gw::lab
