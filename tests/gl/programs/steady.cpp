// The memory of a program does not grow with its frames: steady FRAMES. Each frame draws new
// textures, lists, arrays and immediate vertices, and reads pixels. Prints the least memory in use
// between a tenth and two tenths of the frames, and in the last tenth; ends with 1 if it grew by more
// than 16 KB.
#include <GL/osmesa.h>

#include <malloc.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr int width = 160, height = 120, side = 64;

/// A hash: values of the frame that do not repeat.
unsigned scrambled(unsigned value) {
    value = (value ^ (value >> 16)) * 0x7feb352du;
    return (value ^ (value >> 15)) * 0x846ca68bu;
}

GLfloat unit(unsigned value) { return GLfloat(scrambled(value) >> 8) / GLfloat(1 << 24) * 2 - 1; }

void textured_square(unsigned frame) {
    std::vector<GLubyte> texels(3 * side * side);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = GLubyte(scrambled(frame + unsigned(i)));
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (const auto& [s, t] :
         {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}}) {
        glTexCoord2i(s, t);
        glVertex2i(s, t);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    glDeleteTextures(1, &name);
}

void fan(unsigned frame) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_TRIANGLE_FAN);
    for (unsigned i = 0; i < 40; ++i) {
        glColor3f(unit(i), unit(frame), 1);
        glVertex2f(unit(frame + i), unit(frame + i + 1));
    }
    glEnd();
    glEndList();
    glCallList(list);
    glDeleteLists(list, 1);
}

void strip(unsigned frame) {
    std::array<GLfloat, 128> vertices;
    for (unsigned i = 0; i < vertices.size(); ++i) vertices[i] = unit(frame * 128 + i);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices.data());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, vertices.size() / 2);
}

void draw_frame(unsigned frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    textured_square(frame);
    fan(frame);
    strip(frame);
    std::array<GLubyte, 64> pixels;
    glReadPixels(70, 50, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glFinish();
}

std::size_t bytes_in_use() {
    const struct mallinfo2 memory = mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

}  // namespace

int main(int count, char** arguments) {
    const unsigned frames = count == 2 ? unsigned(std::atoi(arguments[1])) : 0;
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    std::vector<GLubyte> pixels(4 * width * height);
    if (frames < 10 || context == nullptr ||
        !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height))
        return 1;
    std::array<std::size_t, 10> least;  // of each tenth of the frames
    least.fill(SIZE_MAX);
    for (unsigned frame = 0; frame < frames; ++frame) {
        draw_frame(frame);
        std::size_t& of_tenth = least[frame * std::size_t(10) / frames];
        of_tenth = std::min(of_tenth, bytes_in_use());
    }
    std::printf("least bytes in use: %zu, then %zu, of %u frames\n", least[1], least[9], frames);
    return glGetError() == GL_NO_ERROR && least[9] <= least[1] + 16384 ? 0 : 1;
}
