// The state of selection and feedback: the caller's buffers, and the stack of names. [GL11] 5.2, 5.3
#pragma once

#include <GL/gl.h>

#include <cstdint>
#include <vector>

namespace gw::gl {

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

}  // namespace gw::gl
