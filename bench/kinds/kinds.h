// Kinds of calls and of fragments, each by itself, so that a slow one stands out. A scene is
// `side` x `side` pixels on the context that is current.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <functional>
#include <string>
#include <vector>

namespace gw::bench {

inline constexpr int side = 512;

struct Kind {
    std::string name;
    std::function<void()> begin;  ///< state; all attributes and matrices are restored afterwards
    std::function<void()> draw;   ///< what is timed
};
/// Pixels in and out, copies, blits, textures that are given.
std::vector<Kind> pixel_kinds();
/// A textured square, or a mesh of 1,200 triangles, in one state each.
std::vector<Kind> fragment_kinds();

/// A texture with these filters.
GLuint make_texture(GLenum target, GLenum min_filter);
/// Random bytes, enough for an image of 4 floats a pixel.
const std::vector<unsigned char>& noise();

}  // namespace gw::bench
