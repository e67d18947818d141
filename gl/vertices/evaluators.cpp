// Map1 .. EvalMesh2. [GL11] 5.1
#include "gl/state/evaluators.h"
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/vertices/begin_end.h"

#include "gw/stages/vertex.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace gw::gl {

namespace {

/// A mesh of more points is an error.
constexpr std::int64_t most_mesh_points = std::int64_t{1} << 24;

bool is_too_large(GLint i1, GLint i2, GLint j1, GLint j2) {
    const std::int64_t i = std::max(std::int64_t{i2} - i1 + 1, std::int64_t{0});
    const std::int64_t j = std::max(std::int64_t{j2} - j1 + 1, std::int64_t{0});
    return i > most_mesh_points || j > most_mesh_points || i * j > most_mesh_points;
}

/// Calls `take(i)` for the integers of a range; its end may be the largest.
template <class Take>
void for_each_from_to(GLint first, GLint last, Take take) {
    for (std::int64_t i = first; i <= last; ++i) take(GLint(i));
}

/// The maps by their place in GL's order.
enum Target { ColorMap, IndexMap, NormalMap, Tex1, Tex2, Tex3, Tex4, Vertex3, Vertex4 };
/// The values that a point has beyond its own: (0, 0, 0, 1).
using Value = std::array<double, 4>;

/// The Bernstein polynomials B_i of degree order - 1 at t, by de Casteljau's triangle; their
/// derivatives too.
struct Basis {
    std::array<double, max_eval_order> value{}, slope{};
};
Basis basis(int order, double t) {
    Basis out;
    out.value[0] = 1;
    for (int degree = 1; degree < order; ++degree) {
        if (degree == order - 1)
            for (int i = 0; i <= degree; ++i)
                out.slope[std::size_t(i)] =
                    degree * ((i > 0 ? out.value[std::size_t(i - 1)] : 0.0) -
                              (i < degree ? out.value[std::size_t(i)] : 0.0));
        for (int i = degree; i >= 0; --i)
            out.value[std::size_t(i)] = (i > 0 ? t * out.value[std::size_t(i - 1)] : 0.0) +
                                        (i < degree ? (1 - t) * out.value[std::size_t(i)] : 0.0);
    }
    return out;
}

Value evaluate(const Map1& m, int size, double u) {
    const Basis b = basis(m.order, (u - m.u1) / (m.u2 - m.u1));
    Value out{0, 0, 0, 1};
    for (int k = 0; k < size; ++k) {
        double sum = 0;
        for (int i = 0; i < m.order; ++i)
            sum += b.value[std::size_t(i)] * m.points[std::size_t(i * size + k)];
        out[std::size_t(k)] = sum;
    }
    return out;
}

Value weighted(const Map2& m, int size, const std::array<double, max_eval_order>& u,
               const std::array<double, max_eval_order>& v) {
    Value out{0, 0, 0, 1};
    for (int k = 0; k < size; ++k) {
        double sum = 0;
        for (int i = 0; i < m.uorder; ++i)
            for (int j = 0; j < m.vorder; ++j)
                sum += u[std::size_t(i)] * v[std::size_t(j)] *
                       m.points[std::size_t((i * m.vorder + j) * size + k)];
        out[std::size_t(k)] = sum;
    }
    return out;
}

struct Surface {
    Basis u, v;
};
Surface surface(const Map2& m, double u, double v) {
    return {basis(m.uorder, (u - m.u1) / (m.u2 - m.u1)),
            basis(m.vorder, (v - m.v1) / (m.v2 - m.v1))};
}

Value evaluate(const Map2& m, int size, double u, double v) {
    const Surface s = surface(m, u, v);
    return weighted(m, size, s.u.value, s.v.value);
}

/// dp/du x dp/dv of a vertex map. [GL11] 5.1: of homogeneous points, of their quotients.
vec3 surface_normal(const Map2& m, int size, double u, double v) {
    const Surface s = surface(m, u, v);
    const Value p = weighted(m, size, s.u.value, s.v.value);
    Value du = weighted(m, size, s.u.slope, s.v.value);
    Value dv = weighted(m, size, s.u.value, s.v.slope);
    if (size < 4) du[3] = dv[3] = 0;
    const auto slope = [&](const Value& d) {
        return dvec3(d[0] * p[3] - p[0] * d[3], d[1] * p[3] - p[1] * d[3],
                     d[2] * p[3] - p[2] * d[3]);
    };
    return vec3(normalized(cross3(slope(du), slope(dv))));
}

vec4 as_vec4(const Value& v) { return {float(v[0]), float(v[1]), float(v[2]), float(v[3])}; }

/// The last enabled of maps `first` .. `last`; -1: none.
int last_enabled(const std::array<bool, map_count>& enable, int first, int last) {
    for (int i = last; i >= first; --i)
        if (enable[std::size_t(i)]) return i;
    return -1;
}

/// A vertex of the enabled maps' values; `value(map)` evaluates one.
template <class Evaluate>
void add_evaluated(Context& context, const std::array<bool, map_count>& enable, Evaluate value,
                   const vec3* normal) {
    AssembledVertex v = current_vertex(context.state.current);
    if (enable[ColorMap]) v.color = as_vec4(value(ColorMap));
    if (enable[NormalMap]) v.normal = vec3(as_vec4(value(NormalMap)));
    if (normal != nullptr) v.normal = *normal;
    if (const int map = last_enabled(enable, Tex1, Tex4); map >= 0)
        v.texcoord = as_vec4(value(map));
    const int map = last_enabled(enable, Vertex3, Vertex4);
    if (map < 0) return;
    v.position = as_vec4(value(map));
    add_vertex(context, v);
}

double grid_value(int i, int segments, double first, double last) {
    if (i == segments) return last;
    return first + i * ((last - first) / segments);
}
double grid1(const EvalState& s, int i) {
    return grid_value(i, s.grid1_segments, s.grid1_u1, s.grid1_u2);
}
void eval_grid_point(Context& context, int i, int j) {
    const EvalState& s = context.state.eval;
    execute::eval_coord2(context, grid_value(i, s.grid2_segments[0], s.grid2_u1, s.grid2_u2),
                         grid_value(j, s.grid2_segments[1], s.grid2_v1, s.grid2_v2));
}

template <class T>
Numbers packed_points(int size, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                      const T* points) {
    auto out = std::make_shared<std::vector<double>>();
    const auto valid = [&](GLint stride, GLint order) {
        return stride >= size && order >= 1 && order <= max_eval_order;
    };
    if (size == 0 || points == nullptr || !valid(ustride, uorder) || !valid(vstride, vorder))
        return out;
    for (std::ptrdiff_t i = 0; i < uorder; ++i)
        for (std::ptrdiff_t j = 0; j < vorder; ++j)
            for (int k = 0; k < size; ++k)
                out->push_back(double(points[i * ustride + j * vstride + k]));
    return out;
}

GLenum map_error(bool known, bool is_empty_domain, GLint stride, GLint order, int size) {
    if (!known) return GL_INVALID_ENUM;
    const bool valid = !is_empty_domain && stride >= size && order >= 1 && order <= max_eval_order;
    return valid ? GL_NO_ERROR : GL_INVALID_VALUE;
}

}  // namespace

Numbers control_points(GLenum target, GLint stride, GLint order, const GLfloat* points) {
    return packed_points(map_size(target), stride, order, stride, 1, points);
}
Numbers control_points(GLenum target, GLint stride, GLint order, const GLdouble* points) {
    return packed_points(map_size(target), stride, order, stride, 1, points);
}
Numbers control_points(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                       const GLfloat* points) {
    return packed_points(map_size(target), ustride, uorder, vstride, vorder, points);
}
Numbers control_points(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                       const GLdouble* points) {
    return packed_points(map_size(target), ustride, uorder, vstride, vorder, points);
}

namespace execute {

void map1(Context& context, GLenum target, double u1, double u2, GLint stride, GLint order,
          const Numbers& points) {
    if (context.state.texture.active != 0) return set_error(context, GL_INVALID_OPERATION);
    const GLenum error = map_error(is_map1(target), u1 == u2, stride, order, map_size(target));
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (points->empty()) return;
    context.evaluators.map1[target - GL_MAP1_COLOR_4] = {u1, u2, order, *points};
}

void map2(Context& context, GLenum target, double u1, double u2, GLint ustride, GLint uorder,
          double v1, double v2, GLint vstride, GLint vorder, const Numbers& points) {
    if (context.state.texture.active != 0) return set_error(context, GL_INVALID_OPERATION);
    const int size = map_size(target);
    for (const GLenum error : {map_error(is_map2(target), u1 == u2, ustride, uorder, size),
                               map_error(is_map2(target), v1 == v2, vstride, vorder, size)})
        if (error != GL_NO_ERROR) return set_error(context, error);
    if (points->empty()) return;
    context.evaluators.map2[target - GL_MAP2_COLOR_4] = {u1, u2, v1, v2, uorder, vorder, *points};
}

void eval_coord1(Context& context, double u) {
    const auto value = [&](int map) {
        return evaluate(context.evaluators.map1[std::size_t(map)], map_sizes[std::size_t(map)], u);
    };
    add_evaluated(context, context.state.eval.map1, value, nullptr);
}

void eval_coord2(Context& context, double u, double v) {
    const auto& enable = context.state.eval.map2;
    const auto value = [&](int map) {
        return evaluate(context.evaluators.map2[std::size_t(map)], map_sizes[std::size_t(map)], u,
                        v);
    };
    const int map = last_enabled(enable, Vertex3, Vertex4);
    if (!context.state.eval.auto_normal || map < 0)
        return add_evaluated(context, enable, value, nullptr);
    const vec3 normal = surface_normal(context.evaluators.map2[std::size_t(map)],
                                       map_sizes[std::size_t(map)], u, v);
    add_evaluated(context, enable, value, &normal);
}

void map_grid1(Context& context, GLint un, double u1, double u2) {
    if (un < 1) return set_error(context, GL_INVALID_VALUE);
    EvalState& s = context.state.eval;
    s.grid1_segments = un;
    s.grid1_u1 = u1;
    s.grid1_u2 = u2;
}

void map_grid2(Context& context, GLint un, double u1, double u2, GLint vn, double v1, double v2) {
    if (un < 1 || vn < 1) return set_error(context, GL_INVALID_VALUE);
    EvalState& s = context.state.eval;
    s.grid2_segments = {un, vn};
    s.grid2_u1 = u1;
    s.grid2_u2 = u2;
    s.grid2_v1 = v1;
    s.grid2_v2 = v2;
}

void eval_point1(Context& context, GLint i) { eval_coord1(context, grid1(context.state.eval, i)); }
void eval_point2(Context& context, GLint i, GLint j) { eval_grid_point(context, i, j); }

void eval_mesh1(Context& context, GLenum mode, GLint i1, GLint i2) {
    if (mode != GL_POINT && mode != GL_LINE) return set_error(context, GL_INVALID_ENUM);
    if (is_too_large(i1, i2, 0, 0)) return set_error(context, GL_OUT_OF_MEMORY);
    begin(context, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for_each_from_to(i1, i2, [&](GLint i) { eval_point1(context, i); });
    end(context);
}

void eval_mesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
    if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL)
        return set_error(context, GL_INVALID_ENUM);
    if (is_too_large(i1, i2, j1, j2)) return set_error(context, GL_OUT_OF_MEMORY);
    if (mode == GL_POINT) {
        begin(context, GL_POINTS);
        for_each_from_to(j1, j2, [&](GLint j) {
            for_each_from_to(i1, i2, [&](GLint i) { eval_grid_point(context, i, j); });
        });
        return end(context);
    }
    if (mode == GL_FILL) {
        if (j1 >= j2) return;
        return for_each_from_to(j1, j2 - 1, [&](GLint j) {
            begin(context, GL_QUAD_STRIP);
            for_each_from_to(i1, i2, [&](GLint i) {
                eval_grid_point(context, i, j);
                eval_grid_point(context, i, j + 1);
            });
            end(context);
        });
    }
    for_each_from_to(j1, j2, [&](GLint j) {
        begin(context, GL_LINE_STRIP);
        for_each_from_to(i1, i2, [&](GLint i) { eval_grid_point(context, i, j); });
        end(context);
    });
    for_each_from_to(i1, i2, [&](GLint i) {
        begin(context, GL_LINE_STRIP);
        for_each_from_to(j1, j2, [&](GLint j) { eval_grid_point(context, i, j); });
        end(context);
    });
}

}  // namespace execute

}  // namespace gw::gl
