// The names of display lists, and the list that is open. [GL11] 5.4
#pragma once

#include "gl/state/free_names.h"

#include <GL/gl.h>

#include <map>
#include <memory>

namespace gw::gl {

class DisplayList;

/// Lists may call lists to this depth; deeper calls are left out. [GL11] table 6.20
inline constexpr int max_list_nesting = 64;

/// The names of lists, and the lists. Contexts may share them.
struct ListNames {
    /// null: reserved by GenLists, empty
    std::map<GLuint, std::shared_ptr<const DisplayList>> lists;
    FreeNames free_names;
};

/// The list that NewList opened.
struct OpenList {
    std::shared_ptr<DisplayList> open;
    GLuint name = 0;
    GLenum mode = GL_COMPILE;
    int nesting = 0;  ///< of the lists that are being played
};

}  // namespace gw::gl
