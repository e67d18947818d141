// Programs that give many vertices each frame: Begin to End, and client arrays.
#include "bench/programs/program.h"
#include "bench/programs/shapes.h"

#include <cmath>
#include <memory>

namespace gw::bench {

namespace {

void begin_depth() { glEnable(GL_DEPTH_TEST); }

/// A sheet of waves that move: all vertices are new in every frame.
void wave_vertex(float x, float y, float time) {
    const float z = 0.3f * std::sin(4 * x + time) * std::cos(3 * y + time);
    glColor3f(0.5f + z, 0.5f, 0.5f - z);
    glVertex3f(x, y, z);
}

void draw_waves(int frame) {
    constexpr int n = 100;
    look_from(4, 0);
    glRotatef(-50, 1, 0, 0);
    clear_all();
    const float time = 0.1f * float(frame);
    for (int i = 0; i < n; ++i) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int k = 0; k <= n; ++k)
            for (const int row : {i, i + 1})
                wave_vertex(4.0f * float(k) / n - 2, 4.0f * float(row) / n - 2, time);
        glEnd();
    }
}

/// Triangles one by one that stand still under a turning matrix.
void draw_cloud(int frame) {
    look_from(4);
    glRotatef(float(frame), 0, 1, 0);
    clear_all();
    Numbers numbers(3);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 8000; ++i) {
        const float x = numbers.between(-1.5f, 1.5f), y = numbers.between(-1.5f, 1.5f);
        const float z = numbers.between(-1.5f, 1.5f), s = 0.05f;
        glColor3f(numbers.next(), numbers.next(), numbers.next());
        glVertex3f(x, y, z);
        glVertex3f(x + s, y, z);
        glVertex3f(x, y + s, z);
    }
    glEnd();
}

/// A lit torus by Begin and End, with a colour of its own for each ring.
void draw_colored_torus(int frame) {
    look_from(4);
    glRotatef(2 * float(frame), 1, 1, 0);
    clear_all();
    draw_torus(0.5f, 1.2f, 40, 80);
}

Program array_program(const char* name, const char* what, bool by_elements) {
    const auto torus = std::make_shared<Torus>(make_torus(0.5f, 1.2f, 60, 120));
    const auto begin = [torus] {
        begin_depth();
        glEnable(GL_CULL_FACE);
        light_scene(1);
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_NORMAL_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, torus->positions.data());
        glNormalPointer(GL_FLOAT, 0, torus->normals.data());
    };
    const auto draw = [torus, by_elements](int frame) {
        look_from(4);
        glRotatef(2 * float(frame), 1, 1, 0);
        clear_all();
        const int count = int(torus->indices.size());
        if (by_elements)
            glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, torus->indices.data());
        else
            for (int ring = 0; ring + 1 < 120; ++ring)
                glDrawArrays(GL_TRIANGLE_STRIP, ring * 61, 61);
    };
    return {name, what, begin, draw};
}

/// Water: an array whose heights the program computes anew, and strips of its rows by indices.
struct Water {
    static constexpr int n = 80;
    std::vector<float> positions = std::vector<float>(std::size_t(n * n * 3));
    std::vector<unsigned short> indices;

    Water() {
        for (int i = 0; i + 1 < n; ++i)
            for (int k = 0; k + 1 < n; ++k)
                for (const int v : {i * n + k, i * n + k + 1, i * n + k + n + 1, i * n + k + n})
                    indices.push_back(static_cast<unsigned short>(v));
    }
    void move(float time) {
        for (int i = 0; i < n * n; ++i) {
            const float x = float(i % n) / n * 8 - 4, y = float(i / n) / n * 8 - 4;
            float* const at = &positions[std::size_t(i) * 3];
            at[0] = x, at[1] = 0.15f * std::sin(3 * x + time) * std::sin(2 * y - time), at[2] = y;
        }
    }
};

Program water_program() {
    const auto water = std::make_shared<Water>();
    const auto begin = [water] {
        begin_depth();
        make_bricks(128, true);
        glEnable(GL_TEXTURE_2D);
        for (const GLenum coordinate : {GL_S, GL_T}) {
            const float plane[] = {coordinate == GL_S ? 0.5f : 0, 0, coordinate == GL_T ? 0.5f : 0,
                                   0};
            glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
            glTexGenfv(coordinate, GL_OBJECT_PLANE, plane);
        }
        glEnable(GL_TEXTURE_GEN_S);
        glEnable(GL_TEXTURE_GEN_T);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, water->positions.data());
    };
    const auto draw = [water](int frame) {
        look_from(5, 1);
        glRotatef(20, 1, 0, 0);
        clear_all();
        water->move(0.1f * float(frame));
        glDrawElements(GL_QUADS, int(water->indices.size()), GL_UNSIGNED_SHORT,
                       water->indices.data());
    };
    return {"water", "moving vertex array, generated texture coordinates", begin, draw};
}

}  // namespace

std::vector<Program> vertex_programs() {
    const auto begin_torus = [] {
        begin_depth();
        light_scene(2);
        glEnable(GL_CULL_FACE);
    };
    return {{"waves", "immediate strips, 20,000 new vertices", begin_depth, draw_waves},
            {"cloud", "immediate triangles, 24,000 vertices of their own", begin_depth, draw_cloud},
            {"torus", "immediate lit strips, 6,480 vertices", begin_torus, draw_colored_torus},
            array_program("elements", "DrawElements, 14,400 lit triangles", true),
            array_program("arrays", "DrawArrays, 119 lit strips", false),
            water_program()};
}

}  // namespace gw::bench
