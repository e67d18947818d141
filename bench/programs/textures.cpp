// Programs of textured worlds.
#include "bench/programs/program.h"
#include "bench/programs/shapes.h"

#include <cmath>
#include <memory>

namespace gw::bench {

namespace {

GLuint walls = 0, light = 0;

/// A hall of pillars: every face by Begin and End, as the games did.
void draw_face(const float (&at)[3], int axis, float width, float height) {
    const int u = axis == 0 ? 2 : 0, v = axis == 1 ? 2 : 1;
    glBegin(GL_QUADS);
    for (const int corner : {0, 1, 3, 2}) {
        float p[3] = {at[0], at[1], at[2]};
        const int right = corner % 2, up = corner / 2;
        p[u] += width * float(right), p[v] += height * float(up);
        glTexCoord2f(width * float(right), height * float(up));
        glVertex3fv(p);
    }
    glEnd();
}

void draw_hall() {
    for (int i = -8; i < 8; ++i)
        for (int k = -8; k < 8; ++k) {
            draw_face({float(2 * i), 0, float(2 * k)}, 1, 2, 2);
            draw_face({float(2 * i), 4, float(2 * k)}, 1, 2, 2);
            if ((i + k) % 2 != 0) continue;
            draw_face({float(2 * i), 0, float(2 * k)}, 0, 0.5f, 4);
            draw_face({float(2 * i) + 0.5f, 0, float(2 * k)}, 0, 0.5f, 4);
            draw_face({float(2 * i), 0, float(2 * k)}, 2, 0.5f, 4);
            draw_face({float(2 * i), 0, float(2 * k) + 0.5f}, 2, 0.5f, 4);
        }
}

void begin_world() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    walls = make_bricks(256, true);
    light = make_lightmap(32);
    const float fog_color[] = {0.3f, 0.3f, 0.4f, 1};
    glFogfv(GL_FOG_COLOR, fog_color);
    glFogi(GL_FOG_MODE, GL_EXP);
    glFogf(GL_FOG_DENSITY, 0.08f);
    glClearColor(0.3f, 0.3f, 0.4f, 1);
}

void draw_world(int frame) {
    look_from(1, 1.7f);
    glRotatef(2 * float(frame), 0, 1, 0);
    clear_all();
    glEnable(GL_FOG);
    glBindTexture(GL_TEXTURE_2D, walls);
    draw_hall();
    // The light multiplies what the first pass has drawn.
    glDisable(GL_FOG);
    glBindTexture(GL_TEXTURE_2D, light);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    draw_hall();
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
}

void begin_mirror() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    light_scene(1);
    make_bricks(256, true);
    glEnable(GL_TEXTURE_2D);
    for (const GLenum coordinate : {GL_S, GL_T})
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glNewList(1, GL_COMPILE);
    draw_torus(0.5f, 1.2f, 40, 80);
    glEndList();
}

void draw_mirror(int frame) {
    look_from(4);
    glRotatef(2 * float(frame), 1, 1, 0);
    clear_all();
    glCallList(1);
}

/// A picture is uploaded into a texture in every frame, as of a film.
void draw_film(int frame) {
    static const std::vector<unsigned char> image = noise_image(256, 11);
    look_at_pixels();
    clear_all();
    const std::size_t from = std::size_t(frame % 64) * 256 * 4;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, 192, GL_RGBA, GL_UNSIGNED_BYTE, &image[from]);
    glBegin(GL_QUADS);
    for (const int corner : {0, 1, 3, 2}) {
        const int right = corner % 2, up = corner / 2;
        glTexCoord2f(float(right), 0.75f * float(up));
        glVertex2i(right * window_width, up * window_height);
    }
    glEnd();
}

void begin_film() {
    make_bricks(256, false);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 noise_image(256, 12).data());
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

/// Flat sprites over a backdrop, as of a game of the time.
void begin_sprites() {
    walls = make_bricks(256, false);
    light = make_dot(64);
    glEnable(GL_TEXTURE_2D);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void draw_sprite(float x, float y, float size) {
    glBegin(GL_QUADS);
    for (const int corner : {0, 1, 3, 2}) {
        const float right = float(corner % 2), up = float(corner / 2);
        glTexCoord2f(right, up);
        glVertex2f(x + size * right, y + size * up);
    }
    glEnd();
}

void draw_sprites(int frame) {
    look_at_pixels();
    clear_all();
    glColor3f(1, 1, 1);
    glBindTexture(GL_TEXTURE_2D, walls);
    draw_sprite(0, 0, float(window_width));
    glEnable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, light);
    Numbers numbers(9);
    for (int i = 0; i < 200; ++i) {
        const float x = numbers.next() * float(window_width),
                    y = numbers.next() * float(window_height);
        glColor4f(numbers.next(), numbers.next(), numbers.next(), 0.8f);
        draw_sprite(x + 20 * std::sin(0.1f * float(frame + i)), y, 48);
    }
    glDisable(GL_BLEND);
}

}  // namespace

std::vector<Program> texture_programs() {
    return {{"world", "textured hall, fog, light maps in a second pass", begin_world, draw_world},
            {"mirror", "lit torus with a sphere map and mipmaps", begin_mirror, draw_mirror},
            {"film", "TexSubImage2D of 256x192 and a window-filling quad", begin_film, draw_film},
            {"sprites", "200 blended sprites over a backdrop", begin_sprites, draw_sprites}};
}

}  // namespace gw::bench
