// Coordinates: matrices, viewports.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include "gw/base/elementary.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace gw::irisgl::calls {

namespace {

/// The matrix that the matrix mode chooses.
dmat4& top() {
    State& s = state();
    if (s.matrix_mode == MPROJECTION) return s.projection;
    if (s.matrix_mode == MTEXTURE) return s.texture;
    return s.matrices.back();
}

dmat4 matrix_of(Values m) {
    dmat4 out(1);
    for (int i = 0; i < 16 && std::size_t(i) < m.size(); ++i)
        out[i / 4][i % 4] = double(m[std::size_t(i)]);
    return out;
}

void multiply(const dmat4& m) { top() = top() * m; }

/// Replaces the projection: in the mode MSINGLE the only matrix.
void project(const dmat4& m) {
    State& s = state();
    (s.matrix_mode == MSINGLE ? s.matrices.back() : s.projection) = picking_matrix() * m;
}

bool is_volume(const char* function, bool valid) {
    if (!valid) warn(std::string(function) + ": the volume is empty; it is ignored");
    return valid;
}

/// The eye at the origin, looking along -z; x and y of the near plane's middle, as shares of z.
dmat4 perspective_matrix(double x_scale, double y_scale, double x, double y, double near,
                         double far) {
    dmat4 m(0);
    m[0][0] = x_scale;
    m[1][1] = y_scale;
    m[2] = {x, y, -(far + near) / (far - near), -1};
    m[3][2] = -2 * far * near / (far - near);
    return m;
}

dmat4 frustum(double l, double r, double b, double t, double near, double far) {
    return perspective_matrix(2 * near / (r - l), 2 * near / (t - b), (r + l) / (r - l),
                              (t + b) / (t - b), near, far);
}

}  // namespace

void mmode(short mode) {
    if (mode < MSINGLE || mode > MTEXTURE)
        return warn("mmode: " + std::to_string(mode) +
                    "; expected MSINGLE, MVIEWING, MPROJECTION or MTEXTURE; it is ignored");
    State& s = state();
    if (s.matrix_mode == MSINGLE && mode != MSINGLE) s.matrices = {dmat4(1)};
    if (mode == MSINGLE && s.matrix_mode != MSINGLE) s.matrices = {dmat4(1)};
    s.matrix_mode = mode;
}
long getmmode() { return state().matrix_mode; }

void loadmatrix(Values m) { top() = matrix_of(m); }
void multmatrix(Values m) { multiply(matrix_of(m)); }
void getmatrix(float* m) {
    for (int i = 0; m != nullptr && i < 16; ++i) m[i] = float(top()[i / 4][i % 4]);
}

void pushmatrix() {
    State& s = state();
    if (s.matrix_mode == MPROJECTION || s.matrix_mode == MTEXTURE)
        return warn("pushmatrix: the matrix mode has no stack; it is ignored");
    if (s.matrices.size() >= matrix_stack_depth)
        return warn("pushmatrix: the stack of " + std::to_string(matrix_stack_depth) +
                    " matrices is full; it is ignored");
    s.matrices.push_back(s.matrices.back());
}

void popmatrix() {
    State& s = state();
    if (s.matrix_mode == MPROJECTION || s.matrix_mode == MTEXTURE)
        return warn("popmatrix: the matrix mode has no stack; it is ignored");
    if (s.matrices.size() == 1) return warn("popmatrix: the stack is empty; it is ignored");
    s.matrices.pop_back();
}

void translate(Coord x, Coord y, Coord z) {
    dmat4 m(1);
    m[3] = {double(x), double(y), double(z), 1};
    multiply(m);
}

void scale(float x, float y, float z) {
    dmat4 m(1);
    m[0][0] = double(x);
    m[1][1] = double(y);
    m[2][2] = double(z);
    multiply(m);
}

void turn(double degrees, char axis) {
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    const int a = axis == 'x' || axis == 'X' ? 1 : axis == 'y' || axis == 'Y' ? 2 : 0;
    if (a == 0 && axis != 'z' && axis != 'Z')
        return warn("rotate: the axis is none of 'x', 'y', 'z'; it is ignored");
    const int b = (a + 1) % 3;
    dmat4 m(1);
    m[a][a] = m[b][b] = c;
    m[a][b] = s;
    m[b][a] = -s;
    multiply(m);
}

void window(Coord left, Coord right, Coord bottom, Coord top_, Coord near_, Coord far_) {
    if (!is_volume("window", left != right && bottom != top_ && near_ != far_)) return;
    project(frustum(double(left), double(right), double(bottom), double(top_), double(near_),
                    double(far_)));
}

void perspective(Angle fovy, float aspect, Coord near_, Coord far_) {
    if (!is_volume("perspective", near_ != far_ && fovy > 0 && fovy < 1800 && aspect != 0)) return;
    const double cot = 1 / tan_degrees(fovy / 20.0);
    project(perspective_matrix(cot / double(aspect), cot, 0, 0, double(near_), double(far_)));
}

void ortho(Coord left, Coord right, Coord bottom, Coord top_, Coord near_, Coord far_) {
    if (!is_volume("ortho", left != right && bottom != top_ && near_ != far_)) return;
    const double l = double(left), r = double(right), b = double(bottom), t = double(top_),
                 n = double(near_), f = double(far_);
    dmat4 m(1);
    m[0][0] = 2 / (r - l);
    m[1][1] = 2 / (t - b);
    m[2][2] = -2 / (f - n);
    m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
    project(m);
}

void ortho2(Coord left, Coord right, Coord bottom, Coord top_) {
    ortho(left, right, bottom, top_, -1, 1);
}

void polarview(Coord distance, Angle azimuth, Angle incidence, Angle twist) {
    translate(0, 0, -distance);
    turn(-twist / 10.0, 'z');
    turn(-incidence / 10.0, 'x');
    turn(-azimuth / 10.0, 'z');
}

// rotate(-twist, z), then the turns that bring (vx - px, vy - py, vz - pz) to the z axis.
void lookat(Coord vx, Coord vy, Coord vz, Coord px, Coord py, Coord pz, Angle twist) {
    turn(-twist / 10.0, 'z');
    const double x = double(px) - double(vx), y = double(py) - double(vy),
                 z = double(pz) - double(vz);
    const double flat = std::sqrt(x * x + z * z), whole = std::sqrt(x * x + y * y + z * z);
    if (whole > 0) {
        dmat4 pitch(1);
        const double sine = -y / whole, cosine = flat / whole;
        pitch[1][1] = pitch[2][2] = cosine;
        pitch[1][2] = sine;
        pitch[2][1] = -sine;
        multiply(pitch);
    }
    if (flat > 0) {
        dmat4 yaw(1);
        const double sine = x / flat, cosine = -z / flat;
        yaw[2][2] = yaw[0][0] = cosine;
        yaw[2][0] = sine;
        yaw[0][2] = -sine;
        multiply(yaw);
    }
    translate(-vx, -vy, -vz);
}

void viewport(Screencoord left, Screencoord right, Screencoord bottom, Screencoord top_) {
    if (left > right || bottom > top_)
        return warn(
            "viewport: its sides are exchanged; expected left <= right and bottom <= top; it "
            "is ignored");
    state().viewport = state().screen_mask = {left, right, bottom, top_};
    apply_viewport();
}

void getviewport(short* left, short* right, short* bottom, short* top_) {
    const Bounds& v = state().viewport;
    *left = short(v.left);
    *right = short(v.right);
    *bottom = short(v.bottom);
    *top_ = short(v.top);
}

void pushviewport() {
    State& s = state();
    if (s.viewport_stack.size() >= viewport_stack_depth)
        return warn("pushviewport: the stack is full; it is ignored");
    s.viewport_stack.push_back({s.viewport, s.screen_mask});
}

void popviewport() {
    State& s = state();
    if (s.viewport_stack.empty()) return warn("popviewport: the stack is empty; it is ignored");
    s.viewport = s.viewport_stack.back()[0];
    s.screen_mask = s.viewport_stack.back()[1];
    s.viewport_stack.pop_back();
    apply_viewport();
}

void reshapeviewport() {
    const Window& w = current_window();
    viewport(0, short(w.width() - 1), 0, short(w.height() - 1));
}

void scrmask(Screencoord left, Screencoord right, Screencoord bottom, Screencoord top_) {
    if (left > right || bottom > top_)
        return warn("scrmask: its sides are exchanged; it is ignored");
    state().screen_mask = {left, right, bottom, top_};
    apply_viewport();
}

void getscrmask(short* left, short* right, short* bottom, short* top_) {
    const Bounds& m = state().screen_mask;
    *left = short(m.left);
    *right = short(m.right);
    *bottom = short(m.bottom);
    *top_ = short(m.top);
}

// Tenths of a degree. Either result may be left out.
void gl_sincos(Angle a, float* s, float* c) {
    if (s != nullptr) *s = float(sin_degrees(a / 10.0));
    if (c != nullptr) *c = float(cos_degrees(a / 10.0));
}

// One unit is a pixel, and the origin is the screen's lower left corner.
void screenspace() {
    const Window& w = current_window();
    viewport(short(-w.x), short(XMAXSCREEN - w.x), short(-w.y), short(YMAXSCREEN - w.y));
    ortho2(-0.5f, XMAXSCREEN + 0.5f, -0.5f, YMAXSCREEN + 0.5f);
}

void getgpos(float* x, float* y, float* z, float* w) {
    const dvec4 p = clip_from_object(state().position);
    *x = float(p.x);
    *y = float(p.y);
    *z = float(p.z);
    *w = float(p.w);
}

}  // namespace gw::irisgl::calls
