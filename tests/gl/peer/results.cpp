#include "tests/gl/peer/results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace gw::gl_peer {

namespace {

constexpr double depth_bound = 1e-4;

template <class... Arguments>
std::string text(const char* format, Arguments... arguments) {
    std::array<char, 400> out{};
    std::snprintf(out.data(), out.size(), format, arguments...);
    return out.data();
}

bool is_near(double a, double b, double bound) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= bound * std::max({1.0, std::abs(a), std::abs(b)});
}

struct Sides {
    const Picture &a, &b;
    int color_bound;
};

std::size_t index_of(int x, int y) { return std::size_t(y * window_width + x); }

/// Pixel i of a picture and pixel j of another.
bool is_same_pixel(const Picture& a, std::size_t i, const Picture& b, std::size_t j,
                   int color_bound) {
    for (std::size_t k = 0; k < 4; ++k)
        if (std::abs(a.color[i][k] - b.color[j][k]) > color_bound) return false;
    return is_near(double(a.depth[i]), double(b.depth[j]), depth_bound) &&
           a.stencil[i] == b.stencil[j];
}

/// Whether a neighbour of (x, y) in `other` looks like the pixel in `one`. Depths of neighbours
/// differ by their slope, so only colour and stencil count.
bool has_equal_neighbour(const Picture& one, const Picture& other, int x, int y, int color_bound) {
    const std::size_t i = index_of(x, y);
    for (int v = std::max(0, y - 1); v <= std::min(window_height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(window_width - 1, x + 1); ++u) {
            const std::size_t j = index_of(u, v);
            bool same = one.stencil[i] == other.stencil[j];
            for (std::size_t k = 0; k < 4; ++k)
                same &= std::abs(one.color[i][k] - other.color[j][k]) <= 8 * color_bound;
            if (same) return true;
        }
    return false;
}

std::string described(const Picture& a, const Picture& b, int x, int y) {
    const std::size_t i = index_of(x, y);
    const auto &p = a.color[i], &q = b.color[i];
    return text("pixel %d %d: %d %d %d %d depth %.7f stencil %d; %d %d %d %d depth %.7f stencil %d",
                x, y, p[0], p[1], p[2], p[3], double(a.depth[i]), a.stencil[i], q[0], q[1], q[2],
                q[3], double(b.depth[i]), b.stencil[i]);
}

void compare_pictures(Difference& out, const Sides& s) {
    const auto& [a, b, bound] = s;
    int edges = 0, wrong = 0;
    std::string description;
    for (int y = 0; y < window_height; ++y)
        for (int x = 0; x < window_width; ++x) {
            const std::size_t i = index_of(x, y);
            if (is_same_pixel(a, i, b, i, bound)) continue;
            const bool is_edge =
                has_equal_neighbour(a, b, x, y, bound) && has_equal_neighbour(b, a, x, y, bound);
            ++(is_edge ? edges : wrong);
            if (description.empty() || !is_edge) description = described(a, b, x, y);
        }
    if (out.first.empty() && (edges > most_edge_pixels || wrong > most_wrong_pixels))
        out.first = text("%d pixels of edges, %d others: %s", edges, wrong, description.c_str());
    out.wrong_pixels = std::max(out.wrong_pixels, wrong);
    out.edge_pixels = std::max(out.edge_pixels, edges);
}

/// Whether `all` has a record near `one`.
bool has_record(const Values& all, const double* one) {
    for (std::size_t at = 0; at + all.record <= all.values.size(); at += all.record)
        if (std::equal(one, one + all.record, all.values.data() + at,
                       [&](double x, double y) { return is_near(x, y, all.bound); }))
            return true;
    return false;
}

void compare_sets(Difference& out, const Values& a, const Values& b) {
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t at = 0; at + one->record <= one->values.size(); at += one->record)
            if (!has_record(*other, one->values.data() + at)) {
                out.first = text("%s: %s has no %.9g %.9g ...", a.what.c_str(),
                                 other == &a ? "the first" : "the second", one->values[at],
                                 one->values[at + 1]);
                return;
            }
}

void compare_values(Difference& out, const Values& a, const Values& b) {
    if (a.record != 0) return compare_sets(out, a, b);
    if (a.values.size() != b.values.size()) {
        out.first = text("%s: %zu values; %zu", a.what.c_str(), a.values.size(), b.values.size());
        return;
    }
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (!is_near(a.values[i], b.values[i], a.bound)) {
            out.first = text("%s [%zu]: %.9g; %.9g", a.what.c_str(), i, a.values[i], b.values[i]);
            return;
        }
}

}  // namespace

Picture picture_of(const Gl& gl) {
    constexpr std::size_t area = std::size_t(window_width) * window_height;
    Picture out{std::vector<std::array<GLubyte, 4>>(area), std::vector<GLfloat>(area),
                std::vector<GLubyte>(area)};
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (const GLenum name : {GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                              GL_PACK_SKIP_PIXELS, GL_PACK_LSB_FIRST})
        gl.PixelStorei(name, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (const GLenum name : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS,
                              GL_DEPTH_BIAS, GL_INDEX_SHIFT, GL_INDEX_OFFSET})
        gl.PixelTransferf(name, 0);
    for (const GLenum name :
         {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
        gl.PixelTransferf(name, 1);
    gl.PixelTransferi(GL_MAP_COLOR, 0);
    gl.PixelTransferi(GL_MAP_STENCIL, 0);
    gl.ReadPixels(0, 0, window_width, window_height, GL_RGBA, GL_UNSIGNED_BYTE, out.color.data());
    gl.ReadPixels(0, 0, window_width, window_height, GL_DEPTH_COMPONENT, GL_FLOAT,
                  out.depth.data());
    gl.ReadPixels(0, 0, window_width, window_height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                  out.stencil.data());
    gl.PopClientAttrib();
    gl.PopAttrib();
    return out;
}

Difference compare(const Results& a, const Results& b) {
    Difference out;
    for (std::size_t i = 0; i < std::min(a.values.size(), b.values.size()) && out.first.empty();
         ++i)
        compare_values(out, a.values[i], b.values[i]);
    for (std::size_t i = 0; i < std::min(a.pictures.size(), b.pictures.size()); ++i)
        compare_pictures(out, {a.pictures[i], b.pictures[i], a.color_bound});
    return out;
}

}  // namespace gw::gl_peer
