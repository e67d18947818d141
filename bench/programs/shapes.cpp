#include "bench/programs/shapes.h"

#include "bench/programs/program.h"

#include <cmath>
#include <numbers>

namespace gw::bench {

namespace {

constexpr float turn = 2 * std::numbers::pi_v<float>;

void set_texture(int size, GLenum format, const std::vector<unsigned char>& texels, GLint level) {
    glTexImage2D(GL_TEXTURE_2D, level, GLint(format), size, size, 0, format, GL_UNSIGNED_BYTE,
                 texels.data());
}

GLuint bind_new_texture(GLenum min_filter) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GLint(min_filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return name;
}

struct TorusPoint {
    float position[3], normal[3], texcoord[2];
};

TorusPoint torus_point(float inner, float outer, float u, float v) {
    const float cu = std::cos(u * turn), su = std::sin(u * turn);
    const float cv = std::cos(v * turn), sv = std::sin(v * turn);
    const float r = outer + inner * cv;
    return {{r * cu, r * su, inner * sv}, {cv * cu, cv * su, sv}, {4 * u, 2 * v}};
}

}  // namespace

void look_from(float distance, float height) {
    glViewport(0, 0, window_width, window_height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    const double aspect = double(window_width) / window_height;
    glFrustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1, 200);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, -height, -distance);
}

void look_at_pixels() {
    glViewport(0, 0, window_width, window_height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, window_width, 0, window_height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void clear_all() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }

std::vector<unsigned char> noise_image(int size, unsigned seed) {
    Numbers numbers(seed);
    std::vector<unsigned char> texels;
    for (int i = 0; i < size * size * 4; ++i)
        texels.push_back(i % 4 == 3 ? 255 : static_cast<unsigned char>(255 * numbers.next()));
    return texels;
}

GLuint make_bricks(int size, bool mipmaps) {
    const GLuint name = bind_new_texture(mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    for (int level = 0; size >> level > 0; ++level) {
        if (level > 0 && !mipmaps) break;
        const int n = size >> level;
        Numbers numbers(7);
        std::vector<unsigned char> texels;
        for (int i = 0; i < n * n; ++i) {
            const int x = i % n, y = i / n;
            const bool mortar = (y * 8 / n * 4 + x * 8 / n) % 5 == 0;
            const float shade = (mortar ? 0.8f : 0.4f) + 0.2f * numbers.next();
            for (const float channel : {1.0f, 0.7f, 0.6f})
                texels.push_back(static_cast<unsigned char>(255 * shade * channel));
        }
        set_texture(n, GL_RGB, texels, level);
    }
    return name;
}

GLuint make_lightmap(int size) {
    const GLuint name = bind_new_texture(GL_LINEAR);
    std::vector<unsigned char> texels;
    for (int i = 0; i < size * size; ++i) {
        const float x = float(i % size) / float(size) - 0.5f,
                    y = float(i / size) / float(size) - 0.5f;
        texels.push_back(static_cast<unsigned char>(255 / (1 + 6 * (x * x + y * y))));
    }
    set_texture(size, GL_LUMINANCE, texels, 0);
    return name;
}

GLuint make_dot(int size) {
    const GLuint name = bind_new_texture(GL_LINEAR);
    std::vector<unsigned char> texels;
    for (int i = 0; i < size * size; ++i) {
        const float x = (float(i % size) + 0.5f) / float(size) * 2 - 1;
        const float y = (float(i / size) + 0.5f) / float(size) * 2 - 1;
        const float a = std::fmax(0.0f, 1 - x * x - y * y);
        texels.insert(texels.end(), {255, 255, 255, static_cast<unsigned char>(255 * a)});
    }
    set_texture(size, GL_RGBA, texels, 0);
    return name;
}

void light_scene(int lights) {
    const float ambient[] = {0.2f, 0.1f, 0.1f, 1}, diffuse[] = {0.8f, 0.5f, 0.3f, 1};
    const float specular[] = {0.6f, 0.6f, 0.6f, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
    glLoadIdentity();
    for (int i = 0; i < lights; ++i) {
        const GLenum light = GL_LIGHT0 + GLenum(i);
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const float position[] = {side * 3, 4, 5, i < 2 ? 0.0f : 1.0f};
        const float color[] = {0.9f, i % 2 == 0 ? 0.9f : 0.4f, 0.8f, 1};
        glLightfv(light, GL_POSITION, position);
        glLightfv(light, GL_DIFFUSE, color);
        glLightfv(light, GL_SPECULAR, color);
        glEnable(light);
    }
    glEnable(GL_LIGHTING);
}

void draw_torus(float inner, float outer, int sides, int rings) {
    for (int i = 0; i < rings; ++i) {
        glBegin(GL_QUAD_STRIP);
        for (int k = 0; k <= sides; ++k)
            for (const int ring : {i + 1, i}) {
                const TorusPoint p =
                    torus_point(inner, outer, float(ring) / float(rings), float(k) / float(sides));
                glNormal3fv(p.normal);
                glTexCoord2fv(p.texcoord);
                glVertex3fv(p.position);
            }
        glEnd();
    }
}

Torus make_torus(float inner, float outer, int sides, int rings) {
    Torus torus;
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k <= sides; ++k) {
            const TorusPoint p =
                torus_point(inner, outer, float(i) / float(rings), float(k) / float(sides));
            torus.positions.insert(torus.positions.end(), p.position, p.position + 3);
            torus.normals.insert(torus.normals.end(), p.normal, p.normal + 3);
            torus.texcoords.insert(torus.texcoords.end(), p.texcoord, p.texcoord + 2);
        }
    const unsigned row = unsigned(sides) + 1;
    for (unsigned i = 0; i < unsigned(rings); ++i)
        for (unsigned k = 0; k < unsigned(sides); ++k) {
            const unsigned a = i * row + k, b = a + row;
            torus.indices.insert(torus.indices.end(), {b, a, a + 1, b, a + 1, b + 1});
        }
    return torus;
}

}  // namespace gw::bench
