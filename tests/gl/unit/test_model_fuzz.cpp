// Seeded sequences of calls, right and wrong, with lists and stacks, on GL and on the model of its
// state in support/model.h: the same errors, and the same values of all variables of the model.
#include "tests/gl/unit/support/model_calls.h"
#include "tests/gl/unit/support/window.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gw::gl {
namespace {

using model::Dice;
using model::Model;
using model::Pair;
using model::Place;

/// Lists call those of lower names only: several calls of itself would play a list 2^64 times.
Pair list(Dice& dice, GLuint open) {
    const GLuint name = GLuint(dice.below(6));
    const GLenum mode = dice.among({GL_COMPILE, GL_COMPILE_AND_EXECUTE});
    switch (dice.below(5)) {
        case 0:
            return {{Place::Now, [=](Model& m) { m.new_list(name, mode); }},
                    [=] { glNewList(name, mode); }};
        case 1: return {{Place::Now, [](Model& m) { m.end_list(); }}, glEndList};
        case 2:
            return {{Place::Now,
                     [=](Model& m) {
                         for (GLuint i = 0; i < 2; ++i) m.lists.erase(name + i);
                     }},
                    [=] { glDeleteLists(name, 2); }};
    }
    const GLuint called = open != 0 ? (open > 1 ? GLuint(dice.below(int(open))) : 0) : name;
    return {{Place::Anywhere, [=](Model& m) { m.call_list(called); }}, [=] { glCallList(called); }};
}

Pair some_call(Dice& dice, GLuint open) {
    if (dice.chance(12)) return list(dice, open);
    const auto makers = dice.chance(50) ? model::drawing_calls() : model::other_calls();
    return makers[std::size_t(dice.below(int(makers.size())))](dice);
}

void expect_equal(const Model& m) {
    for (const auto& [name, expected] : m.all()) {
        std::array<GLdouble, 16> values{};
        glGetDoublev(name, values.data());
        double largest = 1;
        for (const double v : expected) largest = std::max(largest, std::abs(v));
        for (std::size_t i = 0; i < expected.size(); ++i)
            ASSERT_NEAR(values[i], expected[i], 1e-6 * largest)
                << std::hex << "variable 0x" << name << " [" << i << "]";
    }
}

/// Ends a run whose End may be far; an open list does not get it.
void end_run(Window& window, Model& m) {
    OpenList& lists = window.context.lists;
    const auto open = std::exchange(lists.open, nullptr);
    glEnd();
    lists.open = open;
    m.inside = false;
}

void run_program(unsigned seed, int count) {
    Window window(16, 16);
    Dice dice(seed);
    Model m;
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", call " << i);
        const Pair pair = some_call(dice, m.open());
        m.perform(pair.call);
        pair.gl();
        ASSERT_EQ(window.context.assembler.inside, m.inside);
        if (m.inside && dice.chance(20)) end_run(window, m);
        if (m.inside) continue;
        if (dice.chance(15)) {
            ASSERT_EQ(glGetError(), m.error);
            m.error = GL_NO_ERROR;
        }
        if (i % 4 == 0) expect_equal(m);
        if (testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace

TEST(GlModelFuzz, CallsDoWhatTheSpecificationSays) {
    for (unsigned seed = 0; seed < 24 && !HasFatalFailure(); ++seed) run_program(seed, 3000);
}

}  // namespace gw::gl
