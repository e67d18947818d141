// NURBS: curves, and surfaces with trimming loops, as polygons with their normals.
#include "irisgl/draw/nurbs.h"
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace gw::irisgl::calls {

namespace {

constexpr long highest_order = 8;
constexpr std::size_t most_steps = 64;

enum class Kind : std::uint8_t { Parameters, Position, Texture, Color };

/// What bgnsurface .. endsurface or bgncurve .. endcurve have so far.
struct Definition {
    bool in_surface = false, in_curve = false, in_trim = false;
    std::map<Kind, NurbsSurface> surfaces;
    std::map<Kind, NurbsCurve> curves;
    TrimLoops loops;
};

Definition& definition() {
    static Definition& one = *new Definition;
    return one;
}

std::map<long, float>& properties() {
    static auto& one = *new std::map<long, float>{
        {N_PIXEL_TOLERANCE, 50}, {N_CULLING, 0}, {N_DISPLAY, N_FILL}, {N_ERRORCHECKING, 0},
        {N_SUBDIVISIONS, 6},     {N_S_STEPS, 6}, {N_T_STEPS, 6},      {N_TILES, 0}};
    return one;
}

Kind kind_of(long type) { return Kind(type >> 6 & 3); }

bool is_type(const char* function, long type) {
    for (const long known : {N_ST, N_STW, N_XYZ, N_XYZW, N_TEX, N_TEXW, N_RGBA, N_RGBAW})
        if (type == known) return true;
    warn(std::string(function) + ": type " + std::to_string(type) +
         " is not known; expected N_XYZ or another of its kind; it is ignored");
    return false;
}

ControlPoint control_at(Values values, std::size_t at, long type) {
    ControlPoint p{0, 0, 0, 1, 1};
    const std::size_t size = std::size_t(nurbs_size(type));
    const bool rational = (type & 3) != 0;
    for (std::size_t i = 0; i < size; ++i)
        p[rational && i + 1 == size ? 4 : i] = double(values[at + i]);
    // A position without a fourth coordinate has 1, which the weight divides too.
    if (rational && kind_of(type) != Kind::Color) p[3] = p[4];
    return p;
}

/// False, with a warning: the knots go down, or are too few for the order.
bool are_knots(const char* function, Values knots, long order) {
    const bool sorted = std::is_sorted(knots.begin(), knots.end());
    const bool finite =
        std::all_of(knots.begin(), knots.end(), [](float k) { return std::isfinite(k); });
    const auto n = long(knots.size());
    if (sorted && finite && order >= 2 && order <= highest_order && n >= 2 * order &&
        knots[std::size_t(order - 1)] < knots[std::size_t(n - order)])
        return true;
    warn(std::string(function) + ": order " + std::to_string(order) + " with " + std::to_string(n) +
         " knots; expected an order of 2 to 8, twice as many knots, and none below the one before; "
         "it is ignored");
    return false;
}

bool is_stride(const char* function, long stride) {
    if (stride > 0 && stride % 8 == 0) return true;
    warn(std::string(function) + ": stride " + std::to_string(stride) +
         "; expected bytes of whole doubles; it is ignored");
    return false;
}

double distance(const dvec4& a, const dvec4& b) {
    const auto p = window_from_object(a), q = window_from_object(b);
    return p && q ? std::hypot(p->x - q->x, p->y - q->y) : 0;
}

dvec4 place(const ControlPoint& c) {
    const double w = c[4] != 0 ? c[4] : 1;
    return {c[0] / w, c[1] / w, c[2] / w, 1};
}

/// Steps between two knots, so that none is longer than the tolerance on the screen.
std::size_t steps_for(double pixels, std::size_t spans, std::size_t order) {
    const double tolerance = std::max(1.0, double(properties()[N_PIXEL_TOLERANCE]));
    const double steps = std::ceil(pixels / tolerance / double(std::max<std::size_t>(spans, 1)));
    const std::size_t least = order > 2 ? order : 1;
    return std::clamp(steps < double(most_steps) ? std::size_t(steps) : most_steps, least,
                      most_steps);
}

std::size_t spans_of(const std::vector<double>& knots, std::size_t order) {
    return parameters(knots, order, 1).size() - 1;
}

/// The longest row or column of control points, in pixels.
double length_of(const NurbsSurface& surface, bool along_s) {
    const std::size_t rows = along_s ? surface.t_count() : surface.s_count(),
                      count = along_s ? surface.s_count() : surface.t_count();
    const auto at = [&](std::size_t row, std::size_t i) {
        return place(
            surface.control[along_s ? i * surface.t_count() + row : row * surface.t_count() + i]);
    };
    double longest = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        double length = 0;
        for (std::size_t i = 0; i + 1 < count; ++i) length += distance(at(row, i), at(row, i + 1));
        longest = std::max(longest, length);
    }
    return longest;
}

vec4 colour(const dvec4& c) { return {float(c.x), float(c.y), float(c.z), float(c.w)}; }

Vertex vertex_on(const std::map<Kind, NurbsSurface>& all, double s, double t) {
    const SurfacePoint at = point_of(all.at(Kind::Position), s, t);
    Vertex v = vertex_here(at.p.x, at.p.y, at.p.z);
    const dvec3 n = cross3({at.ds.x, at.ds.y, at.ds.z}, {at.dt.x, at.dt.y, at.dt.z});
    v.normal = {float(n.x), float(n.y), float(n.z)};
    v.is_lit = state().bound.is_lit();
    if (const auto c = all.find(Kind::Color); c != all.end())
        v.rgb = colour(point_of(c->second, s, t).p);
    if (const auto x = all.find(Kind::Texture); x != all.end()) {
        const dvec4 p = point_of(x->second, s, t).p;
        v.texture = {float(p.x), float(p.y), 0, 1};
    }
    return v;
}

void draw_surface(const Definition& d) {
    const NurbsSurface& shape = d.surfaces.at(Kind::Position);
    const auto grid = [](const std::vector<double>& knots, std::size_t order, double length) {
        return parameters(knots, order, steps_for(length, spans_of(knots, order), order));
    };
    const float display = properties()[N_DISPLAY];
    const auto s = grid(shape.s_knots, shape.s_order, length_of(shape, true)),
               t = grid(shape.t_knots, shape.t_order, length_of(shape, false));
    const bool patches = display == float(N_OUTLINE_PATCH);
    const auto cells = patches ? trimmed({s.front(), s.back()}, {t.front(), t.back()}, d.loops)
                               : trimmed(s, t, d.loops);
    for (const auto& cell : cells) {
        std::vector<Vertex> vertices;
        for (const dvec2& p : cell) vertices.push_back(vertex_on(d.surfaces, p.x, p.y));
        draw_shape(display == float(N_FILL) ? Shape::Polygon : Shape::ClosedLine, vertices);
    }
}

std::vector<dvec2> points_of_trim(const NurbsCurve& curve) {
    std::vector<dvec2> out;
    for (const double u : parameters(curve.knots, curve.order, curve.order > 2 ? 10 : 1)) {
        const dvec4 p = point_of(curve, u);
        out.push_back({p.x, p.y});
    }
    return out;
}

void add_to_loop(const std::vector<dvec2>& points) {
    auto& loop = definition().loops.back();
    for (const dvec2& p : points)
        if (std::isfinite(p.x) && std::isfinite(p.y) && (loop.empty() || loop.back() != p))
            loop.push_back(p);
}

void draw_curve(const Definition& d) {
    const NurbsCurve& curve = d.curves.at(Kind::Position);
    double length = 0;
    for (std::size_t i = 0; i + 1 < curve.control.size(); ++i)
        length += distance(place(curve.control[i]), place(curve.control[i + 1]));
    std::vector<Vertex> vertices;
    const std::size_t steps =
        steps_for(length * 5, spans_of(curve.knots, curve.order), curve.order);
    for (const double u : parameters(curve.knots, curve.order, steps)) {
        const dvec4 p = point_of(curve, u);
        vertices.push_back(vertex_here(p.x, p.y, p.z));
        if (const auto c = d.curves.find(Kind::Color); c != d.curves.end())
            vertices.back().rgb = colour(point_of(c->second, u));
    }
    draw_shape(Shape::Line, vertices);
}

bool is_in(bool inside, const char* function, const char* expected) {
    if (!inside)
        warn(std::string(function) + ": expected " + expected + " before it; it is ignored");
    return inside;
}

}  // namespace

void bgnsurface() {
    definition() = {};
    definition().in_surface = true;
}

void endsurface() {
    Definition& d = definition();
    if (!is_in(d.in_surface, "endsurface", "bgnsurface")) return;
    if (is_in(d.surfaces.contains(Kind::Position), "endsurface", "nurbssurface")) {
        std::erase_if(d.loops, [](const auto& loop) { return loop.size() < 3; });
        draw_surface(d);
    }
    d = {};
}

void bgntrim() {
    Definition& d = definition();
    if (!is_in(d.in_surface, "bgntrim", "bgnsurface")) return;
    d.in_trim = true;
    d.loops.emplace_back();
}

void endtrim() {
    Definition& d = definition();
    if (!is_in(d.in_trim, "endtrim", "bgntrim")) return;
    d.in_trim = false;
    auto& loop = d.loops.back();
    if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
}

void bgncurve() {
    definition() = {};
    definition().in_curve = true;
}

void endcurve() {
    Definition& d = definition();
    if (!is_in(d.in_curve, "endcurve", "bgncurve")) return;
    if (is_in(d.curves.contains(Kind::Position), "endcurve", "nurbscurve")) draw_curve(d);
    d = {};
}

void nurbssurface(long, Values s_knots, long, Values t_knots, long s_stride, long t_stride,
                  Values control, long s_order, long t_order, long type) {
    if (!is_in(definition().in_surface, "nurbssurface", "bgnsurface") ||
        !is_type("nurbssurface", type) || !are_knots("nurbssurface", s_knots, s_order) ||
        !are_knots("nurbssurface", t_knots, t_order) || !is_stride("nurbssurface", s_stride) ||
        !is_stride("nurbssurface", t_stride))
        return;
    if (!is_in(!control.empty(), "nurbssurface", "control points")) return;
    NurbsSurface made{.s_order = std::size_t(s_order),
                      .t_order = std::size_t(t_order),
                      .s_knots = {s_knots.begin(), s_knots.end()},
                      .t_knots = {t_knots.begin(), t_knots.end()},
                      .control = {}};
    for (std::size_t i = 0; i < made.s_count(); ++i)
        for (std::size_t k = 0; k < made.t_count(); ++k)
            made.control.push_back(control_at(
                control, i * std::size_t(s_stride / 8) + k * std::size_t(t_stride / 8), type));
    definition().surfaces[kind_of(type)] = std::move(made);
}

void nurbscurve(long, Values knots, long stride, Values control, long order, long type) {
    Definition& d = definition();
    if (!is_in(d.in_trim || d.in_curve, "nurbscurve", "bgntrim or bgncurve") ||
        !is_type("nurbscurve", type) || !are_knots("nurbscurve", knots, order) ||
        !is_stride("nurbscurve", stride) ||
        !is_in(!control.empty(), "nurbscurve", "control points"))
        return;
    NurbsCurve made{
        .order = std::size_t(order), .knots = {knots.begin(), knots.end()}, .control = {}};
    for (std::size_t i = 0; i < knots.size() - std::size_t(order); ++i)
        made.control.push_back(control_at(control, i * std::size_t(stride / 8), type));
    if (d.in_trim)
        add_to_loop(points_of_trim(made));
    else
        d.curves[kind_of(type)] = std::move(made);
}

void pwlcurve(long n, Values data, long stride, long type) {
    if (!is_in(definition().in_trim, "pwlcurve", "bgntrim") || !is_type("pwlcurve", type) ||
        !is_stride("pwlcurve", stride) || !is_in(!data.empty(), "pwlcurve", "points"))
        return;
    std::vector<dvec2> points;
    for (long i = 0; i < n; ++i) {
        const std::size_t at = std::size_t(i * (stride / 8));
        points.push_back({double(data[at]), double(data[at + 1])});
    }
    add_to_loop(points);
}

void setnurbsproperty(long property, float value) {
    if (!properties().contains(property) || !std::isfinite(value))
        return warn("setnurbsproperty: property " + std::to_string(property) +
                    " is not known; it is ignored");
    properties()[property] = value;
}

void getnurbsproperty(long property, float* value) {
    const auto found = properties().find(property);
    *value = found != properties().end() ? found->second : 0;
}

}  // namespace gw::irisgl::calls
