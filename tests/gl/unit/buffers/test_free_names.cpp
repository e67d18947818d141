// Names that Gen.. and GenLists give are free, and the lowest there are; against a set that is
// searched from 1.
#include "gl/state/free_names.h"

#include "tests/gl/unit/support/window.h"
#include "tests/gw/random.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gw::gl {
namespace {

GLuint lowest_free(const std::map<GLuint, int>& named) {
    GLuint name = 1;
    while (named.contains(name)) ++name;
    return name;
}

TEST(FreeNames, AreTheLowestWhateverIsDeletedOrUsedUnasked) {
    test::Random random(5);
    std::map<GLuint, int> named;
    FreeNames free_names;
    for (int i = 0; i < 20000; ++i) {
        const auto any = GLuint(random.between(1, 300));
        switch (random.between(0, 3)) {
            case 0: named[any] = 1; break;  // bound without Gen
            case 1:
                if (named.erase(any) != 0) free_names.give_back(any);
                break;
            case 2: {
                const GLuint expected = lowest_free(named), name = free_names.take(named);
                ASSERT_EQ(name, expected) << i;
                named[name] = 1;
                break;
            }
            default: {
                const auto count = GLuint(random.between(2, 6));
                const GLuint first = free_names.take(named, count);
                ASSERT_NE(first, 0u);
                for (GLuint k = 0; k < count; ++k) ASSERT_TRUE(named.emplace(first + k, 1).second);
            }
        }
        if (named.size() > 400) {  // the names from one on, as DeleteLists does
            named.erase(named.lower_bound(any), named.end());
            free_names.give_back(any);
        }
    }
}

TEST(FreeNames, EndAtTheLargestName) {
    std::map<GLuint, int> named{{0xFFFFFFF0, 1}};
    FreeNames free_names;
    EXPECT_EQ(free_names.take(named, 0xFFFFFFEF), 1u);
    for (GLuint name = 1; name < 20; ++name) named[name] = 1;
    EXPECT_EQ(free_names.take(named, 0x7FFFFFFF), 20u);  // the rest, from below again
    EXPECT_EQ(free_names.take(named, 0xFFFFFFF0), 0u);
}

/// A name more costs no search of all others: 100,000 of each kind, which took minutes.
TEST(FreeNames, ManyOfEachKind) {
    const Window window;
    constexpr GLsizei many = 100000;
    for (GLuint i = 1; i <= many; ++i) ASSERT_EQ(glGenLists(1), i);
    for (const auto generate :
         {glGenTextures, glGenBuffers, glGenQueries, glGenFramebuffers, glGenRenderbuffers})
        for (GLuint i = 1; i <= many; ++i) {
            GLuint name = 0;
            generate(1, &name);
            ASSERT_EQ(name, i);
        }
    glDeleteLists(7, 3);
    EXPECT_EQ(glGenLists(1), 7u);
    EXPECT_EQ(glGenLists(2), 8u);
    EXPECT_EQ(glGenLists(3), GLuint(many) + 1);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace gw::gl
