#include "inspect/peer/occlusion.h"

#include "inspect/peer/gl.h"

namespace gw::peer {

void Occlusion::run(const Query& c) {
    active_ = c.begin;
    if (c.begin) {
        if (name_ == 0) required(gl().GenQueries, "GL_ARB_occlusion_query", "a query")(1, &name_);
        gl().BeginQuery(GL_SAMPLES_PASSED, name_);
        return;
    }
    gl().EndQuery(GL_SAMPLES_PASSED);
    GLuint samples = 0;
    gl().GetQueryObjectuiv(name_, GL_QUERY_RESULT, &samples);
    results_.push_back({c.key, samples});
}

}  // namespace gw::peer
