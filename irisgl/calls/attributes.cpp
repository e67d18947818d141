// Lines, patterns, polygons: how they are drawn.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <string>

namespace gw::irisgl::calls {

void concave(Boolean on) { state().concave = on != 0; }

void polymode(long mode) {
    if (mode < PYM_FILL || mode > PYM_LINE_FAST)
        return warn("polymode: mode " + std::to_string(mode) +
                    "; expected PYM_POINT, PYM_LINE, "
                    "PYM_FILL or PYM_HOLLOW; it is ignored");
    state().polygon_mode = mode;
    apply_polygons();
}

void backface(Boolean on) {
    state().backface = on != 0;
    apply_polygons();
}
void frontface(Boolean on) {
    state().frontface = on != 0;
    apply_polygons();
}
void line_width(double width) {
    state().now.line_width = std::max(width, 0.0);
    apply_lines();
}
void point_size(double size) {
    state().now.point_size = std::max(size, 0.0);
    apply_lines();
}
void linesmooth(unsigned long mode) {
    state().smooth.lines = mode != SML_OFF;
    apply_lines();
}
void pntsmooth(unsigned long mode) {
    state().smooth.points = mode != SMP_OFF;
    apply_lines();
}
void polysmooth(long mode) {
    state().smooth.polygons = mode != PYSM_OFF;
    apply_lines();
}
void subpixel(Boolean on) { state().subpixel = on != 0; }
void scrsubdivide(long mode, Values) {
    if (mode != 0)
        warn("scrsubdivide: the machine shades in perspective or not at all; it is ignored");
}

void deflinestyle(short index, Linestyle style) {
    if (index == 0) return warn("deflinestyle: style 0 is the solid one; it is ignored");
    program().linestyles[index] = style;
}

void setlinestyle(short index) {
    if (!program().linestyles.contains(index))
        return warn("setlinestyle: style " + std::to_string(index) +
                    " is not defined; it is ignored");
    state().now.linestyle = index;
    apply_lines();
}

void lsrepeat(long factor) {
    if (factor < 1 || factor > 255)
        return warn("lsrepeat: " + std::to_string(factor) + "; expected 1 to 255; it is ignored");
    state().now.linestyle_repeat = factor;
    apply_lines();
}

void lsbackup(Boolean on) {
    state().line_backup = on != 0;
    if (on != 0) warn("lsbackup: as on a VGX, lines end where they end; it is ignored");
}
void resetls(Boolean on) {
    state().line_reset = on != 0;
    if (on == 0) warn("resetls: as on a VGX, each line begins its style anew; it is ignored");
}

void defpattern(short index, short size, Values mask) {
    const bool is_size = size == 16 || size == 32 || size == 64;
    if (index == 0 || !is_size || mask.empty())
        return warn("defpattern: pattern " + std::to_string(index) + " of size " +
                    std::to_string(size) +
                    "; expected sizes 16, 32 or 64, not pattern 0; it is ignored");
    Pattern& pattern = program().patterns[index];
    pattern.size = size;
    pattern.rows.assign(mask.begin(), mask.end());
}

void setpattern(short index) {
    if (index != 0 && !program().patterns.contains(index))
        return warn("setpattern: pattern " + std::to_string(index) +
                    " is not defined; it is ignored");
    state().now.pattern = index;
    apply_pattern();
}

void glcompat(long mode, long value) {
    if (mode == GLC_OLDPOLYGON) program().are_polygons_old = value != 0;
    if (mode != GLC_ZRANGEMAP) return;
    program().are_depths_mapped = value != 0;
    if (program().current != nullptr) apply_depth();
}
long getlstyle() { return state().now.linestyle; }
long getlwidth() { return long(state().now.line_width); }
long getlsrepeat() { return state().now.linestyle_repeat; }
long getpattern() { return state().now.pattern; }
Boolean getbackface() { return state().backface; }
Boolean getlsbackup() { return state().line_backup; }
Boolean getresetls() { return state().line_reset; }

void shademodel(long model) {
    if (model != FLAT && model != GOURAUD)
        return warn("shademodel: " + std::to_string(model) +
                    "; expected FLAT or GOURAUD; it is ignored");
    state().now.shade_model = model;
    apply_polygons();
}
long getsm() { return state().now.shade_model; }

void pushattributes() {
    State& s = state();
    if (s.attribute_stack.size() >= attribute_stack_depth)
        return warn("pushattributes: the stack is full; it is ignored");
    s.attribute_stack.push_back(s.now);
}

void popattributes() {
    State& s = state();
    if (s.attribute_stack.empty()) return warn("popattributes: the stack is empty; it is ignored");
    s.now = s.attribute_stack.back();
    s.attribute_stack.pop_back();
    apply_all();
}

}  // namespace gw::irisgl::calls
