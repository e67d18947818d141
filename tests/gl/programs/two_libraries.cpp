// A program that is linked with libGL.so.1 and libOSMesa.so.8, in this order or the other, and draws
// with a context of OSMesa. Its GL functions are those of the first library. Its status is 0 if they
// drew, and if those that libGL's eglGetProcAddress finds draw too: loaders take it where it is.
#include <GL/osmesa.h>

#include <dlfcn.h>

#include <array>
#include <cstdio>

namespace {

using Address = void (*)();
using GetProcAddress = Address (*)(const char*);

template <class Function>
Function* named(GetProcAddress find, const char* name) {
    return reinterpret_cast<Function*>(find(name));
}

}  // namespace

int main() {
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::array<unsigned char, 64> memory{};
    if (!OSMesaMakeCurrent(context, memory.data(), GL_UNSIGNED_BYTE, 4, 4)) return 1;
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    if (memory[1] != 255) return std::fputs("GL's functions did not draw\n", stderr), 2;

    const auto find = reinterpret_cast<GetProcAddress>(dlsym(RTLD_DEFAULT, "eglGetProcAddress"));
    if (find == nullptr) return std::fputs("libGL.so.1 is not there\n", stderr), 3;
    if (named<decltype(glGetString)>(find, "glGetString")(GL_VERSION) == nullptr)
        return std::fputs("eglGetProcAddress: no context\n", stderr), 4;
    named<decltype(glClearColor)>(find, "glClearColor")(1, 0, 0, 1);
    named<decltype(glClear)>(find, "glClear")(GL_COLOR_BUFFER_BIT);
    named<decltype(glFinish)>(find, "glFinish")();
    if (memory[0] != 255 || memory[1] != 0) return std::fputs("they did not draw\n", stderr), 5;

    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    if (glGetString(GL_VERSION) != nullptr) return std::fputs("still current\n", stderr), 6;
    OSMesaDestroyContext(context);
    return 0;
}
