#include "bench/radiosity/opengl_hemicube.h"

#include "bench/peers/opengl_mesh.h"
#include "gw/error.h"

#include <GL/gl.h>
#include <GL/osmesa.h>

namespace gw::bench {
namespace {

OSMesaContext make_context() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              0};
    OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) throw Error("OSMesa makes no context");
    return context;
}

}  // namespace

struct OpenGlHemicube::Context {
    int size;
    OSMesaContext mesa = make_context();
    std::vector<unsigned char> window, read;
    std::vector<peers::GlMesh> meshes;

    Context(const radiosity::PixmapModel& model, int pixels)
        : size(pixels), window(std::size_t(pixels) * std::size_t(pixels) * 4), read(window.size()) {
        use();
        for (const scene::Object& object : model.drawn.objects)
            meshes.emplace_back(*object.mesh, peers::Store::Lists, 1);
    }
    ~Context() { OSMesaDestroyContext(mesa); }

    void use() {
        if (!OSMesaMakeCurrent(mesa, window.data(), GL_UNSIGNED_BYTE, size, size))
            throw Error("OSMesa takes no buffer");
    }

    void draw(const scene::View& view, bool top) {
        const int first_row = top ? 0 : size / 2;
        glScissor(0, first_row, size, size - first_row);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixd(&view.clip_from_eye[0][0]);
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(&view.eye_from_world[0][0]);
        for (const peers::GlMesh& mesh : meshes) mesh.draw(peers::Attributes::Ids);
        glReadPixels(0, first_row, size, size - first_row, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    }
};

OpenGlHemicube::OpenGlHemicube(const radiosity::PixmapModel& model, int size)
    : context_(std::make_unique<Context>(model, size)) {}
OpenGlHemicube::~OpenGlHemicube() = default;

void OpenGlHemicube::draw(const radiosity::Hemicube& hemicube) {
    context_->use();
    glViewport(0, 0, context_->size, context_->size);
    glEnable(GL_DEPTH_TEST), glEnable(GL_SCISSOR_TEST);
    glDisable(GL_LIGHTING), glDisable(GL_DITHER);
    glDepthFunc(GL_LESS), glShadeModel(GL_FLAT), glClearColor(0, 0, 0, 0);
    for (std::size_t face = 0; face < radiosity::hemicube_faces; ++face)
        context_->draw(hemicube.views[face], face == 0);
}

const std::vector<unsigned char>& OpenGlHemicube::read() const { return context_->read; }

}  // namespace gw::bench
