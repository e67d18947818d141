#include "bench/draws/opengl.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <stdexcept>

namespace gw::draws {
namespace {

struct GlVertex {
    float x, y, z, r, g, b, s, t;
};

void enable(GLenum capability, bool on) {
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

void set_light() {
    const Light light = lamp();
    const auto rgba = [](GLenum name, const vec3& v) {
        const float values[4] = {v.x, v.y, v.z, 1};
        glLightfv(GL_LIGHT0, name, values);
    };
    const float black[4] = {0, 0, 0, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, &light.position.x);
    rgba(GL_AMBIENT, light.Ia);
    rgba(GL_DIFFUSE, light.Id);
    rgba(GL_SPECULAR, light.Is);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glEnable(GL_LIGHT0);
}

void set_state(int number) {
    glDepthFunc(depth_func_of(number) == DepthFunc::Less ? GL_LESS : GL_LEQUAL);
    glDepthMask(has_depth_mask(number));
    enable(GL_BLEND, blends(number));
}

void set_material(const Quad& q) {
    const float color[4] = {q.color.x, q.color.y, q.color.z, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

}  // namespace

struct OpenGl::Context {
    OSMesaContext mesa = nullptr;
    std::vector<unsigned char> buffer;
    std::vector<unsigned> textures;
    std::vector<Quad> quads;
    Own own = Own::Nothing;
    Method method = Method::Begin;
    unsigned list = 0, vertices = 0;

    Context() : buffer(std::size_t(width) * height * 4), textures(texture_count) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_COMPAT_PROFILE,
                                  0};
        mesa = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!mesa || !OSMesaMakeCurrent(mesa, buffer.data(), GL_UNSIGNED_BYTE, width, height))
            throw std::runtime_error("OSMesa makes no context");
        glGenTextures(texture_count, textures.data());
        for (int i = 0; i < texture_count; ++i) {
            glBindTexture(GL_TEXTURE_2D, textures[std::size_t(i)]);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture_side, texture_side, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, texels_of(i).data());
        }
        glGenBuffers(1, &vertices);
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, width, 0, height, 1, -1);
        glMatrixMode(GL_MODELVIEW);
        set_light();
        glEnable(GL_DEPTH_TEST);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    ~Context() { OSMesaDestroyContext(mesa); }

    /// A quad's corners; at the origin if it has its own matrix.
    std::array<GlVertex, 4> corners(const Quad& q) const {
        const bool moves = has_own_matrix(own);
        const float x = moves ? 0 : q.x, y = moves ? 0 : q.y, z = moves ? 0 : q.z;
        const float side = float(quad_side);
        std::array<GlVertex, 4> out{};
        for (std::size_t i = 0; i < 4; ++i) {
            const float right = i == 1 || i == 2 ? 1 : 0, up = i >= 2 ? 1 : 0;
            const vec3 c = moves ? vec3(1, 0.5f, 0.25f) : q.color;
            out[i] = {x + side * right, y + side * up, z, c.x, c.y, c.z, right, up};
        }
        return out;
    }
    void set_up(std::size_t i) const {
        const Quad& q = quads[i];
        if (has_own_state(own)) set_state(int(i % state_count));
        if (has_own_material(own)) set_material(q);
        if (is_textured(own)) glBindTexture(GL_TEXTURE_2D, textures[i % texture_count]);
        if (!has_own_matrix(own)) return;
        const float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, q.x, q.y, q.z, 1};
        glLoadMatrixf(m);
    }
    void begin_each() const {
        for (std::size_t i = 0; i < quads.size(); ++i) {
            set_up(i);
            glBegin(GL_QUADS);
            for (const GlVertex& v : corners(quads[i])) {
                glColor3fv(&v.r);
                if (is_textured(own)) glTexCoord2fv(&v.s);
                glVertex3fv(&v.x);
            }
            glEnd();
        }
    }
    void arrays() const {
        const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_COLOR_ARRAY);
        glVertexPointer(3, GL_FLOAT, sizeof(GlVertex), at(0));
        glColorPointer(3, GL_FLOAT, sizeof(GlVertex), at(12));
        if (is_textured(own)) {
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
            glTexCoordPointer(2, GL_FLOAT, sizeof(GlVertex), at(24));
        }
        for (std::size_t i = 0; i < quads.size(); ++i) {
            set_up(i);
            glDrawArrays(GL_QUADS, has_own_matrix(own) ? 0 : int(4 * i), 4);
        }
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    void fill_buffer() {
        std::vector<GlVertex> all;
        for (const Quad& q : quads)
            for (const GlVertex& v : corners(q)) all.push_back(v);
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, long(all.size() * sizeof(GlVertex)), all.data(),
                     GL_STATIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    void prepare() {
        glLoadIdentity();
        glNormal3f(0, 0, 1);
        enable(GL_LIGHTING, has_own_material(own));
        enable(GL_TEXTURE_2D, is_textured(own));
        fill_buffer();
        if (list != 0) glDeleteLists(list, 1);
        list = 0;
        if (method != Method::List) return;
        list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        begin_each();
        glEndList();
    }
    void run() {
        glDepthMask(1);
        glDepthFunc(GL_LESS);
        glDisable(GL_BLEND);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        switch (method) {
            case Method::Begin: begin_each(); break;
            case Method::List: glCallList(list); break;
            case Method::Arrays: arrays(); break;
        }
        glFinish();
    }
};

OpenGl::OpenGl() : context_(std::make_unique<Context>()) {}
OpenGl::~OpenGl() = default;

void OpenGl::prepare(const std::vector<Quad>& quads, Own own, Method method) {
    context_->quads = quads;
    context_->own = own;
    context_->method = method;
    context_->prepare();
}
void OpenGl::run() { context_->run(); }
const std::vector<unsigned char>& OpenGl::picture() const { return context_->buffer; }
std::string OpenGl::renderer() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace gw::draws
