// Shaded and lit indices: a texture of all indices rounds at each pixel.
#include "irisgl/draw/primitives.h"

#include "irisgl/draw/apply.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include <GL/gl.h>

#include <algorithm>
#include <map>

namespace gw::irisgl {

namespace {

constexpr GLuint index_texture_name = 0x70000000;
constexpr int texel_count = 4096;

void make_texture() {
    const int bits = current_window().profile().color_bits;
    const IndexColor code{std::min(bits, 8)};
    const unsigned most = (1u << bits) - 1;
    std::vector<std::uint16_t> texels;
    for (unsigned i = 0; i < texel_count; ++i)
        for (const unsigned v : {code.low(i), code.high(i), 0u, most})
            texels.push_back(std::uint16_t((std::uint64_t(v) * 65535 + most / 2) / most));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage1D(GL_TEXTURE_1D, 0, bits > 8 ? GL_RGBA16 : GL_RGBA8, texel_count, 0, GL_RGBA,
                 GL_UNSIGNED_SHORT, texels.data());
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

}  // namespace

bool bind_index_texture() {
    const Window& w = current_window();
    if (!w.profile().extensions.texture_sizes || !w.profile().extensions.texture_formats) {
        warn("the profile has no texture of 4096 texels: colour indices are not shaded");
        return false;
    }
    const bool known = glIsTexture(index_texture_name) != GL_FALSE;
    glBindTexture(GL_TEXTURE_1D, index_texture_name);
    if (!known) make_texture();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    return true;
}

void use_index_texture(bool on) { (on ? glEnable : glDisable)(GL_TEXTURE_1D); }

}  // namespace gw::irisgl
