// GenQueries .. GetQueryObjectuiv. [GL15] 4.1.7. A result is there when it is asked for, so that a
// program draws the same at every speed.
#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include <algorithm>
#include <limits>

namespace gw::gl {

namespace {

bool counts_samples(const Context& context) {
    return context.drawable != nullptr && context.profile.extensions.occlusion_query;
}

/// The count of a query object that is not active; null after an error.
const SampleCount* finished_count(Context& context, GLuint id) {
    QueryObjects& queries = context.queries;
    const auto found = queries.named.find(id);
    if (found == queries.named.end() || !found->second || id == queries.active)
        return set_error(context, GL_INVALID_OPERATION), nullptr;
    return found->second.get();
}

template <class T>
void get_query_object(Context& context, GLuint id, GLenum pname, T* params) {
    const SampleCount* const count = finished_count(context, id);
    if (count == nullptr || params == nullptr) return;
    if (pname != GL_QUERY_RESULT && pname != GL_QUERY_RESULT_AVAILABLE)
        return set_error(context, GL_INVALID_ENUM);
    finish_counts(context);
    constexpr std::uint64_t most = std::uint64_t(std::numeric_limits<T>::max());
    *params = pname == GL_QUERY_RESULT ? T(std::min(count->samples, most)) : T(GL_TRUE);
}

}  // namespace

namespace execute {

void gen_queries(Context& context, GLsizei n, GLuint* ids) {
    if (n >= 0 && context.queries.active != 0) return set_error(context, GL_INVALID_OPERATION);
    gen_names(context, context.queries, n, ids);
}

void delete_queries(Context& context, GLsizei n, const GLuint* ids) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (context.queries.active != 0) return set_error(context, GL_INVALID_OPERATION);
    if (ids == nullptr) return;
    for (GLsizei i = 0; i < n; ++i) {
        context.queries.named.erase(ids[i]);
        context.queries.free_names.give_back(ids[i]);
    }
}

GLboolean is_query(Context& context, GLuint id) {
    const auto found = context.queries.named.find(id);
    return found != context.queries.named.end() && found->second ? GL_TRUE : GL_FALSE;
}

void begin_query(Context& context, GLenum target, GLuint id) {
    if (target != GL_SAMPLES_PASSED) return set_error(context, GL_INVALID_ENUM);
    if (id == 0 || context.queries.active != 0) return set_error(context, GL_INVALID_OPERATION);
    flush_mesh(context);
    const auto count = std::make_shared<SampleCount>();
    context.queries.named[id] = count;
    context.queries.active = id;
    if (counts_samples(context)) context.drawable->begin_count(count);
}

void end_query(Context& context, GLenum target) {
    if (target != GL_SAMPLES_PASSED) return set_error(context, GL_INVALID_ENUM);
    if (context.queries.active == 0) return set_error(context, GL_INVALID_OPERATION);
    flush_mesh(context);
    const SampleCountRef& count = context.queries.named.at(context.queries.active);
    if (counts_samples(context)) context.drawable->end_count(count);
    context.queries.active = 0;
}

void get_queryiv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (target != GL_SAMPLES_PASSED ||
        (pname != GL_CURRENT_QUERY && pname != GL_QUERY_COUNTER_BITS))
        return set_error(context, GL_INVALID_ENUM);
    if (params == nullptr) return;
    const int bits = context.profile.extensions.occlusion_query ? 64 : 0;
    *params = pname == GL_CURRENT_QUERY ? GLint(context.queries.active) : bits;
}

void get_query_objectiv(Context& context, GLuint id, GLenum pname, GLint* params) {
    get_query_object(context, id, pname, params);
}
void get_query_objectuiv(Context& context, GLuint id, GLenum pname, GLuint* params) {
    get_query_object(context, id, pname, params);
}

}  // namespace execute

}  // namespace gw::gl
