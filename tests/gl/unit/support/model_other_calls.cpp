#include "tests/gl/unit/support/model_calls.h"

#include <algorithm>

namespace gw::gl::model {

namespace {

Pair pixel_state(Dice& dice) {
    const double v = dice.real();
    const int whole = dice.below(9) - 2;
    const auto transfer = [&](GLenum name) {
        return Pair{{Place::Outside, [=](Model& m) { m.set(name, {v}); }},
                    [=] { glPixelTransferf(name, GLfloat(v)); }};
    };
    const auto store = [&](GLenum name, bool valid) {
        return Pair{{Place::Client,
                     [=](Model& m) { m.set(name, {double(whole)}, valid, GL_INVALID_VALUE); }},
                    [=] { glPixelStorei(name, whole); }};
    };
    switch (dice.below(9)) {
        case 0: return transfer(GL_RED_SCALE);
        case 1: return transfer(GL_ALPHA_BIAS);
        case 2: return transfer(GL_DEPTH_SCALE);
        case 3:
            return {{Place::Outside, [=](Model& m) { m.set(GL_INDEX_SHIFT, {double(whole)}); }},
                    [=] { glPixelTransferi(GL_INDEX_SHIFT, whole); }};
        case 4: return store(GL_UNPACK_ROW_LENGTH, whole >= 0);
        case 5: return store(GL_PACK_SKIP_PIXELS, whole >= 0);
        case 6: return store(GL_UNPACK_ALIGNMENT, whole == 1 || whole == 2 || whole == 4);
        case 7:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_ZOOM_X, {v});
                         m.set(GL_ZOOM_Y, {double(whole)});
                     }},
                    [=] { glPixelZoom(GLfloat(v), GLfloat(whole)); }};
    }
    return {{Place::Outside, [=](Model& m) { m.set(GL_MAP_COLOR, {v != 0 ? 1.0 : 0.0}); }},
            [=] { glPixelTransferf(GL_MAP_COLOR, GLfloat(v)); }};
}

Pair client_array(Dice& dice) {
    const GLenum array = dice.among({GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_EDGE_FLAG_ARRAY});
    const int components = dice.below(6), stride = dice.below(9) - 1;
    const GLenum type = dice.among({GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
    if (dice.chance(50)) {
        const bool on = dice.chance(50);
        return {{Place::Client, [=](Model& m) { m.set(array, {on ? 1.0 : 0.0}, array != 0x1234); }},
                [=] { on ? glEnableClientState(array) : glDisableClientState(array); }};
    }
    return {{Place::Client,
             [=](Model& m) {
                 if (components < 2 || components > 4) return m.fail(GL_INVALID_VALUE);
                 if (type == 0x1234) return m.fail(GL_INVALID_ENUM);
                 if (stride < 0) return m.fail(GL_INVALID_VALUE);
                 m.set(GL_VERTEX_ARRAY_SIZE, {double(components)});
                 m.set(GL_VERTEX_ARRAY_TYPE, {double(type)});
                 m.set(GL_VERTEX_ARRAY_STRIDE, {double(stride)});
             }},
            [=] { glVertexPointer(components, type, stride, nullptr); }};
}

Pair matrix(Dice& dice) {
    const double x = dice.real(), y = dice.real();
    switch (dice.below(7)) {
        case 0: return {{Place::Outside, [](Model& m) { m.push_matrix(); }}, glPushMatrix};
        case 1:
        case 2: return {{Place::Outside, [](Model& m) { m.pop_matrix(); }}, glPopMatrix};
        case 3:
            return {{Place::Outside, [](Model& m) { m.matrices().back() = model::identity(); }},
                    glLoadIdentity};
        case 4:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.multiply({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 1, 1});
                     }},
                    [=] { glTranslated(x, y, 1); }};
        case 5:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.multiply({x, 0, 0, 0, 0, y, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1});
                     }},
                    [=] { glScaled(x, y, 0.5); }};
    }
    return {
        {Place::Outside,
         [=](Model& m) {
             if (x == 1) return m.fail(GL_INVALID_VALUE);
             const double width = 1 - x;
             m.multiply({2 / width, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, -(1 + x) / width, 0, 0, 1});
         }},
        [=] { glOrtho(x, 1, -1, 1, -1, 1); }};
}

Pair stack(Dice& dice) {
    const GLbitfield mask = dice.chance(20) ? GLbitfield(GL_ALL_ATTRIB_BITS) : dice.bits();
    switch (dice.below(6)) {
        case 0:
        case 1:
            return {{Place::Outside, [=](Model& m) { m.push_attributes(mask); }},
                    [=] { glPushAttrib(mask); }};
        case 2:
        case 3: return {{Place::Outside, [](Model& m) { m.pop_attributes(); }}, glPopAttrib};
        case 4:
            return {{Place::Client, [=](Model& m) { m.push_client(mask); }},
                    [=] { glPushClientAttrib(mask); }};
    }
    return {{Place::Client, [](Model& m) { m.pop_client(); }}, glPopClientAttrib};
}

Pair texture(Dice& dice) {
    const bool flat = dice.chance(30);
    const GLenum target = flat ? GL_TEXTURE_1D : GL_TEXTURE_2D;
    const GLuint name = GLuint(dice.below(4)) + (flat ? 0 : 10);
    const GLuint other = flat ? name + 10 : name == 10 ? 0 : name - 10;
    const GLenum variable = flat ? GL_TEXTURE_BINDING_1D : GL_TEXTURE_BINDING_2D;
    const GLuint bound = name == 10 ? 0 : name;
    if (dice.chance(80))
        return {{Place::Outside, [=](Model& m) { m.set(variable, {double(bound)}); }},
                [=] { glBindTexture(target, bound); }};
    if (other == 0 || bound == 0)
        return {{Place::Outside, [](Model& m) { m.fail(GL_INVALID_ENUM); }},
                [] { glBindTexture(GL_TEXTURE_ENV, 1); }};
    return {{Place::Now,
             [=](Model& m) {
                 if (m.values[variable][0] == double(bound)) m.values[variable] = {0};
             }},
            [=] { glDeleteTextures(1, &bound); }};
}

Pair grid(Dice& dice) {
    const int n = dice.below(6) - 1;
    const double u = dice.real();
    if (dice.chance(50))
        return {{Place::Outside,
                 [=](Model& m) {
                     if (n < 1) return m.fail(GL_INVALID_VALUE);
                     m.set(GL_MAP1_GRID_SEGMENTS, {double(n)});
                     m.set(GL_MAP1_GRID_DOMAIN, {u, 4});
                 }},
                [=] { glMapGrid1d(n, u, 4); }};
    const GLenum mode = dice.among({GL_FASTEST, GL_NICEST, GL_DONT_CARE});
    return {{Place::Outside, [=](Model& m) { m.set(GL_FOG_HINT, {double(mode)}, mode != 0x1234); }},
            [=] { glHint(GL_FOG_HINT, mode); }};
}

Pair run(Dice& dice) {
    const GLenum mode = GLenum(dice.below(11));
    if (dice.chance(40))
        return {{Place::Anywhere,
                 [=](Model& m) {
                     if (m.inside) return m.fail(GL_INVALID_OPERATION);
                     if (mode > GL_POLYGON) return m.fail(GL_INVALID_ENUM);
                     m.inside = true;
                 }},
                [=] { glBegin(mode); }};
    if (dice.chance(60))
        return {{Place::Anywhere,
                 [](Model& m) {
                     if (!m.inside) m.fail(GL_INVALID_OPERATION);
                     m.inside = false;
                 }},
                glEnd};
    return {{Place::Anywhere, [](Model&) {}}, [] { glVertex2i(1, 2); }};
}

}  // namespace

std::span<const Maker> other_calls() {
    static constexpr Maker makers[] = {pixel_state, client_array, matrix, stack,
                                       texture,     grid,         run,    matrix};
    return makers;
}

}  // namespace gw::gl::model
