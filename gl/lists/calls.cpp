// NewList .. ListBase. [GL11] 5.4
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/lists/display_list.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

namespace gw::gl {

namespace {

/// How many bytes a name of this type has; 0: no such type.
int bytes_of_name(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE: return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_2_BYTES: return 2;
        case GL_3_BYTES: return 3;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
        case GL_4_BYTES: return 4;
    }
    return 0;
}

template <class T>
double value_at(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return double(value);
}

/// The name at this place; GL_2_BYTES and so on have their highest byte first.
double name_at(GLenum type, const unsigned char* at) {
    switch (type) {
        case GL_BYTE: return value_at<GLbyte>(at);
        case GL_UNSIGNED_BYTE: return value_at<GLubyte>(at);
        case GL_SHORT: return value_at<GLshort>(at);
        case GL_UNSIGNED_SHORT: return value_at<GLushort>(at);
        case GL_INT: return value_at<GLint>(at);
        case GL_UNSIGNED_INT: return value_at<GLuint>(at);
        case GL_FLOAT: return value_at<GLfloat>(at);
    }
    double name = 0;
    for (int i = 0; i < bytes_of_name(type); ++i) name = name * 256 + at[i];
    return name;
}

/// GenLists gives no more names at once: each is an entry of a table.
constexpr GLsizei most_names = 1 << 22;

/// A name without its fraction; 0 for numbers that are none.
GLuint whole_name(double name) {
    return std::abs(name) < 0x1p32 ? GLuint(static_cast<std::int64_t>(name)) : 0;
}

/// While one lives, the context's present call plays a display list.
class PlayedListScope {
public:
    PlayedListScope(CallTrace& calls, GLuint name) : calls_(calls) {
        if (!calls_are_kept) return;
        outer_ = std::exchange(calls_.list,
                               std::make_shared<const PlayedList>(PlayedList{name, calls_.now}));
    }
    ~PlayedListScope() {
        if (!calls_are_kept || !calls_.list) return;
        calls_.now = calls_.list->caller;
        calls_.list = std::move(outer_);
    }
    PlayedListScope(const PlayedListScope&) = delete;
    PlayedListScope& operator=(const PlayedListScope&) = delete;

private:
    CallTrace& calls_;
    std::shared_ptr<const PlayedList> outer_;
};

/// The list of a name; null: there is none, or it is empty.
std::shared_ptr<const DisplayList> list_named(Context& context, GLuint name) {
    const auto lock = context.shared->exclusive();
    const auto found = context.shared->lists.lists.find(name);
    return found != context.shared->lists.lists.end() ? found->second : nullptr;
}

void play(Context& context, GLuint name) {
    if (context.lists.nesting >= max_list_nesting) return;
    const std::shared_ptr<const DisplayList> list =
        list_named(context, name);  // it may delete itself
    if (!list) return;
    ++context.lists.nesting;
    const PlayedListScope scope(context.calls, name);
    list->play(context);
    --context.lists.nesting;
}

}  // namespace

Numbers list_names(GLsizei n, GLenum type, const GLvoid* lists) {
    auto names = std::make_shared<std::vector<double>>();
    const auto* at = static_cast<const unsigned char*>(lists);
    const int bytes = bytes_of_name(type);
    if (bytes == 0 || at == nullptr) return names;
    for (GLsizei i = 0; i < n; ++i, at += bytes) names->push_back(name_at(type, at));
    return names;
}

namespace execute {

void new_list(Context& context, GLuint list, GLenum mode) {
    if (list == 0) return set_error(context, GL_INVALID_VALUE);
    if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE)
        return set_error(context, GL_INVALID_ENUM);
    if (context.lists.open) return set_error(context, GL_INVALID_OPERATION);
    context.lists.open = std::make_shared<DisplayList>();
    context.lists.name = list;
    context.lists.mode = mode;
}

void end_list(Context& context) {
    if (!context.lists.open) return set_error(context, GL_INVALID_OPERATION);
    context.lists.open->seal();
    const auto lock = context.shared->exclusive();
    context.shared->lists.lists[context.lists.name] = std::move(context.lists.open);
    context.lists.open = nullptr;
}

void call_list(Context& context, GLuint list) { play(context, list); }

void call_lists(Context& context, GLsizei n, GLenum type, const Numbers& names) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (bytes_of_name(type) == 0) return set_error(context, GL_INVALID_ENUM);
    for (const double name : *names) play(context, context.state.list.base + whole_name(name));
}

GLuint gen_lists(Context& context, GLsizei range) {
    if (range < 0) return set_error(context, GL_INVALID_VALUE), 0;
    if (range == 0) return 0;
    if (range > most_names) return set_error(context, GL_OUT_OF_MEMORY), 0;
    const auto lock = context.shared->exclusive();
    ListNames& names = context.shared->lists;
    const GLuint first = names.free_names.take(names.lists, GLuint(range));
    if (first == 0) return 0;
    for (GLuint i = 0; i < GLuint(range); ++i) names.lists[first + i] = nullptr;
    return first;
}

GLboolean is_list(Context& context, GLuint list) {
    const auto lock = context.shared->exclusive();
    return context.shared->lists.lists.contains(list) ? GL_TRUE : GL_FALSE;
}

void delete_lists(Context& context, GLuint list, GLsizei range) {
    if (range < 0) return set_error(context, GL_INVALID_VALUE);
    const auto lock = context.shared->exclusive();
    auto& lists = context.shared->lists.lists;
    const std::uint64_t end = std::uint64_t(list) + std::uint64_t(range);
    const auto last =
        end > std::numeric_limits<GLuint>::max() ? lists.end() : lists.lower_bound(GLuint(end));
    lists.erase(lists.lower_bound(list), last);
    context.shared->lists.free_names.give_back(list);
}

void list_base(Context& context, GLuint base) { context.state.list.base = base; }

}  // namespace execute

}  // namespace gw::gl
