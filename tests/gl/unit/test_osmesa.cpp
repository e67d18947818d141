// libOSMesa.so.8 as a program meets it: loaded, asked for its functions, drawn to memory.
#include "test_paths.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace gw::gl {
namespace {

/// The library, loaded once for all tests. Its GL functions are not this program's.
void* library() {
    static void* const handle =
        dlopen(GW_BIN_DIR "/../lib/opengl/libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    return handle;
}

template <class Signature>
Signature* function(const char* name) {
    return reinterpret_cast<Signature*>(dlsym(library(), name));
}

struct Functions {
    decltype(OSMesaCreateContextExt)* create =
        function<decltype(OSMesaCreateContextExt)>("OSMesaCreateContextExt");
    decltype(OSMesaDestroyContext)* destroy =
        function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(OSMesaMakeCurrent)* make_current =
        function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(OSMesaPixelStore)* pixel_store =
        function<decltype(OSMesaPixelStore)>("OSMesaPixelStore");
    decltype(OSMesaGetIntegerv)* get = function<decltype(OSMesaGetIntegerv)>("OSMesaGetIntegerv");
    decltype(OSMesaGetDepthBuffer)* depth_buffer =
        function<decltype(OSMesaGetDepthBuffer)>("OSMesaGetDepthBuffer");
    decltype(OSMesaGetProcAddress)* address =
        function<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");

    /// Clears to red 1, green 0.5, blue 0.25, alpha 1; then the lower left pixel to white.
    void draw() const {
        const auto clear_color = gl<decltype(glClearColor)>("glClearColor");
        const auto clear = gl<decltype(glClear)>("glClear");
        clear_color(1, 0.5f, 0.25f, 1);
        clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl<decltype(glEnable)>("glEnable")(GL_SCISSOR_TEST);
        gl<decltype(glScissor)>("glScissor")(0, 0, 1, 1);
        clear_color(1, 1, 1, 1);
        clear(GL_COLOR_BUFFER_BIT);
        gl<decltype(glFinish)>("glFinish")();
    }
    template <class Signature>
    Signature* gl(const char* name) const {
        return reinterpret_cast<Signature*>(address(name));
    }
};

TEST(OSMesa, ExportsItsFunctionsAndGLs) {
    ASSERT_NE(library(), nullptr) << dlerror();
    for (const char* name :
         {"OSMesaCreateContext", "OSMesaCreateContextExt", "OSMesaCreateContextAttribs",
          "OSMesaDestroyContext", "OSMesaMakeCurrent", "OSMesaGetCurrentContext",
          "OSMesaPixelStore", "OSMesaGetIntegerv", "OSMesaGetDepthBuffer", "OSMesaGetColorBuffer",
          "OSMesaGetProcAddress", "OSMesaColorClamp", "OSMesaPostprocess", "glBegin", "glVertex3f",
          "glGenBuffers"}) {
        EXPECT_NE(dlsym(library(), name), nullptr) << name;
        EXPECT_EQ(reinterpret_cast<void*>(Functions().address(name)), dlsym(library(), name))
            << name;
    }
    EXPECT_EQ(Functions().address("OSMesaNothing"), nullptr);
}

constexpr const char* linked_only[] = {
#define GW_GL_LINKED(name) "gl" #name,
#include "generated/gl/linked.inc"
#undef GW_GL_LINKED
};

/// Programs that bind all functions when they load start; those that look one up are told the truth.
TEST(OSMesa, LinksFunctionsThatItDoesNotOfferAndDoesNotFindThem) {
    const Functions f;
    const auto context = f.create(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<unsigned char> memory(4 * 3 * 4);
    ASSERT_TRUE(f.make_current(context, memory.data(), GL_UNSIGNED_BYTE, 4, 3));
    const auto get_error = f.gl<decltype(glGetError)>("glGetError");
    for (const char* name : linked_only) {
        EXPECT_EQ(f.address(name), nullptr) << name;
        auto* const linked = function<std::intptr_t()>(name);
        ASSERT_NE(linked, nullptr) << name;
        EXPECT_EQ(linked(), 0) << name;
        EXPECT_EQ(get_error(), GLenum(GL_INVALID_OPERATION)) << name;
    }
    f.destroy(context);
}

/// A format, a type, and the bytes of the colour that draw() clears to.
struct Case {
    GLenum format, type;
    std::vector<unsigned char> bytes;
};

template <class T>
std::vector<unsigned char> bytes_of(const std::vector<T>& values) {
    std::vector<unsigned char> out(values.size() * sizeof(T));
    std::memcpy(out.data(), values.data(), out.size());
    return out;
}

const std::vector<Case> cases{
    {OSMESA_RGBA, GL_UNSIGNED_BYTE, {255, 128, 64, 255}},
    {OSMESA_BGRA, GL_UNSIGNED_BYTE, {64, 128, 255, 255}},
    {OSMESA_ARGB, GL_UNSIGNED_BYTE, {255, 255, 128, 64}},
    {OSMESA_RGB, GL_UNSIGNED_BYTE, {255, 128, 64}},
    {OSMESA_BGR, GL_UNSIGNED_BYTE, {64, 128, 255}},
    {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, bytes_of<unsigned short>({31 << 11 | 32 << 5 | 8})},
    {OSMESA_RGBA, GL_UNSIGNED_SHORT, bytes_of<unsigned short>({65535, 128 * 257, 64 * 257, 65535})},
    {OSMESA_RGBA, GL_FLOAT, bytes_of<float>({1, 128.0f / 255, 64.0f / 255, 1})},
};

TEST(OSMesa, WritesEachFormatAndType) {
    const Functions f;
    for (const Case& c : cases) {
        const auto context = f.create(c.format, 24, 8, 16, nullptr);
        ASSERT_NE(context, nullptr) << c.format;
        std::vector<unsigned char> memory(4 * 3 * 16 + 1, 0xEE);
        ASSERT_TRUE(f.make_current(context, memory.data(), c.type, 4, 3)) << c.format;
        f.draw();
        const std::size_t size = c.bytes.size();
        for (std::size_t pixel = 1; pixel < 12; ++pixel)
            EXPECT_EQ(std::memcmp(&memory[pixel * size], c.bytes.data(), size), 0)
                << c.format << " pixel " << pixel;
        EXPECT_NE(std::memcmp(memory.data(), c.bytes.data(), size), 0) << c.format;
        EXPECT_EQ(memory[12 * size], 0xEE) << c.format;
        f.destroy(context);
    }
}

TEST(OSMesa, TurnsRowsAndKeepsTheRowLength) {
    const Functions f;
    const auto context = f.create(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<unsigned char> memory(6 * 3 * 4, 0xEE);
    ASSERT_TRUE(f.make_current(context, memory.data(), GL_UNSIGNED_BYTE, 4, 3));
    f.pixel_store(OSMESA_ROW_LENGTH, 6);
    f.pixel_store(OSMESA_Y_UP, 0);
    f.draw();
    EXPECT_EQ(memory[4 * (2 * 6) + 1], 255);  // the lower left pixel, in the last row
    EXPECT_EQ(memory[1], 128);
    EXPECT_EQ(memory[4 * 4], 0xEE);  // between the rows
    GLint y_up = 1;
    f.get(OSMESA_Y_UP, &y_up);
    EXPECT_EQ(y_up, 0);
    f.destroy(context);
}

TEST(OSMesa, GivesTheDepthBuffer) {
    const Functions f;
    const auto context = f.create(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<unsigned char> memory(4 * 3 * 4);
    ASSERT_TRUE(f.make_current(context, memory.data(), GL_UNSIGNED_BYTE, 4, 3));
    f.draw();
    GLint width = 0, height = 0, bytes = 0;
    void* buffer = nullptr;
    ASSERT_TRUE(f.depth_buffer(context, &width, &height, &bytes, &buffer));
    EXPECT_EQ((std::array{width, height, bytes}), (std::array{4, 3, 4}));
    EXPECT_EQ(static_cast<const unsigned*>(buffer)[11], 0xFFFFFFu);
    f.destroy(context);
}

TEST(OSMesa, TakesAttributesThatItKnows) {
    const auto create =
        function<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    const auto is_made = [&](std::vector<int> attributes) {
        attributes.push_back(0);
        const auto context = create(attributes.data(), nullptr);
        Functions().destroy(context);
        return context != nullptr;
    };
    EXPECT_TRUE(is_made({}));
    EXPECT_TRUE(is_made({OSMESA_FORMAT, OSMESA_BGRA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8,
                         OSMESA_ACCUM_BITS, 16, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE,
                         OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 5}));
    EXPECT_FALSE(is_made({OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 6}));
    EXPECT_FALSE(is_made({0x4444, 1}));
    EXPECT_FALSE(is_made({OSMESA_DEPTH_BITS, -1}));
    EXPECT_FALSE(is_made({OSMESA_FORMAT, 77}));
    EXPECT_FALSE(is_made({OSMESA_PROFILE, OSMESA_CORE_PROFILE}));
    EXPECT_FALSE(is_made({OSMESA_CONTEXT_MAJOR_VERSION, 3}));
}

TEST(OSMesa, RefusesWhatItDoesNotHave) {
    const Functions f;
    EXPECT_EQ(f.create(OSMESA_COLOR_INDEX, 0, 0, 0, nullptr), nullptr);
    const auto context = f.create(OSMESA_RGB_565, 0, 0, 0, nullptr);
    std::array<unsigned char, 64> memory{};
    EXPECT_FALSE(f.make_current(context, memory.data(), GL_UNSIGNED_BYTE, 2, 2));
    EXPECT_FALSE(f.make_current(context, nullptr, GL_UNSIGNED_SHORT_5_6_5, 2, 2));
    EXPECT_FALSE(f.make_current(context, memory.data(), GL_UNSIGNED_SHORT_5_6_5, 0, 2));
    EXPECT_FALSE(f.make_current(context, memory.data(), GL_UNSIGNED_SHORT_5_6_5, 99999, 2));
    f.destroy(context);
}

}  // namespace
}  // namespace gw::gl
