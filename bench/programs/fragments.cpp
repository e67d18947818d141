// Programs of blended and stencilled fragments.
#include "bench/programs/program.h"
#include "bench/programs/shapes.h"

#include <cmath>

namespace gw::bench {

namespace {

/// A fountain: quads that move, blended one over the other.
void begin_particles() {
    make_dot(32);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
}

void draw_particles(int frame) {
    look_from(5);
    clear_all();
    Numbers numbers(1);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4000; ++i) {
        const float age = std::fmod(numbers.next() + 0.01f * float(frame), 1.0f);
        const float direction = 6.28f * numbers.next(), speed = numbers.next();
        const float x = speed * age * std::cos(direction), z = speed * age * std::sin(direction);
        const float y = 4 * age - 4 * age * age - 1, s = 0.03f + 0.03f * age;
        glColor4f(1, 1 - age, 0.3f, 0.5f * (1 - age));
        glTexCoord2f(0, 0);
        glVertex3f(x - s, y - s, z);
        glTexCoord2f(1, 0);
        glVertex3f(x + s, y - s, z);
        glTexCoord2f(1, 1);
        glVertex3f(x + s, y + s, z);
        glTexCoord2f(0, 1);
        glVertex3f(x - s, y + s, z);
    }
    glEnd();
}

void begin_shadow() {
    glEnable(GL_DEPTH_TEST);
    glNewList(1, GL_COMPILE);
    draw_torus(0.3f, 0.8f, 24, 48);
    glEndList();
    light_scene(1);
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_NORMALIZE);
}

void draw_floor() {
    glNormal3f(0, 1, 0);
    glBegin(GL_QUADS);
    glVertex3f(-4, 0, 4);
    glVertex3f(4, 0, 4);
    glVertex3f(4, 0, -4);
    glVertex3f(-4, 0, -4);
    glEnd();
}

void draw_object(int frame) {
    glPushMatrix();
    glTranslatef(0, 1.3f, 0);
    glRotatef(3 * float(frame), 1, 1, 0);
    glCallList(1);
    glPopMatrix();
}

/// The floor marks the stencil; there the reflection and the shadow are drawn once.
void draw_shadow(int frame) {
    static constexpr float shadow_of_light[] = {1, 0, 0, 0, -0.7f, 0, -0.5f, 0,
                                                0, 0, 1, 0, 0,     0, 0,     1};
    look_from(5, 0.5f);
    glRotatef(20, 1, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);

    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    draw_floor();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);

    glStencilFunc(GL_EQUAL, 1, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glColor3f(0.8f, 0.4f, 0.3f);
    glPushMatrix();
    glScalef(1, -1, 1);
    draw_object(frame);
    glPopMatrix();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(0.5f, 0.6f, 0.5f, 0.7f);
    draw_floor();

    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glColor4f(0, 0, 0, 0.5f);
    glPushMatrix();
    glMultMatrixf(shadow_of_light);
    draw_object(frame);
    glPopMatrix();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glColor3f(0.8f, 0.4f, 0.3f);
    draw_object(frame);
}

}  // namespace

std::vector<Program> fragment_programs() {
    return {{"particles", "4,000 blended moving quads", begin_particles, draw_particles},
            {"shadow", "stencilled reflection and flat shadow", begin_shadow, draw_shadow}};
}

}  // namespace gw::bench
