// Programs of display lists: nested with matrices, smooth meshes, many changes of state.
#include "bench/programs/program.h"
#include "bench/programs/shapes.h"

#include <memory>

namespace gw::bench {

namespace {

constexpr GLuint part = 1, arm = 2, crowd = 3;

/// An arm of parts, a crowd of arms: lists call lists between their matrices.
void begin_robots() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    light_scene(1);
    glEnable(GL_NORMALIZE);
    glNewList(part, GL_COMPILE);
    draw_torus(0.2f, 0.5f, 8, 12);
    glEndList();
    glNewList(arm, GL_COMPILE);
    for (int i = 0; i < 5; ++i) {
        glPushMatrix();
        glTranslatef(0, 0.5f * float(i), 0);
        glRotatef(30 * float(i), 0, 1, 0);
        glScalef(0.5f, 0.5f, 0.5f);
        glCallList(part);
        glPopMatrix();
    }
    glEndList();
    glNewList(crowd, GL_COMPILE);
    for (int i = 0; i < 36; ++i) {
        glPushMatrix();
        glTranslatef(float(i % 6) - 2.5f, 0, float(i / 6) - 2.5f);
        glCallList(arm);
        glPopMatrix();
    }
    glEndList();
}

void draw_robots(int frame) {
    look_from(9, 1);
    glRotatef(25, 1, 0, 0);
    glRotatef(2 * float(frame), 0, 1, 0);
    clear_all();
    glCallList(crowd);
}

void begin_spheres() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    light_scene(3);
    glNewList(part, GL_COMPILE);
    draw_torus(0.4f, 1, 60, 120);
    glEndList();
}

void draw_spheres(int frame) {
    look_from(6);
    clear_all();
    for (const float side : {-1.2f, 1.2f}) {
        glPushMatrix();
        glTranslatef(side, 0, 0);
        glRotatef(2 * float(frame), 1, side, 0);
        glCallList(part);
        glPopMatrix();
    }
}

/// A drawing program's view: each of 1,000 boxes sets materials, modes and matrices.
void draw_states(int frame) {
    look_from(14);
    glRotatef(float(frame), 0, 1, 0);
    clear_all();
    Numbers numbers(5);
    for (int i = 0; i < 1000; ++i) {
        const float color[] = {numbers.next(), numbers.next(), numbers.next(), 0.7f};
        glPushMatrix();
        glTranslatef(numbers.between(-5, 5), numbers.between(-5, 5), numbers.between(-5, 5));
        glRotatef(360 * numbers.next(), 1, 1, 0);
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
        if (i % 4 == 0) glEnable(GL_BLEND);
        if (i % 8 == 0) glShadeModel(GL_FLAT);
        glCallList(part);
        if (i % 8 == 0) glShadeModel(GL_SMOOTH);
        if (i % 4 == 0) glDisable(GL_BLEND);
        glPopMatrix();
    }
}

void begin_states() {
    glEnable(GL_DEPTH_TEST);
    light_scene(1);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glNewList(part, GL_COMPILE);
    glBegin(GL_QUADS);
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            float n[3] = {}, v[3] = {};
            n[axis] = side, v[axis] = 0.3f * side;
            glNormal3fv(n);
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            for (const int corner : {0, 1, 3, 2}) {
                v[a] = corner % 2 == 0 ? -0.3f : 0.3f, v[b] = corner / 2 == 0 ? -0.3f : 0.3f;
                glVertex3fv(v);
            }
        }
    glEnd();
    glEndList();
}

/// Wire frames and points, as of a modeller.
void begin_wires() {
    glNewList(part, GL_COMPILE);
    draw_torus(0.5f, 1.2f, 24, 48);
    glEndList();
    glEnable(GL_DEPTH_TEST);
    glPointSize(3);
}

void draw_wires(int frame) {
    look_from(4);
    glRotatef(2 * float(frame), 1, 1, 0);
    clear_all();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(0.2f, 0.8f, 0.3f);
    glCallList(part);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glColor3f(1, 1, 1);
    glCallList(part);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace

std::vector<Program> list_programs() {
    return {
        {"robots", "nested lists, 180 matrices", begin_robots, draw_robots},
        {"smooth", "two lit tori of 14,400 triangles, three lights", begin_spheres, draw_spheres},
        {"states", "1,000 boxes, each with material, modes and matrix", begin_states, draw_states},
        {"wires", "lines and points of polygons", begin_wires, draw_wires}};
}

}  // namespace gw::bench
