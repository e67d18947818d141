// A program of OpenGL 1.1 that knows OSMesa only: frames FILE.ppm. Draws three frames with lists,
// arrays, a texture and pixels, and writes the last.
#include <GL/osmesa.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int width = 160, height = 120;

void ball(int rings) {
    const auto vertex = [&](int ring, int step) {
        const double a = M_PI * ring / rings - M_PI / 2, t = M_PI * step / rings;
        const double x = std::cos(a) * std::cos(t), y = std::sin(a), z = std::cos(a) * std::sin(t);
        glNormal3d(x, y, z);
        glTexCoord2d(2.0 * step / rings, double(ring) / rings);
        glVertex3d(x, y, z);
    };
    for (int ring = 0; ring < rings; ++ring) {
        glBegin(GL_QUAD_STRIP);
        for (int step = 0; step <= 2 * rings; ++step) {
            vertex(ring, step);
            vertex(ring + 1, step);
        }
        glEnd();
    }
}

void set_up() {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.67, 0.67, -0.5, 0.5, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    std::array<GLubyte, 64> checks;
    for (std::size_t i = 0; i < checks.size(); ++i) checks[i] = (i + i / 8) % 2 == 0 ? 255 : 60;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 8, 8, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                 checks.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const std::array<GLfloat, 4> sun{1, 2, 3, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, sun.data());
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_COLOR_MATERIAL);
    glNewList(1, GL_COMPILE);
    ball(12);
    glEndList();
}

void draw_frame(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_LIGHTING);
    glEnable(GL_TEXTURE_2D);
    glPushMatrix();
    glRotatef(GLfloat(30 * frame), 1, 1, 0);
    glColor3f(1, 0.7f, 0.3f);
    glCallList(1);
    glPopMatrix();
    glPushAttrib(GL_ENABLE_BIT);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    const std::array<GLfloat, 6> triangle{-2, -1.4f, 0, -1.4f, -1, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, triangle.data());
    glColor3f(0, 0.5f, 1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const std::array<GLubyte, 4> bits{0x80, 0x40, 0x20, 0xF0};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2f(1.5f, 1);
    glBitmap(8, 4, 0, 0, 9, 0, bits.data());
    glCopyPixels(70, 50, 20, 20, GL_COLOR);
    glPopAttrib();
    glFinish();
}

bool write_ppm(const char* file, const std::vector<unsigned char>& rgb) {
    std::FILE* const out = std::fopen(file, "wb");
    if (out == nullptr) return false;
    std::fprintf(out, "P6\n%d %d\n255\n", width, height);
    const bool whole = std::fwrite(rgb.data(), 1, rgb.size(), out) == rgb.size();
    return std::fclose(out) == 0 && whole;
}

}  // namespace

int main(int count, char** arguments) {
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGB, 24, 8, 16, nullptr);
    std::vector<unsigned char> rgb(3 * width * height);
    if (count != 2 || context == nullptr ||
        !OSMesaMakeCurrent(context, rgb.data(), GL_UNSIGNED_BYTE, width, height))
        return 1;
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    set_up();
    for (int frame = 0; frame < 3; ++frame) draw_frame(frame);
    const GLenum error = glGetError();
    OSMesaDestroyContext(context);
    return error == GL_NO_ERROR && write_ppm(arguments[1], rgb) ? 0 : 1;
}
