// Picking and selecting: names of what is drawn near the cursor, or inside the volume.
#include "irisgl/draw/picking.h"
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gw::irisgl {

namespace {

struct Picking {
    bool is_on = false;
    bool has_overflow = false;
    long size = 0;  ///< of the program's buffer
    short width = 10, height = 10;
    dmat4 matrix{1};
    std::vector<GLuint> hits;
};

Picking& picking() {
    static Picking& one = *new Picking;
    return one;
}

void begin_picking(long n) {
    Picking& p = picking();
    p.is_on = true;
    p.size = n;
    p.hits.assign(std::size_t(1) << 16, 0);
    glSelectBuffer(GLsizei(p.hits.size()), p.hits.data());
    glRenderMode(GL_SELECT);
    glInitNames();
}

}  // namespace

const dmat4& picking_matrix() { return picking().matrix; }
bool picks() { return picking().is_on; }

namespace calls {

void picksize(short x, short y) {
    picking().width = std::max<short>(x, 1);
    picking().height = std::max<short>(y, 1);
}

// The region is centred at the cursor. [the manual's pick]
void pick(short*, long n) {
    if (picking().is_on || gives_feedback())
        return warn("pick: a pick or feedback has begun; expected its end; it is ignored");
    const Window& w = current_window();
    const Bounds& v = state().viewport;
    const auto cursor = [](unsigned device) { return program().events.valuators[device].value; };
    const double x = double(cursor(MOUSEX) - w.x - v.left) + 0.5;
    const double y = double(cursor(MOUSEY) - w.y - v.bottom) + 0.5;
    const double wide = double(picking().width), high = double(picking().height);
    dmat4 m(1);
    m[0][0] = v.width() / wide;
    m[1][1] = v.height() / high;
    m[3][0] = (v.width() - 2 * x) / wide;
    m[3][1] = (v.height() - 2 * y) / high;
    picking().matrix = m;
    begin_picking(n);
}

void gselect(short*, long n) {
    if (picking().is_on || gives_feedback())
        return warn("gselect: a pick or feedback has begun; expected its end; it is ignored");
    begin_picking(n);
}

// For each hit: the number of names, then the names from the bottom of the stack.
long endpick(short* buffer) {
    Picking& p = picking();
    if (!p.is_on) {
        warn("endpick: no pick has begun; it returns 0");
        return 0;
    }
    GLint hits = glRenderMode(GL_RENDER);
    p.is_on = false;
    p.matrix = dmat4(1);
    const bool overflow = hits < 0;
    if (overflow) hits = 1 << 15;
    long at = 0, count = 0;
    std::size_t from = 0;
    for (; count < hits && from + 3 <= p.hits.size(); ++count) {
        const long names = long(p.hits[from]);
        if (names == 0 && overflow && p.hits[from + 1] == 0) break;
        if (from + 3 + std::size_t(names) > p.hits.size()) break;
        if (buffer == nullptr || at + 1 + names > p.size) return -count;
        buffer[at++] = short(names);
        for (long i = 0; i < names; ++i) buffer[at++] = short(p.hits[from + 3 + std::size_t(i)]);
        from += 3 + std::size_t(names);
    }
    return overflow ? -count : count;
}

void initnames() { glInitNames(); }
void loadname(short name) {
    GLint depth = 0;
    glGetIntegerv(GL_NAME_STACK_DEPTH, &depth);
    if (depth == 0)
        glPushName(GLuint(std::uint16_t(name)));  // IRIS GL's stack has a name from the beginning
    else
        glLoadName(GLuint(std::uint16_t(name)));
}
void pushname(short name) { glPushName(GLuint(std::uint16_t(name))); }
void popname() { glPopName(); }

void bounding_box(long dx, long dy, double x1, double y1, double x2, double y2) {
    // An object outside the viewport or smaller than dx, dy is not drawn further.
    const auto a = window_from_object({x1, y1, 0, 1}), b = window_from_object({x2, y2, 0, 1});
    if (!a || !b) return;
    const Bounds& v = state().viewport;
    const bool outside = std::max(a->x, b->x) < v.left || std::min(a->x, b->x) > v.right + 1 ||
                         std::max(a->y, b->y) < v.bottom || std::min(a->y, b->y) > v.top + 1;
    const bool small = std::abs(a->x - b->x) < double(dx) && std::abs(a->y - b->y) < double(dy);
    if (outside || small) program().objects.is_pruned = true;
}

// The line that a point of the screen is, in the coordinates of an object of viewing commands.
void mapw(long obj, Screencoord x, Screencoord y, float* x1, float* y1, float* z1, float* x2,
          float* y2, float* z2) {
    pushmatrix();
    callobj(obj);
    const dmat4& m = state().matrices.back();
    const dmat4 back = glm::inverse(state().matrix_mode == MSINGLE ? m : state().projection * m);
    const Bounds& v = state().viewport;
    float* const out[] = {x1, y1, z1, x2, y2, z2};
    for (int end = 0; end < 2; ++end) {
        const dvec4 clip{2 * (x + 0.5 - v.left) / v.width() - 1,
                         2 * (y + 0.5 - v.bottom) / v.height() - 1, end == 0 ? -1 : 1, 1};
        const dvec4 p = back * clip;
        for (int i = 0; i < 3; ++i)
            if (out[3 * end + i] != nullptr) *out[3 * end + i] = float(p[i] / p.w);
    }
    popmatrix();
}

void mapw2(long obj, Screencoord x, Screencoord y, float* x1, float* y1) {
    mapw(obj, x, y, x1, y1, nullptr, nullptr, nullptr, nullptr);
}

}  // namespace calls
}  // namespace gw::irisgl
