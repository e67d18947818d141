// Selection and feedback: the vertices of primitives after clipping, and the names that are
// current, written to the caller's memory. [GL11] 5.2, 5.3. Nothing is drawn meanwhile.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>

#include <cstdint>
#include <vector>

namespace gw::gl {

struct Context;

inline constexpr std::size_t name_stack_depth = 64;

struct Selection {
    GLenum mode = GL_RENDER;  ///< RenderMode
    // Selection
    bool has_hits = false;  ///< SelectBuffer was called, perhaps for no memory at all
    GLuint* hits = nullptr;
    GLsizei hits_size = 0;
    GLsizei hits_used = 0;
    GLint hit_count = 0;
    bool hit = false;                  ///< since the name stack changed last
    double nearest = 1, farthest = 0;  ///< window depths of the hit, 0 .. 1
    std::vector<GLuint> names;
    // Feedback
    bool has_feedback = false;
    GLfloat* feedback = nullptr;
    GLsizei feedback_size = 0;
    GLsizei feedback_used = 0;  ///< also counted beyond the size
    GLenum feedback_type = GL_2D;
    bool overflow = false;
};

/// Runs the vertex and clip stages on a draw's primitives and writes what selection or feedback
/// asks for.
void report(Context& c, const Draw& draw);

/// In feedback mode, writes a token and the raster position.
void report_raster_position(Context& c, GLenum token);

/// Counts a hit at a window depth of the raster position.
void report_depth(Context& c, double depth);

}  // namespace gw::gl
