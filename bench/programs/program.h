// A program as programs of the time are: it draws frames by OpenGL 1.1 alone. The same frame number
// gives the same frame.
#pragma once

#include <GL/gl.h>

#include <functional>
#include <string>
#include <vector>

namespace gw::bench {

struct Program {
    std::string name, what;
    std::function<void()> begin;          ///< lists, textures, state; the context is current
    std::function<void(int frame)> draw;  ///< all calls of a frame, without the swap
    int frames = 60;                      ///< that are timed
};

/// By what they exercise; all() has them in this order.
std::vector<Program> vertex_programs();
std::vector<Program> list_programs();
std::vector<Program> texture_programs();
std::vector<Program> fragment_programs();
std::vector<Program> pixel_programs();
std::vector<Program> all_programs();

/// The current drawable's size.
inline int window_width = 0, window_height = 0;

}  // namespace gw::bench
