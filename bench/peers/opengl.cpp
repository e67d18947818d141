// Workloads in OpenGL's words.
#include "bench/peers/opengl.h"

#include "bench/peers/opengl_mesh.h"

#include "gw/texture.h"

#include <GL/gl.h>
#include <GL/osmesa.h>

#include <stdexcept>

namespace gw::peers {
namespace {

void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

GLenum depth_func(DepthFunc f) { return f == DepthFunc::Less ? GL_LESS : GL_EQUAL; }
GLenum factor(BlendFactor f) {
    switch (f) {
        case BlendFactor::SrcAlpha: return GL_SRC_ALPHA;
        case BlendFactor::OneMinusSrcAlpha: return GL_ONE_MINUS_SRC_ALPHA;
        case BlendFactor::One: return GL_ONE;
        default: return GL_ZERO;
    }
}

unsigned make_texture_object(const TextureRef& texture) {
    if (!texture) return 0;
    unsigned name = 0;
    std::vector<unsigned char> rgba;
    for (const std::uint16_t v : texture->levels.front().rgba)
        rgba.push_back((unsigned char)(v >> 8));
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture->width(), texture->height(), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, rgba.data());
    return name;
}

OSMesaContext make_context() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_ACCUM_BITS,
                              16,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              0};
    OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) throw std::runtime_error("OSMesa makes no context");
    return context;
}

void set_vec3(GLenum name, const vec3& v) {
    const float rgba[4] = {v.x, v.y, v.z, 1};
    glMaterialfv(GL_FRONT_AND_BACK, name, rgba);
}

/// The material with the pass's component left.
void set_material(const Material& m, Shade shade) {
    const bool all = shade == Shade::Lit;
    const auto part = [&](Shade s, const vec3& v) { return all || shade == s ? v : vec3(0); };
    set_vec3(GL_AMBIENT, part(Shade::Ambient, m.Ka));
    set_vec3(GL_DIFFUSE, part(Shade::Diffuse, m.Kd));
    set_vec3(GL_SPECULAR, part(Shade::Specular, m.Ks));
    set_vec3(GL_EMISSION, shade == Shade::Reflection ? m.Ks : vec3(0));
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, std::min(m.Ns, 128.0f));
}

void set_light(const Light& light, bool local_viewer) {
    const float black[4] = {0, 0, 0, 1};
    const auto rgba = [](GLenum name, const vec3& v) {
        const float values[4] = {v.x, v.y, v.z, 1};
        glLightfv(GL_LIGHT0, name, values);
    };
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, &light.position.x);
    rgba(GL_AMBIENT, light.Ia), rgba(GL_DIFFUSE, light.Id), rgba(GL_SPECULAR, light.Is);
    glEnable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer ? 1 : 0);
}

void set_stencil(Stencil s) {
    enable(GL_STENCIL_TEST, s != Stencil::Off);
    glStencilFunc(s == Stencil::OutsideShadow ? GL_EQUAL : GL_ALWAYS, 0, 255);
    glStencilOp(GL_KEEP, GL_KEEP,
                s == Stencil::Increment   ? GL_INCR
                : s == Stencil::Decrement ? GL_DECR
                                          : GL_KEEP);
    glCullFace(s == Stencil::Decrement ? GL_FRONT : GL_BACK);
}

void set_fog(Fog fog) {
    enable(GL_FOG, fog != Fog::Off);
    const float colored[4] = {0.4f, 0.45f, 0.5f, 1}, black[4] = {0, 0, 0, 1};
    glFogi(GL_FOG_MODE, GL_EXP);
    glFogf(GL_FOG_DENSITY, 0.06f);
    glFogfv(GL_FOG_COLOR, fog == Fog::Colored ? colored : black);
}

Attributes attributes_of(const Pass& pass) {
    switch (pass.shade) {
        case Shade::None: return Attributes::Positions;
        case Shade::Id: return Attributes::Ids;
        case Shade::VertexColor: return Attributes::Colors;
        default: break;
    }
    return pass.textured && pass.shade != Shade::Reflection ? Attributes::NormalsAndTexture
                                                            : Attributes::Normals;
}

}  // namespace

struct OpenGl::Context {
    const Frame& frame;
    OSMesaContext mesa = make_context();
    std::vector<unsigned char> buffer;
    std::vector<GlMesh> scene, volumes, quad;
    unsigned texture = 0, sphere_map = 0;

    Context(const Frame& f, Store store)
        : frame(f), buffer(std::size_t(f.width) * std::size_t(f.height) * 4) {
        if (!OSMesaMakeCurrent(mesa, buffer.data(), GL_UNSIGNED_BYTE, f.width, f.height))
            throw std::runtime_error("OSMesa takes no buffer");
        unsigned id = 1;
        for (const Part& part : f.scene) {
            scene.emplace_back(*part.mesh, store, id);
            id += part.mesh->polygon_count();
        }
        if (f.volumes.mesh) volumes.emplace_back(*f.volumes.mesh, store, 0);
        if (f.quad.mesh) quad.emplace_back(*f.quad.mesh, store, 0);
        texture = make_texture_object(f.texture), sphere_map = make_texture_object(f.sphere_map);
        glEnable(GL_CULL_FACE), glEnable(GL_NORMALIZE);
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP),
            glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    }
    ~Context() { OSMesaDestroyContext(mesa); }

    void use() {
        OSMesaMakeCurrent(mesa, buffer.data(), GL_UNSIGNED_BYTE, frame.width, frame.height);
    }

    void set_projection(const JitterState& jitter) {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glTranslated(jitter.x / (4.0 * frame.width), jitter.y / (4.0 * frame.height), 0);
        glMultMatrixd(&frame.view.projection[0][0]);
        glMatrixMode(GL_MODELVIEW);
    }

    void set_pass(const Pass& pass) {
        const bool colored = pass.shade != Shade::None,
                   lit = colored && pass.shade != Shade::Id && pass.shade != Shade::VertexColor;
        glColorMask(colored, colored, colored, colored);
        enable(GL_DEPTH_TEST, pass.depth.test);
        glDepthFunc(depth_func(pass.depth.func)), glDepthMask(pass.depth.mask);
        enable(GL_BLEND, pass.blend.enable);
        glBlendFunc(factor(pass.blend.src), factor(pass.blend.dst));
        set_stencil(pass.stencil), set_fog(pass.fog);
        glShadeModel(lit ? GL_SMOOTH : GL_FLAT);
        enable(GL_LIGHTING, lit);
        if (lit) set_light(frame.lights[std::size_t(pass.light)], frame.view.lighting.local_viewer);
        enable(GL_TEXTURE_2D, pass.textured);
        const bool reflects = pass.shade == Shade::Reflection;
        glBindTexture(GL_TEXTURE_2D, reflects ? sphere_map : texture);
        enable(GL_TEXTURE_GEN_S, reflects), enable(GL_TEXTURE_GEN_T, reflects);
    }

    void draw_part(const Pass& pass, const Part& part, const GlMesh& mesh) {
        glLoadMatrixd(&part.eye_from_object[0][0]);
        if (glIsEnabled(GL_LIGHTING)) set_material(part.material, pass.shade);
        mesh.draw(attributes_of(pass));
    }
    void draw(const Pass& pass) {
        set_pass(pass);
        if (pass.geometry == Geometry::Volumes)
            return draw_part(pass, frame.volumes, volumes.front());
        if (pass.geometry == Geometry::Quad) {
            Part part = frame.quad;
            part.eye_from_object = pass.eye_from_quad;
            return draw_part(pass, part, quad.front());
        }
        for (std::size_t i = 0; i < scene.size(); ++i) draw_part(pass, frame.scene[i], scene[i]);
    }

    void sample(const Workload& w, const JitterState& jitter) {
        glColorMask(1, 1, 1, 1), glDepthMask(1), glStencilMask(255);
        glViewport(0, 0, frame.width, frame.height);
        glClearColor(0, 0, 0, 0), glClearDepth(1), glClearStencil(0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        set_projection(jitter);
        for (const Pass& pass : w.passes) draw(pass);
    }
    void run(const Workload& w) {
        const float share = 1.0f / float(w.samples.size());
        for (std::size_t i = 0; i < w.samples.size(); ++i) {
            sample(w, w.samples[i]);
            glColorMask(1, 1, 1, 1);
            if (w.samples.size() > 1) glAccum(i == 0 ? GL_LOAD : GL_ACCUM, share);
        }
        if (w.samples.size() > 1) glAccum(GL_RETURN, 1);
        glFinish();
    }
};

OpenGl::OpenGl(const Frame& frame, Store store)
    : context_(std::make_unique<Context>(frame, store)) {}
OpenGl::~OpenGl() = default;

void OpenGl::run(const Workload& workload) {
    context_->use();
    context_->run(workload);
}
const std::vector<unsigned char>& OpenGl::picture() const { return context_->buffer; }
std::string OpenGl::renderer() const {
    context_->use();
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace gw::peers
