// Feedback: what would be drawn, clipped and in window coordinates, as numbers in a buffer.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/include/gl/feed.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace gw::irisgl {

namespace {

constexpr long most_numbers = 0x80000 / 4;  ///< "on the VGX never above 0x80000 bytes"
constexpr float first_mark = 100'000;       ///< marks above it are places of characters
/// x y z w, r g b a, s t r q: a vertex of OpenGL's.
constexpr std::size_t vertex_length = 12;

struct Feedback {
    bool is_on = false;
    long size = 0;
    std::vector<GLfloat> raw;
    std::vector<dvec3> characters;
};

Feedback& state_of_feedback() {
    static Feedback& one = *new Feedback;
    return one;
}

/// The program's buffer: no more than its size is written.
struct Target {
    float* at;
    long size, count = 0;
    void put(double v) {
        if (count < size) at[count++] = float(v);
    }
};

/// x y z r g b a s t. In colour map mode, r to a are the index, which came as a texture coordinate.
void put_vertex(Target& to, std::span<const GLfloat> v) {
    to.put(double(v[0]) - 0.5);
    to.put(double(v[1]) - 0.5);
    to.put(std::floor(double(z_min) + double(v[2]) * double(z_max - z_min) + 0.5));
    const double q = v[11] != 0 ? double(v[11]) : 1, s = double(v[8]) / q, t = double(v[9]) / q;
    for (std::size_t i = 4; i < 8; ++i) to.put(draws_indices() ? s : double(v[i]) * 255);
    to.put(draws_indices() ? 0 : s);
    to.put(draws_indices() ? 0 : t);
}

void put_vertices(Target& to, double word, std::span<const GLfloat> all) {
    to.put(word);
    to.put(double(all.size() / vertex_length * 9));
    for (; all.size() >= vertex_length; all = all.subspan(vertex_length)) put_vertex(to, all);
}

void put_mark(Target& to, float mark) {
    if (mark < first_mark) {
        for (const double v : {FB_PASSTHROUGH, 1.0, double(mark)}) to.put(v);
        return;
    }
    const dvec3& p = state_of_feedback().characters[std::size_t(mark - first_mark)];
    for (const double v : {FB_CMOV, 3.0, p.x, p.y, p.z}) to.put(v);
}

void translate_feedback(Target& to, std::span<const GLfloat> raw) {
    while (!raw.empty()) {
        const auto word = GLenum(raw[0]);
        std::size_t from = 1, count = vertex_length;
        if (word == GL_POLYGON_TOKEN) {
            if (raw.size() < 2) return;
            from = 2;
            count = vertex_length * std::size_t(raw[1]);
        } else if (word == GL_LINE_TOKEN || word == GL_LINE_RESET_TOKEN) {
            count = 2 * vertex_length;
        } else if (word == GL_PASS_THROUGH_TOKEN) {
            count = 1;
        }
        if (from + count > raw.size()) return;
        const auto values = raw.subspan(from, count);
        if (word == GL_PASS_THROUGH_TOKEN)
            put_mark(to, values[0]);
        else if (word == GL_POINT_TOKEN)
            put_vertices(to, FB_POINT, values);
        else if (word == GL_POLYGON_TOKEN)
            put_vertices(to, FB_POLYGON, values);
        else if (word == GL_LINE_TOKEN || word == GL_LINE_RESET_TOKEN)
            put_vertices(to, FB_LINE, values);
        raw = raw.subspan(from + count);
    }
}

}  // namespace

bool gives_feedback() { return state_of_feedback().is_on; }

void mark_character(const dvec3& at) {
    Feedback& f = state_of_feedback();
    if (!f.is_on) return;
    glPassThrough(first_mark + float(f.characters.size()));
    f.characters.push_back(at);
}

namespace calls {

void feedback(void* buffer, long n) {
    Feedback& f = state_of_feedback();
    if (f.is_on || picks() || buffer == nullptr || n < 1)
        return warn(
            "feedback: feedback or picking has begun, or the buffer has no numbers; it is ignored");
    f = {.is_on = true, .size = std::min(n, most_numbers), .raw = {}, .characters = {}};
    f.raw.assign(std::size_t(f.size) * 2 + 64, 0);
    glFeedbackBuffer(GLsizei(f.raw.size()), GL_4D_COLOR_TEXTURE, f.raw.data());
    glRenderMode(GL_FEEDBACK);
}

long endfeedback(void* buffer) {
    Feedback& f = state_of_feedback();
    if (!f.is_on) {
        warn("endfeedback: no feedback has begun; it returns 0");
        return 0;
    }
    const GLint written = glRenderMode(GL_RENDER);
    f.is_on = false;
    const std::size_t count = written < 0 ? f.raw.size() : std::size_t(written);
    Target to{static_cast<float*>(buffer), buffer == nullptr ? 0 : f.size};
    translate_feedback(to, std::span<const GLfloat>(f.raw).first(count));
    f.raw = {};
    return written < 0 && buffer != nullptr ? f.size : to.count;
}

void passthrough(short token) {
    if (gives_feedback()) glPassThrough(float(token));
}

}  // namespace calls
}  // namespace gw::irisgl
