// What the doors offer under GW_GL_VERSION: offered VERSION ends with 0 if functions and extensions
// are there from their version on, and not before, and if GL_VERSION is it.
#include <GL/osmesa.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

struct Case {
    const char* function;
    const char* extension;
    double since;
};
constexpr Case cases[] = {
    {"glWindowPos2iARB", "GL_ARB_window_pos", 1.1},
    {"glTexImage3D", "GL_EXT_texture3D", 1.2},
    {"glLoadTransposeMatrixfARB", "GL_ARB_transpose_matrix", 1.3},
    {"glActiveTextureARB", "GL_ARB_multitexture", 1.3},
    {"glBlendFuncSeparate", "GL_EXT_blend_func_separate", 1.4},
    {"glMultiDrawArrays", "GL_EXT_multi_draw_arrays", 1.4},
    {"glSecondaryColor3f", "GL_EXT_secondary_color", 1.4},
    {"glFogCoordf", "GL_EXT_fog_coord", 1.4},
    {"glBeginQuery", "GL_ARB_occlusion_query", 1.5},
    {"glGenBuffers", "GL_ARB_vertex_buffer_object", 1.5},
    {"glGenFramebuffers", "GL_ARB_framebuffer_object", 1.5},
    {"glFramebufferTextureLayer", "GL_ARB_framebuffer_object", 1.5},
};

bool has_word(std::string_view words, std::string_view word) {
    for (std::size_t at = words.find(word); at != std::string_view::npos;
         at = words.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' '))
            return true;
    }
    return false;
}

}  // namespace

int main(int, char** arguments) {
    const double version = std::atof(arguments[1]);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::array<unsigned char, 64> memory{};
    if (!OSMesaMakeCurrent(context, memory.data(), GL_UNSIGNED_BYTE, 4, 4)) return 2;
    const std::string_view extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    int wrong = 0;
    for (const Case& c : cases) {
        const bool expected = version >= c.since;
        if ((OSMesaGetProcAddress(c.function) != nullptr) != expected)
            std::fprintf(stderr, "%s\n", c.function), ++wrong;
        if (has_word(extensions, c.extension) != expected)
            std::fprintf(stderr, "%s\n", c.extension), ++wrong;
    }
    if (std::string_view(reinterpret_cast<const char*>(glGetString(GL_VERSION))) != arguments[1])
        std::fprintf(stderr, "GL_VERSION\n"), ++wrong;
    OSMesaDestroyContext(context);
    return wrong == 0 ? 0 : 1;
}
