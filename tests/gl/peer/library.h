// OpenGL's functions of one libOSMesa, loaded beside another.
#pragma once

#include <GL/osmesa.h>

#include <string>

namespace gw::gl_peer {

/// All functions that are offered, by GL's names without gl.
struct Gl {
#define GW_GL_FUNCTION(name) decltype(&gl##name) name = nullptr;
#include "generated/gl/names.inc"
#undef GW_GL_FUNCTION

    decltype(&OSMesaCreateContextExt) create_context = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
};

/// Throws std::runtime_error if the file is none of OSMesa.
Gl load(const std::string& path);

}  // namespace gw::gl_peer
