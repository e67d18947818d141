// A windmill in fog, drawn with OpenGL 1.1 into memory: three frames of 96 x 72 pixels.
// All angles go through glRotatef, so that no libm decides about a vertex.
#include <GL/osmesa.h>

#include <array>
#include <vector>

namespace {

constexpr int width = 96, height = 72, frames = 3;
constexpr GLuint rotor = 1;

void set_up() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 16);
    const std::array<GLfloat, 4> haze{0.7f, 0.8f, 0.9f, 1};
    glFogfv(GL_FOG_COLOR, haze.data());
    glClearColor(haze[0], haze[1], haze[2], haze[3]);

    const std::array<GLubyte, 4> checks{255, 150, 150, 255};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                 checks.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.8, 0.8, -0.6, 0.6, 1, 20);
    glMatrixMode(GL_MODELVIEW);
}

/// Four sails around the z axis.
void compile_rotor() {
    glNewList(rotor, GL_COMPILE);
    for (int sail = 0; sail < 4; ++sail) {
        glBegin(GL_QUADS);
        glNormal3f(0, 0.3f, 1);
        glVertex3f(0.1f, 0.3f, 0);
        glVertex3f(0.1f, 1.8f, 0);
        glVertex3f(-0.3f, 1.8f, 0.1f);
        glVertex3f(-0.3f, 0.3f, 0.1f);
        glEnd();
        glRotatef(90, 0, 0, 1);
    }
    glEndList();
}

void draw_ground() {
    glEnable(GL_TEXTURE_2D);
    glColor3f(0.4f, 0.7f, 0.2f);
    glBegin(GL_QUADS);
    glTexCoord2i(0, 0), glVertex3i(-10, 0, 4);
    glTexCoord2i(10, 0), glVertex3i(10, 0, 4);
    glTexCoord2i(10, 10), glVertex3i(10, 0, -16);
    glTexCoord2i(0, 10), glVertex3i(-10, 0, -16);
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

/// Eight sides that lean inwards.
void draw_tower() {
    glColor3f(0.8f, 0.5f, 0.4f);
    for (int side = 0; side < 8; ++side) {
        glBegin(GL_QUADS);
        glNormal3f(0, 0.15f, 1);
        glVertex3f(-0.415f, 0, 1);
        glVertex3f(0.415f, 0, 1);
        glVertex3f(0.25f, 3, 0.6f);
        glVertex3f(-0.25f, 3, 0.6f);
        glEnd();
        glRotatef(45, 0, 1, 0);
    }
}

void draw_frame(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glRotatef(10, 1, 0, 0);
    glTranslatef(0, -2.8f, -6);
    const std::array<GLfloat, 4> sun{1, 2, 2, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, sun.data());
    draw_ground();
    glEnable(GL_LIGHTING);
    glRotatef(30, 0, 1, 0);
    draw_tower();
    glTranslatef(0, 2.8f, 0.9f);
    glRotatef(GLfloat(25 * frame), 0, 0, 1);
    glColor3f(0.9f, 0.9f, 0.8f);
    glCallList(rotor);
    glDisable(GL_LIGHTING);
    glFinish();
}

}  // namespace

int main() {
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    std::vector<GLubyte> pixels(4 * width * height);
    if (context == nullptr ||
        !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height))
        return 1;
    set_up();
    compile_rotor();
    for (int frame = 0; frame < frames; ++frame) draw_frame(frame);
    const bool drawn = glGetError() == GL_NO_ERROR;
    OSMesaDestroyContext(context);
    return drawn ? 0 : 1;
}
