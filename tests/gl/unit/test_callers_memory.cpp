// Memory of the caller's is touched by the calls that the specification says, never later. Here it is
// taken away right after the call that ends its use; then the program draws on.
#include "test_paths.h"
#include "tests/gl/unit/support/window.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace gw::gl {
namespace {

/// Memory that a touch after its end ends the program with. Its addresses are never used again.
class Guarded {
public:
    explicit Guarded(std::size_t bytes) : bytes_(bytes) {
        memory_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED) throw std::bad_alloc();
    }
    template <class T>
    explicit Guarded(const std::vector<T>& values) : Guarded(values.size() * sizeof(T)) {
        std::memcpy(memory_, values.data(), values.size() * sizeof(T));
    }
    ~Guarded() { take(); }
    Guarded(const Guarded&) = delete;
    Guarded& operator=(const Guarded&) = delete;

    void take() { mprotect(memory_, bytes_, PROT_NONE); }
    /// Without the pages that lie wholly in these bytes.
    void take(std::size_t first, std::size_t count) {
        const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
        const std::size_t begin = (first + page - 1) / page * page,
                          end = (first + count) / page * page;
        ASSERT_LT(begin, end);
        mprotect(static_cast<char*>(memory_) + begin, end - begin, PROT_NONE);
    }
    template <class T = void>
    T* as() const {
        return static_cast<T*>(memory_);
    }

private:
    void* memory_;
    std::size_t bytes_;
};

/// Values for one call.
template <class T = GLfloat>
struct Given : Guarded {
    explicit Given(std::size_t count, T value = T(0.5)) : Guarded(std::vector<T>(count, value)) {}
    operator T*() const { return this->template as<T>(); }
};

constexpr GLfloat identity[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Whatever a call has kept is used.
void draw_on() {
    glRasterPos2f(0, 0);
    glBegin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(0, 1)}) {
        glTexCoord2i(x, y);
        glVertex2i(x, y);
    }
    glEnd();
    glFinish();
}

/// The calls that a list keeps.
void give_to_state() {
    for (const GLenum name : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
        glMatrixMode(name);
        glLoadMatrixf(Guarded(std::vector(identity, identity + 16)).as<GLfloat>());
        glMultMatrixf(Guarded(std::vector(identity, identity + 16)).as<GLfloat>());
    }
    glLightfv(GL_LIGHT0, GL_POSITION, Given(4));
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, Given(4));
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, Given(4));
    glFogfv(GL_FOG_COLOR, Given(4));
    glClipPlane(GL_CLIP_PLANE0, Given<GLdouble>(4));
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, Given(4));
    glTexGenfv(GL_S, GL_OBJECT_PLANE, Given(4));
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, Given(4));
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 32, Given(32));
    glPixelMapuiv(GL_PIXEL_MAP_S_TO_S, 32, Given<GLuint>(32));
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, Given(12));
    glMap2d(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, Given<GLdouble>(48));
    glPolygonStipple(Given<GLubyte>(128));
    glPrioritizeTextures(2, Given<GLuint>(2, 1), Given(2));
    glColor4fv(Given<GLfloat>(4, 1));
    glCallLists(3, GL_UNSIGNED_SHORT, Given<GLushort>(3, 77));
}

void give_images() {
    const GLenum format = GL_RGBA, type = GL_UNSIGNED_BYTE;
    glRasterPos2f(-0.5f, -0.5f);
    glDrawPixels(16, 16, format, type, Given<GLubyte>(1024));
    glDrawPixels(16, 16, GL_LUMINANCE, GL_FLOAT, Given(256));
    glDrawPixels(16, 16, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, Given<GLuint>(256));
    glDrawPixels(16, 16, GL_STENCIL_INDEX, type, Given<GLubyte>(256));
    glBitmap(16, 16, 0, 0, 0, 0, Given<GLubyte>(64, 255));
    glTexImage1D(GL_TEXTURE_1D, 0, 4, 64, 0, format, type, Given<GLubyte>(256));
    glTexImage2D(GL_TEXTURE_2D, 0, 4, 64, 64, 0, format, type, Given<GLubyte>(16384));
    glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 64, format, GL_FLOAT, Given(256));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 64, 64, format, type, Given<GLubyte>(16384));
}

struct Corner {
    GLubyte color[4];
    GLfloat position[3];
};

void point_to(const Corner* corners) { glInterleavedArrays(GL_C4UB_V3F, sizeof(Corner), corners); }

void leave_arrays() {
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
}

const std::vector<Corner> corners{{{255, 0, 0, 255}, {-1, -1, 0}},
                                  {{255, 0, 0, 255}, {1, -1, 0}},
                                  {{255, 0, 0, 255}, {1, 1, 0}},
                                  {{255, 0, 0, 255}, {-1, 1, 0}}};

/// Three ways to give a quad by arrays.
void give_arrays() {
    for (int way = 0; way < 3; ++way) {
        const Guarded memory(corners), indices(std::vector<GLushort>{0, 1, 2, 3});
        point_to(memory.as<Corner>());
        if (way == 0) glDrawArrays(GL_QUADS, 0, 4);
        if (way == 1) glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, indices.as());
        if (way == 2) {
            glBegin(GL_QUADS);
            for (int i = 0; i < 4; ++i) glArrayElement(i);
            glEnd();
        }
        leave_arrays();
    }
}

/// A window that uses all that it is given.
void use_all() {
    for (const GLenum name : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_POLYGON_STIPPLE, GL_LIGHTING,
                              GL_LIGHT0, GL_FOG, GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3})
        glEnable(name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glPixelTransferi(GL_MAP_STENCIL, 1);
}

TEST(CallersMemory, IsNotReadAfterACall) {
    const Window window;
    use_all();
    for (const auto give : {give_to_state, give_images, give_arrays}) {
        give();
        draw_on();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(CallersMemory, IsNotReadByListsWhenTheyArePlayed) {
    const Window window;
    use_all();
    for (const auto give : {give_to_state, give_images, give_arrays})
        for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
            glNewList(1, mode);
            give();
            glEndList();
            glCallList(1);
            draw_on();
        }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(CallersMemory, IsNotReadByAFrameThatIsDrawnLater) {
    const Window window(32, 32, opengl(), Buffers::Double);
    use_all();
    for (int frame = 0; frame < 40; ++frame) {  // animations run behind
        give_images();
        give_arrays();
        finish_frame(const_cast<Context&>(window.context));
        const_cast<Drawable&>(window.drawable).swap();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(CallersMemory, IsNotWrittenAfterAQuery) {
    const Window window;
    use_all();
    give_images();
    for (const auto& [format, type] :
         {std::pair(GL_RGBA, GL_UNSIGNED_BYTE), std::pair(GL_RGB, GL_FLOAT),
          std::pair(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
          std::pair(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE)}) {
        glReadPixels(0, 0, 32, 32, GLenum(format), GLenum(type), Given(4096));
        draw_on();
        glReadPixels(-4, -4, 40, 40, GLenum(format), GLenum(type), Given(8192));
        draw_on();
    }
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, Given<GLubyte>(16384));
    glGetPolygonStipple(Given<GLubyte>(128));
    glGetFloatv(GL_MODELVIEW_MATRIX, Given(16));
    glGetMapfv(GL_MAP1_VERTEX_3, GL_COEFF, Given(12));
    glGetPixelMapfv(GL_PIXEL_MAP_I_TO_R, Given(32));
    draw_on();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(CallersMemory, OfFeedbackAndSelectionEndsWithTheirMode) {
    const Window window;
    const auto use = [](GLenum mode, auto give) {
        Given<GLfloat> memory(256);
        give(memory);
        glRenderMode(mode);
        glInitNames();
        glPushName(3);
        draw_on();
        EXPECT_GT(glRenderMode(GL_RENDER), 0);
    };
    for (int times = 0; times < 2; ++times) {
        use(GL_FEEDBACK, [](GLfloat* m) { glFeedbackBuffer(256, GL_3D_COLOR, m); });
        draw_on();
        use(GL_SELECT, [](GLfloat* m) { glSelectBuffer(256, reinterpret_cast<GLuint*>(m)); });
        glPushName(1);
        draw_on();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(CallersMemory, OfElementsThatNoIndexNamesIsNotRead) {
    const Window window;
    constexpr std::size_t step = 1 << 16, last = 6;
    for (const GLenum mode : {GL_TRIANGLES, GL_QUADS, GL_TRIANGLE_STRIP}) {
        const Guarded memory(step * last + sizeof(Corner));
        std::vector<GLuint> indices;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t place = i * last / 3;  // 0, 2, 4, 6
            std::memcpy(memory.as<char>() + place * step, &corners[i], sizeof(Corner));
            indices.push_back(GLuint(place));
        }
        for (const std::size_t place : {1, 3, 5})
            const_cast<Guarded&>(memory).take((place - 1) * step + sizeof(Corner),
                                              2 * step - sizeof(Corner));
        for (int more = 0; more < 2; ++more) indices.insert(indices.end(), {0, 2, 4, 6});
        glInterleavedArrays(GL_C4UB_V3F, GLsizei(step), memory.as());
        glDrawElements(mode, GLsizei(indices.size()), GL_UNSIGNED_INT, indices.data());
        leave_arrays();
        EXPECT_EQ(window.pixel(24, 4), (std::array<GLubyte, 4>{255, 0, 0, 255})) << mode;
        glClear(GL_COLOR_BUFFER_BIT);
    }
}

/// libOSMesa, as programs load it.
template <class Signature>
Signature* of_library(const char* name) {
    static void* const library =
        dlopen(GW_BIN_DIR "/../lib/opengl/libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<Signature*>(dlsym(library, name));
}
#define GW_LIBRARY(name) (*of_library<decltype(name)>(#name))

constexpr int side = 64;

/// A context of OSMesa that has drawn into its memory.
struct Drawn {
    explicit Drawn(GLenum format = OSMESA_RGBA)
        : context(GW_LIBRARY(OSMesaCreateContextExt)(format, 24, 8, 16, nullptr)) {
        make_current(memory);
        draw();
    }
    void make_current(const Guarded& to, int width = side) const {
        ASSERT_TRUE(GW_LIBRARY(OSMesaMakeCurrent)(context, to.as(), GL_UNSIGNED_BYTE, width, side));
    }
    static void draw() {
        GW_LIBRARY(glClearColor)(1, 0, 0, 1);
        GW_LIBRARY(glClear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        GW_LIBRARY(glRectf)(-0.5f, -0.5f, 0.5f, 0.5f);
    }

    Guarded memory{side * side * 4};
    OSMesaContext context;
};

/// Calls `end` for contexts that have finished, and for some that have not; the memory is gone.
template <class End>
void without_memory(End end) {
    for (const GLenum format : {OSMESA_RGBA, OSMESA_BGRA})
        for (const bool finishes : {true, false}) {
            Drawn drawn(format);
            if (finishes) GW_LIBRARY(glFinish)();
            drawn.memory.take();
            end(drawn);
        }
}

TEST(CallersMemory, OfOSMesaIsNotWrittenByTheContextsEnd) {
    without_memory([](const Drawn& drawn) { GW_LIBRARY(OSMesaDestroyContext)(drawn.context); });
    without_memory([](const Drawn& drawn) {
        GW_LIBRARY(OSMesaMakeCurrent)(nullptr, nullptr, 0, 0, 0);
        GW_LIBRARY(OSMesaDestroyContext)(drawn.context);
    });
}

TEST(CallersMemory, OfOSMesaIsNotWrittenWhenAnotherIsMadeCurrent) {
    without_memory([](const Drawn& drawn) {
        const Drawn other;
        GW_LIBRARY(glFinish)();
        GW_LIBRARY(OSMesaDestroyContext)(drawn.context);
        GW_LIBRARY(OSMesaDestroyContext)(other.context);
    });
    for (const int width : {side, side / 2})
        without_memory([width](const Drawn& drawn) {
            const Guarded next(side * side * 4);
            drawn.make_current(next, width);
            Drawn::draw();
            GW_LIBRARY(glFinish)();
            EXPECT_EQ(next.as<GLubyte>()[3], 255);
            GW_LIBRARY(OSMesaDestroyContext)(drawn.context);
        });
}

TEST(CallersMemory, OfOSMesaIsNotWrittenAgainBeforeSomethingIsDrawn) {
    Drawn drawn;
    GW_LIBRARY(glFinish)();
    drawn.memory.take();
    GW_LIBRARY(glGetError)();
    GW_LIBRARY(glFlush)();
    GW_LIBRARY(glFinish)();
    GW_LIBRARY(OSMesaDestroyContext)(drawn.context);
}

TEST(OSMesa, DrawingIsKeptForTheNextMemoryOfItsSize) {
    const Drawn drawn;  // not finished
    const Guarded next(side * side * 4);
    drawn.make_current(next);
    GW_LIBRARY(glFinish)();
    EXPECT_EQ(next.as<GLubyte>()[0], 255);
    EXPECT_EQ(drawn.memory.as<GLubyte>()[0], 0);
    GW_LIBRARY(OSMesaDestroyContext)(drawn.context);
}

}  // namespace
}  // namespace gw::gl
