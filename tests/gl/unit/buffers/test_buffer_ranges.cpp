// Ranges of buffers that are mapped or copied. GL_ARB_map_buffer_range, GL_ARB_copy_buffer
#include "tests/gl/unit/support/window.h"

#include <GL/glext.h>

namespace gw::gl {
namespace {

void bind_buffer(const std::array<GLubyte, 8>& bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 8, bytes.data(), GL_STATIC_DRAW);
}
void expect_error(GLenum error, const char* what) { EXPECT_EQ(glGetError(), error) << what; }

}  // namespace

TEST(GlBuffers, RangesAreMapped) {
    const Window window;
    bind_buffer({1, 2, 3, 4, 5, 6, 7, 8});
    auto* const bytes = static_cast<GLubyte*>(glMapBufferRange(
        GL_ARRAY_BUFFER, 2, 4, GL_MAP_WRITE_BIT | GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT));
    ASSERT_NE(bytes, nullptr);
    EXPECT_EQ(bytes[0], 3);
    bytes[3] = 66;
    void* pointer = nullptr;
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, bytes);
    const auto parameter = [](GLenum name) {
        GLint value = -1;
        glGetBufferParameteriv(GL_ARRAY_BUFFER, name, &value);
        return value;
    };
    EXPECT_EQ(parameter(GL_BUFFER_MAP_OFFSET), 2);
    EXPECT_EQ(parameter(GL_BUFFER_MAP_LENGTH), 4);
    EXPECT_EQ(parameter(GL_BUFFER_ACCESS_FLAGS),
              GL_MAP_WRITE_BIT | GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 3, 1);
    expect_error(GL_NO_ERROR, "a part of the range");
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 3, 2);
    expect_error(GL_INVALID_VALUE, "beyond the range");
    EXPECT_EQ(glUnmapBuffer(GL_ARRAY_BUFFER), GL_TRUE);
    EXPECT_EQ(parameter(GL_BUFFER_MAP_LENGTH), 0);
    std::array<GLubyte, 8> now{};
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, 8, now.data());
    EXPECT_EQ(now, (std::array<GLubyte, 8>{1, 2, 3, 4, 5, 66, 7, 8}));
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 1);
    expect_error(GL_INVALID_OPERATION, "not mapped");
    GLint access = 0;
    glMapBufferRange(GL_ARRAY_BUFFER, 0, 8, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS, &access);
    EXPECT_EQ(access, GL_WRITE_ONLY);
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 1);
    expect_error(GL_INVALID_OPERATION, "not flushed by the program");
}

TEST(GlBuffers, WrongRangesAreNotMapped) {
    const Window window;
    bind_buffer({});
    const auto error_of = [](GLintptr offset, GLsizeiptr length, GLbitfield access) {
        EXPECT_EQ(glMapBufferRange(GL_ARRAY_BUFFER, offset, length, access), nullptr);
        return glGetError();
    };
    EXPECT_EQ(error_of(-1, 4, GL_MAP_READ_BIT), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(error_of(0, -1, GL_MAP_READ_BIT), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(error_of(6, 3, GL_MAP_READ_BIT), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(error_of(0, 4, GL_MAP_READ_BIT | 0x8000), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(error_of(0, 0, GL_MAP_READ_BIT), GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(error_of(0, 4, GL_MAP_UNSYNCHRONIZED_BIT), GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(error_of(0, 4, GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT),
              GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(error_of(0, 4, GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT),
              GLenum(GL_INVALID_OPERATION));
    glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    EXPECT_EQ(error_of(0, 4, GL_MAP_READ_BIT), GLenum(GL_INVALID_OPERATION));
}

TEST(GlBuffers, RangesAreCopied) {
    const Window window;
    bind_buffer({1, 2, 3, 4, 5, 6, 7, 8});
    glBindBuffer(GL_COPY_READ_BUFFER, 1);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 2);
    glBufferData(GL_COPY_WRITE_BUFFER, 4, nullptr, GL_STATIC_DRAW);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 5, 1, 3);
    std::array<GLubyte, 4> copied{};
    glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, 4, copied.data());
    EXPECT_EQ(copied, (std::array<GLubyte, 4>{0, 6, 7, 8}));
    glCopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 4, 4);  // within one buffer
    std::array<GLubyte, 8> now{};
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, 8, now.data());
    EXPECT_EQ(now, (std::array<GLubyte, 8>{1, 2, 3, 4, 1, 2, 3, 4}));
    expect_error(GL_NO_ERROR, "copies");
    glCopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 3, 4);
    expect_error(GL_INVALID_VALUE, "parts that overlap");
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 2, 3);
    expect_error(GL_INVALID_VALUE, "beyond the buffer");
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, -1, 0, 1);
    expect_error(GL_INVALID_VALUE, "a negative offset");
    glMapBuffer(GL_COPY_WRITE_BUFFER, GL_READ_ONLY);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, 1);
    expect_error(GL_INVALID_OPERATION, "mapped");
    GLint bound[2] = {};
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);  // they are not the client's
    glBindBuffer(GL_COPY_READ_BUFFER, 2);
    glPopClientAttrib();
    glGetIntegerv(GL_COPY_READ_BUFFER_BINDING, &bound[0]);
    const GLuint name = 2;
    glDeleteBuffers(1, &name);
    glGetIntegerv(GL_COPY_WRITE_BUFFER_BINDING, &bound[1]);
    EXPECT_EQ(bound[0], 2);
    EXPECT_EQ(bound[1], 0);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, 1);
    expect_error(GL_INVALID_OPERATION, "no buffer");
    glCopyBufferSubData(GL_RED, GL_COPY_WRITE_BUFFER, 0, 0, 1);
    expect_error(GL_INVALID_ENUM, "target");
}

}  // namespace gw::gl
