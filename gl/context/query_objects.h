// Occlusion queries: the names of query objects and their counts. [GL15] 4.1.7
#pragma once

#include "gl/drawable/sample_counts.h"
#include "gl/state/free_names.h"

#include <GL/gl.h>

#include <map>

namespace gw::gl {

struct QueryObjects {
    std::map<GLuint, SampleCountRef> named;  ///< null: reserved by GenQueries, no query yet
    FreeNames free_names;
    GLuint active = 0;  ///< 0: none
};

}  // namespace gw::gl
