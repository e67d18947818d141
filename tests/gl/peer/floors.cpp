// gw-gl-floors: floors of one quad on which a texture repeats 2,000 and 100,000 times, on our libOSMesa
// and on Mesa's, against coordinates that are worked out in double at each pixel. Where a pixel's
// texel is certain (an eighth of a pixel and a 50th of a texel from all others), we must show it, and
// so must Mesa at 2,000 repeats. Exit 0: it is so; 1: an error; 3: it is not.
#include "tests/gl/peer/library.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <vector>

namespace gw::gl_peer {
namespace {

constexpr int width = 160, height = 120, side = 4;
constexpr double below = 2;  // the floor under the eye
constexpr double slope_x = 1, slope_y = 0.75;

using Pixel = std::array<GLubyte, 3>;

Pixel texel(int i, int j) { return {GLubyte(60 * i + 15), GLubyte(60 * j + 15), 128}; }

/// One repeat a unit; the eye above its middle, `at` repeats from the first.
std::vector<GLubyte> draw(const Gl& gl, double reach, double at) {
    std::vector<GLubyte> memory(std::size_t(4 * width * height));
    const OSMesaContext context = gl.create_context(OSMESA_RGBA, 24, 8, 0, nullptr);
    if (context == nullptr ||
        !gl.make_current(context, memory.data(), GL_UNSIGNED_BYTE, width, height))
        throw std::runtime_error("no context");
    std::vector<GLubyte> texels;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            for (const GLubyte channel : texel(i, j)) texels.push_back(channel);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    gl.Enable(GL_TEXTURE_2D);
    gl.Disable(GL_DITHER);
    gl.MatrixMode(GL_PROJECTION);
    gl.Frustum(-slope_x, slope_x, -slope_y, slope_y, 1, 4 * reach);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Begin(GL_QUADS);
    for (const auto& [x, z] : {std::pair(-reach, reach), std::pair(reach, reach),
                               std::pair(reach, -reach), std::pair(-reach, -reach)}) {
        gl.TexCoord2d(x + at, z + at);
        gl.Vertex3d(x, -below, z);
    }
    gl.End();
    gl.Finish();
    gl.make_current(nullptr, nullptr, 0, 0, 0);
    gl.destroy_context(context);
    return memory;
}

/// Which texel a coordinate meets, if those an eighth of a pixel away meet it too.
std::optional<int> certain(double value, double eighth) {
    constexpr double texels_off = 1.0 / 50;
    const double low = std::floor(side * (value - eighth) - texels_off),
                 high = std::floor(side * (value + eighth) + texels_off);
    if (low != high) return std::nullopt;
    return int(low - side * std::floor(low / side));
}

std::optional<Pixel> expected(int column, int row, double at) {
    const double x = (2 * (column + 0.5) / width - 1) * slope_x,
                 y = (2 * (row + 0.5) / height - 1) * slope_y;
    if (y >= 0) return std::nullopt;
    const double far = below / -y;  // along the line of sight
    const double pixel_y = 2 * slope_y / height, pixel_x = 2 * slope_x / width;
    const double per_row = far / -y * pixel_y;  // d far
    const auto i = certain(far * x + at, (far * pixel_x + std::abs(x) * per_row) / 8),
               j = certain(-far + at, per_row / 8);
    return i && j ? std::optional(texel(*i, *j)) : std::nullopt;
}

struct Count {
    int certain = 0, wrong = 0;
};

Count count(const std::vector<GLubyte>& shown, double at) {
    Count out;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto pixel = expected(column, row, at);
            if (!pixel) continue;
            ++out.certain;
            const GLubyte* found = &shown[std::size_t(4 * (row * width + column))];
            for (std::size_t k = 0; k < 3; ++k)
                if (std::abs(found[k] - (*pixel)[k]) > 8) {
                    ++out.wrong;
                    break;
                }
        }
    return out;
}

int compare(const std::string& ours, const std::string& mesa) {
    bool good = true;
    const Gl libraries[] = {load(ours), load(mesa)};
    for (const double repeats : {2000.0, 100000.0})
        for (const double at : {0.0, 0.375 * repeats + 0.5}) {
            const Count we = count(draw(libraries[0], repeats / 2, at), at),
                        they = count(draw(libraries[1], repeats / 2, at), at);
            fmt::print("{} repeats, {} from the first: {} pixels; wrong {}, on Mesa {}\n", repeats,
                       at, we.certain, we.wrong, they.wrong);
            good = good && we.certain > 1000 && we.wrong == 0;
            if (repeats == 2000) good = good && they.wrong == 0;
        }
    return good ? 0 : 3;
}

}  // namespace
}  // namespace gw::gl_peer

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: gw-gl-floors LIBRARY\n", stderr);
        return 2;
    }
    try {
        return gw::gl_peer::compare(arguments[1], GW_OSMESA_LIBRARY);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gw-gl-floors: {}\n", error.what());
        return 1;
    }
}
