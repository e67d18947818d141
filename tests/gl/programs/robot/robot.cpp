// A robot simulator's picture with OpenGL 1.5: a floor of 200 x 200 quads that mirrors, spheres, a skin
// in buffers, two spots with shadow maps, a sky. Its calls are those of such programs, in their order.
// robot DOOR [SHADOW SKY WIDTH HEIGHT SAMPLES [PICTURE.ppm]] prints a digest of colours, depths and the numbers
// of bodies; the picture has their colours.
#include "tests/gl/programs/robot/scene.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace robot {

namespace {

template <class T>
std::uint64_t digest(const std::vector<T>& values) {
    std::uint64_t hash = 14695981039346656037u;
    for (const std::byte byte : std::as_bytes(std::span(values)))
        hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 1099511628211u;
    return hash;
}

void write(const std::string& file, const Scene& s, const std::vector<GLubyte>& colors) {
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << s.options.width << ' ' << s.options.height << "\n255\n";
    for (int y = s.options.height - 1; y >= 0; --y)
        out.write(reinterpret_cast<const char*>(&colors[std::size_t(3 * y * s.options.width)]),
                  3 * s.options.width);
}

}  // namespace

}  // namespace robot

int main(int count, char** arguments) {
    using namespace robot;
    if (count < 2) fail("expected a door: osmesa, egl or glx");
    Scene s;
    int* const numbers[] = {&s.options.shadow, &s.options.sky, &s.options.width, &s.options.height,
                            &s.options.samples};
    for (int i = 2; i < count && i < 7; ++i) *numbers[i - 2] = std::atoi(arguments[i]);
    open_scene(s, arguments[1]);
    draw_picture(s);
    const auto colors = read_colors(s);
    const auto depths = read_depths(s);
    draw_numbers(s);
    const auto found = read_colors(s);
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError()) {
        std::fprintf(stderr, "robot: OpenGL error 0x%x\n", error);
        return 1;
    }
    gl.Finish();
    std::printf("%016llx %016llx %016llx\n", static_cast<unsigned long long>(digest(colors)),
                static_cast<unsigned long long>(digest(depths)),
                static_cast<unsigned long long>(digest(found)));
    if (count > 7) write(arguments[7], s, colors);
}
