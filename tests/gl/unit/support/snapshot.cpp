#include "tests/gl/unit/support/snapshot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace gw::gl {

namespace {

/// No variable has this value.
constexpr double untouched = -98765.4375;

std::string hexadecimal(GLenum name) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%x", name);
    return text.data();
}

/// Adds what `get` writes, if it sets no error.
template <class T, class Get>
void add(Snapshot& out, const std::string& name, Get get) {
    std::array<T, 16> values;
    values.fill(T(untouched));
    get(values.data());
    if (glGetError() != GL_NO_ERROR) return;
    std::size_t count = values.size();
    while (count > 0 && values[count - 1] == T(untouched)) --count;
    out[name].assign(values.begin(), values.begin() + std::ptrdiff_t(count));
}

void add_variables(Snapshot& out) {
    constexpr std::pair<GLenum, GLenum> ranges[] = {
        {0x0B00, 0x0E00}, {0x2A00, 0x2A03}, {0x3000, 0x3006}, {0x4000, 0x4008}, {0x8000, 0x8010},
        {0x8030, 0x8040}, {0x8060, 0x8094}, {0x80C8, 0x80CC}, {0x809D, 0x80AC}, {0x84E0, 0x84E7},
        {0x8512, 0x851D}, {0x8890, 0x88A0}, {0x88ED, 0x88F0}};
    for (const auto& [first, last] : ranges)
        for (GLenum name = first; name < last; ++name)
            add<double>(out, variable(name), [&](double* v) { glGetDoublev(name, v); });
}

void add_lighting(Snapshot& out) {
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
        for (GLenum name = GL_AMBIENT; name <= GL_QUADRATIC_ATTENUATION; ++name)
            add<float>(out, "light " + std::to_string(light - GL_LIGHT0) + " " + hexadecimal(name),
                       [&](float* v) { glGetLightfv(light, name, v); });
    for (const GLenum face : {GL_FRONT, GL_BACK})
        for (const GLenum name :
             {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES})
            add<float>(out, "material " + hexadecimal(face) + " " + hexadecimal(name),
                       [&](float* v) { glGetMaterialfv(face, name, v); });
}

void add_texture(Snapshot& out) {
    for (const GLenum name : {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR})
        add<float>(out, "environment " + hexadecimal(name),
                   [&](float* v) { glGetTexEnvfv(GL_TEXTURE_ENV, name, v); });
    for (const GLenum coord : {GL_S, GL_T, GL_R, GL_Q})
        for (const GLenum name : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE})
            add<double>(out, "generation " + hexadecimal(coord) + " " + hexadecimal(name),
                        [&](double* v) { glGetTexGendv(coord, name, v); });
    for (const GLenum target :
         {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
        for (const GLenum name :
             {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
              GL_TEXTURE_WRAP_R, GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_PRIORITY,
              GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC})
            add<float>(out, "texture " + hexadecimal(target) + " " + hexadecimal(name),
                       [&](float* v) { glGetTexParameterfv(target, name, v); });
}

void add_others(Snapshot& out) {
    for (GLenum plane = GL_CLIP_PLANE0; plane <= GL_CLIP_PLANE5; ++plane)
        add<double>(out, "plane " + hexadecimal(plane),
                    [&](double* v) { glGetClipPlane(plane, v); });
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(name, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    std::array<GLubyte, 128> stipple{};
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetPolygonStipple(stipple.data());
    glPopClientAttrib();
    out["stipple"].assign(stipple.begin(), stipple.end());
}

/// Not a number equals itself here.
bool is_same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return x == y || (std::isnan(x) && std::isnan(y));
    });
}

}  // namespace

std::string variable(GLenum name) { return hexadecimal(name); }

Snapshot snapshot() {
    Snapshot out;
    add_variables(out);
    add_lighting(out);
    add_texture(out);
    add_others(out);
    return out;
}

std::vector<std::string> changes(const Snapshot& before, const Snapshot& after) {
    std::vector<std::string> out;
    for (const auto& [name, values] : before) {
        const auto found = after.find(name);
        if (found == after.end() || !is_same(found->second, values)) out.push_back(name);
    }
    return out;
}

}  // namespace gw::gl
