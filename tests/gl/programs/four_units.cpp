// A shadow map, a cube and a texture of three dimensions on four units at once, as a program draws them:
// four_units [PICTURE.ppm] ends with 0 if the pixels are those of the arithmetic below.
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace {

constexpr int size = 64;
using Color = std::array<GLubyte, 4>;

constexpr Color floor_color{200, 180, 160, 255};
constexpr Color toward_eye{30, 20, 60, 255}, toward_x{10, 90, 0, 255}, elsewhere{1, 2, 3, 255};
constexpr Color haze{250, 240, 128, 255};

GLubyte product(int a, int b) { return GLubyte((2 * a * b + 255) / 510); }
/// Floor colour times light, plus the cube's, times the haze.
Color expected(bool lit, const Color& reflected) {
    Color out{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = product(std::min(255, (lit ? floor_color[i] : 0) + reflected[i]), haze[i]);
    return out;
}

void nearest(GLenum target) {
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(target, filter, GL_NEAREST);
}

/// A square at a height above the floor.
void square(float x0, float y0, float x1, float y1, float z) {
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::array{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
        glMultiTexCoord2f(GL_TEXTURE0, x / size, y / size);
        glMultiTexCoord3f(GL_TEXTURE3, 0.5f, 0.5f, 0.75f);
        glVertex3f(x, y, z);
    }
    glEnd();
}
void scene() {
    glNormal3f(0, 0, 1);
    square(0, 0, size, size, -0.5f);
    glNormal3f(1, 0, 0);
    square(8, 24, 24, 40, 0.5f);
}

/// The light shines aslant: what is high is moved to the right.
void draw_shadow_map() {
    constexpr GLfloat shear[] = {1, 0, 0, 0, 0, 1, 0, 0, 8, 0, 1, 0, 0, 0, 0, 1};
    glLoadMatrixf(shear);
    glClear(GL_DEPTH_BUFFER_BIT);
    scene();
    glLoadIdentity();
    glActiveTexture(GL_TEXTURE1);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, size, size, 0);
    glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
}

void use_shadow_map() {
    glActiveTexture(GL_TEXTURE1);
    nearest(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    constexpr GLfloat planes[4][4] = {{1.0f / size, 0, 8.0f / size, 0},
                                      {0, 1.0f / size, 0, 0},
                                      {0, 0, -0.5f, 0.499f},
                                      {0, 0, 0, 1}};
    for (GLenum i = 0; i < 4; ++i) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(GL_S + i, GL_EYE_PLANE, planes[i]);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);  // previous times texture
    glEnable(GL_TEXTURE_2D);
}

void use_cube() {
    glActiveTexture(GL_TEXTURE2);
    for (GLenum face = 0; face < 6; ++face) {
        const Color& color = face == 0 ? toward_x : face == 4 ? toward_eye : elsewhere;
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 1, 1, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, color.data());
    }
    nearest(GL_TEXTURE_CUBE_MAP);
    for (GLenum i = 0; i < 3; ++i) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glEnable(GL_TEXTURE_CUBE_MAP);
}

void use_floor_and_haze() {
    glActiveTexture(GL_TEXTURE0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, floor_color.data());
    nearest(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE3);
    const std::array<Color, 2> slices{elsewhere, haze};
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 1, 1, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, slices.data());
    nearest(GL_TEXTURE_3D);
    glEnable(GL_TEXTURE_3D);
}

}  // namespace

int main(int count, char** arguments) {
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<Color> pixels(std::size_t(size) * size);
    if (!OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size)) return 2;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, size, 0, size, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
    // A texture for each unit: units share the one of name 0.
    for (GLenum unit = 0; unit < 4; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, unit + 1);
    }
    draw_shadow_map();
    use_floor_and_haze();
    use_shadow_map();
    use_cube();
    scene();
    glFinish();
    int wrong = glGetError() == GL_NO_ERROR ? 0 : 1;
    const auto expect = [&](int x, int y, const Color& color) {
        const Color& drawn = pixels[std::size_t(y * size + x)];
        if (drawn == color) return;
        std::fprintf(stderr, "pixel %d, %d: %d %d %d; expected %d %d %d\n", x, y, drawn[0],
                     drawn[1], drawn[2], color[0], color[1], color[2]);
        ++wrong;
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool beside = y >= 24 && y < 40;
            const bool on_square = beside && x >= 8 && x < 24, shadow = beside && x >= 24 && x < 32;
            expect(x, y, expected(!shadow, on_square ? toward_x : toward_eye));
        }
    if (count > 1) {
        std::ofstream out(arguments[1], std::ios::binary);
        out << "P6\n" << size << " " << size << "\n255\n";
        for (const Color& c : pixels) out.write(reinterpret_cast<const char*>(c.data()), 3);
    }
    OSMesaDestroyContext(context);
    return wrong == 0 ? 0 : 1;
}
