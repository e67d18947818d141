#include "tests/gl/unit/support/model.h"

#include <iterator>

namespace gw::gl::model {

namespace {

/// [GL11] tables 6.5 to 6.22: a variable, the bits of PushAttrib that save it, its first value.
struct Variable {
    GLenum name;
    GLbitfield groups;
    Row initial;
};

constexpr GLbitfield enable = GL_ENABLE_BIT;

const std::vector<Variable>& variables() {
    static const std::vector<Variable> all{
        {GL_CURRENT_COLOR, GL_CURRENT_BIT, {1, 1, 1, 1}},
        {GL_CURRENT_INDEX, GL_CURRENT_BIT, {1}},
        {GL_CURRENT_NORMAL, GL_CURRENT_BIT, {0, 0, 1}},
        {GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_BIT, {0, 0, 0, 1}},
        {GL_EDGE_FLAG, GL_CURRENT_BIT, {1}},
        {GL_POINT_SIZE, GL_POINT_BIT, {1}},
        {GL_POINT_SMOOTH, GL_POINT_BIT | enable, {0}},
        {GL_LINE_WIDTH, GL_LINE_BIT, {1}},
        {GL_LINE_SMOOTH, GL_LINE_BIT | enable, {0}},
        {GL_LINE_STIPPLE, GL_LINE_BIT | enable, {0}},
        {GL_LINE_STIPPLE_PATTERN, GL_LINE_BIT, {65535}},
        {GL_LINE_STIPPLE_REPEAT, GL_LINE_BIT, {1}},
        {GL_CULL_FACE, GL_POLYGON_BIT | enable, {0}},
        {GL_CULL_FACE_MODE, GL_POLYGON_BIT, {GL_BACK}},
        {GL_FRONT_FACE, GL_POLYGON_BIT, {GL_CCW}},
        {GL_POLYGON_MODE, GL_POLYGON_BIT, {GL_FILL, GL_FILL}},
        {GL_POLYGON_SMOOTH, GL_POLYGON_BIT | enable, {0}},
        {GL_POLYGON_STIPPLE, GL_POLYGON_BIT | enable, {0}},
        {GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_BIT, {0}},
        {GL_POLYGON_OFFSET_UNITS, GL_POLYGON_BIT, {0}},
        {GL_POLYGON_OFFSET_POINT, GL_POLYGON_BIT | enable, {0}},
        {GL_POLYGON_OFFSET_LINE, GL_POLYGON_BIT | enable, {0}},
        {GL_POLYGON_OFFSET_FILL, GL_POLYGON_BIT | enable, {0}},
        {GL_LIGHTING, GL_LIGHTING_BIT | enable, {0}},
        {GL_LIGHT0, GL_LIGHTING_BIT | enable, {0}},
        {GL_LIGHT7, GL_LIGHTING_BIT | enable, {0}},
        {GL_SHADE_MODEL, GL_LIGHTING_BIT, {GL_SMOOTH}},
        {GL_LIGHT_MODEL_AMBIENT, GL_LIGHTING_BIT, {0.2, 0.2, 0.2, 1}},
        {GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHTING_BIT, {0}},
        {GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHTING_BIT, {0}},
        {GL_COLOR_MATERIAL, GL_LIGHTING_BIT | enable, {0}},
        {GL_COLOR_MATERIAL_FACE, GL_LIGHTING_BIT, {GL_FRONT_AND_BACK}},
        {GL_COLOR_MATERIAL_PARAMETER, GL_LIGHTING_BIT, {GL_AMBIENT_AND_DIFFUSE}},
        {GL_FOG, GL_FOG_BIT | enable, {0}},
        {GL_FOG_MODE, GL_FOG_BIT, {GL_EXP}},
        {GL_FOG_DENSITY, GL_FOG_BIT, {1}},
        {GL_FOG_START, GL_FOG_BIT, {0}},
        {GL_FOG_END, GL_FOG_BIT, {1}},
        {GL_FOG_COLOR, GL_FOG_BIT, {0, 0, 0, 0}},
        {GL_DEPTH_TEST, GL_DEPTH_BUFFER_BIT | enable, {0}},
        {GL_DEPTH_FUNC, GL_DEPTH_BUFFER_BIT, {GL_LESS}},
        {GL_DEPTH_WRITEMASK, GL_DEPTH_BUFFER_BIT, {1}},
        {GL_DEPTH_CLEAR_VALUE, GL_DEPTH_BUFFER_BIT, {1}},
        {GL_ACCUM_CLEAR_VALUE, GL_ACCUM_BUFFER_BIT, {0, 0, 0, 0}},
        {GL_STENCIL_TEST, GL_STENCIL_BUFFER_BIT | enable, {0}},
        {GL_STENCIL_FUNC, GL_STENCIL_BUFFER_BIT, {GL_ALWAYS}},
        {GL_STENCIL_REF, GL_STENCIL_BUFFER_BIT, {0}},
        {GL_STENCIL_FAIL, GL_STENCIL_BUFFER_BIT, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_BUFFER_BIT, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_BUFFER_BIT, {GL_KEEP}},
        {GL_STENCIL_CLEAR_VALUE, GL_STENCIL_BUFFER_BIT, {0}},
        {GL_DEPTH_RANGE, GL_VIEWPORT_BIT, {0, 1}},
        {GL_VIEWPORT, GL_VIEWPORT_BIT, {0, 0, 16, 16}},
        {GL_MATRIX_MODE, GL_TRANSFORM_BIT, {GL_MODELVIEW}},
        {GL_NORMALIZE, GL_TRANSFORM_BIT | enable, {0}},
        {GL_CLIP_PLANE0, GL_TRANSFORM_BIT | enable, {0}},
        {GL_CLIP_PLANE5, GL_TRANSFORM_BIT | enable, {0}},
        {GL_ALPHA_TEST, GL_COLOR_BUFFER_BIT | enable, {0}},
        {GL_ALPHA_TEST_FUNC, GL_COLOR_BUFFER_BIT, {GL_ALWAYS}},
        {GL_ALPHA_TEST_REF, GL_COLOR_BUFFER_BIT, {0}},
        {GL_BLEND, GL_COLOR_BUFFER_BIT | enable, {0}},
        {GL_BLEND_SRC, GL_COLOR_BUFFER_BIT, {GL_ONE}},
        {GL_BLEND_DST, GL_COLOR_BUFFER_BIT, {GL_ZERO}},
        {GL_DITHER, GL_COLOR_BUFFER_BIT | enable, {1}},
        {GL_INDEX_LOGIC_OP, GL_COLOR_BUFFER_BIT | enable, {0}},
        {GL_COLOR_LOGIC_OP, GL_COLOR_BUFFER_BIT | enable, {0}},
        {GL_LOGIC_OP_MODE, GL_COLOR_BUFFER_BIT, {GL_COPY}},
        {GL_COLOR_WRITEMASK, GL_COLOR_BUFFER_BIT, {1, 1, 1, 1}},
        {GL_COLOR_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, {0, 0, 0, 0}},
        {GL_INDEX_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, {0}},
        {GL_PERSPECTIVE_CORRECTION_HINT, GL_HINT_BIT, {GL_DONT_CARE}},
        {GL_FOG_HINT, GL_HINT_BIT, {GL_DONT_CARE}},
        {GL_MAP1_VERTEX_3, GL_EVAL_BIT | enable, {0}},
        {GL_MAP2_COLOR_4, GL_EVAL_BIT | enable, {0}},
        {GL_AUTO_NORMAL, GL_EVAL_BIT | enable, {0}},
        {GL_MAP1_GRID_SEGMENTS, GL_EVAL_BIT, {1}},
        {GL_MAP1_GRID_DOMAIN, GL_EVAL_BIT, {0, 1}},
        {GL_MAP2_GRID_SEGMENTS, GL_EVAL_BIT, {1, 1}},
        {GL_MAP2_GRID_DOMAIN, GL_EVAL_BIT, {0, 1, 0, 1}},
        {GL_LIST_BASE, GL_LIST_BIT, {0}},
        {GL_TEXTURE_1D, GL_TEXTURE_BIT | enable, {0}},
        {GL_TEXTURE_2D, GL_TEXTURE_BIT | enable, {0}},
        {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BIT, {0}},
        {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BIT, {0}},
        {GL_TEXTURE_GEN_S, GL_TEXTURE_BIT | enable, {0}},
        {GL_TEXTURE_GEN_Q, GL_TEXTURE_BIT | enable, {0}},
        {GL_SCISSOR_TEST, GL_SCISSOR_BIT | enable, {0}},
        {GL_SCISSOR_BOX, GL_SCISSOR_BIT, {0, 0, 16, 16}},
        {GL_MAP_COLOR, GL_PIXEL_MODE_BIT, {0}},
        {GL_MAP_STENCIL, GL_PIXEL_MODE_BIT, {0}},
        {GL_INDEX_SHIFT, GL_PIXEL_MODE_BIT, {0}},
        {GL_INDEX_OFFSET, GL_PIXEL_MODE_BIT, {0}},
        {GL_RED_SCALE, GL_PIXEL_MODE_BIT, {1}},
        {GL_ALPHA_BIAS, GL_PIXEL_MODE_BIT, {0}},
        {GL_DEPTH_SCALE, GL_PIXEL_MODE_BIT, {1}},
        {GL_ZOOM_X, GL_PIXEL_MODE_BIT, {1}},
        {GL_ZOOM_Y, GL_PIXEL_MODE_BIT, {1}}};
    return all;
}

/// [GL11] tables 6.5 and 6.15: a variable of the client, its bit of PushClientAttrib, its first value.
const std::vector<Variable>& client_variables() {
    static const std::vector<Variable> all{
        {GL_UNPACK_SWAP_BYTES, GL_CLIENT_PIXEL_STORE_BIT, {0}},
        {GL_UNPACK_ROW_LENGTH, GL_CLIENT_PIXEL_STORE_BIT, {0}},
        {GL_UNPACK_SKIP_ROWS, GL_CLIENT_PIXEL_STORE_BIT, {0}},
        {GL_UNPACK_ALIGNMENT, GL_CLIENT_PIXEL_STORE_BIT, {4}},
        {GL_PACK_LSB_FIRST, GL_CLIENT_PIXEL_STORE_BIT, {0}},
        {GL_PACK_SKIP_PIXELS, GL_CLIENT_PIXEL_STORE_BIT, {0}},
        {GL_PACK_ALIGNMENT, GL_CLIENT_PIXEL_STORE_BIT, {4}},
        {GL_VERTEX_ARRAY, GL_CLIENT_VERTEX_ARRAY_BIT, {0}},
        {GL_COLOR_ARRAY, GL_CLIENT_VERTEX_ARRAY_BIT, {0}},
        {GL_EDGE_FLAG_ARRAY, GL_CLIENT_VERTEX_ARRAY_BIT, {0}},
        {GL_VERTEX_ARRAY_SIZE, GL_CLIENT_VERTEX_ARRAY_BIT, {4}},
        {GL_VERTEX_ARRAY_TYPE, GL_CLIENT_VERTEX_ARRAY_BIT, {GL_FLOAT}},
        {GL_VERTEX_ARRAY_STRIDE, GL_CLIENT_VERTEX_ARRAY_BIT, {0}},
        {GL_NORMAL_ARRAY_TYPE, GL_CLIENT_VERTEX_ARRAY_BIT, {GL_FLOAT}}};
    return all;
}

constexpr std::size_t stack_depth = 16;         // as large as the minimum of table 6.21
constexpr std::size_t depths[] = {32, 10, 10};  // of modelview, projection, texture
constexpr int nesting_limit = 64;

std::size_t stack_of(GLenum mode) {
    return mode == GL_MODELVIEW ? 0 : mode == GL_PROJECTION ? 1 : 2;
}

}  // namespace

bool is_capability(GLenum name) {
    for (const Variable& v : variables())
        if (v.name == name) return (v.groups & enable) != 0;
    return false;
}

Matrix identity() { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }

Model::Model() {
    for (const Variable& v : variables()) values[v.name] = v.initial;
    for (const Variable& v : client_variables()) values[v.name] = v.initial;
    for (auto& stack : stacks_) stack = {identity()};
}

void Model::carry_out(const Call& call) {
    if (inside && call.place != Place::Anywhere && call.place != Place::Client)
        return fail(GL_INVALID_OPERATION);
    call.apply(*this);
}

void Model::perform(const Call& call) {
    const bool is_listed = call.place == Place::Anywhere || call.place == Place::Outside;
    if (open_ != 0 && is_listed) {
        open_calls_.push_back(call);
        if (open_mode_ == GL_COMPILE) return;
    }
    carry_out(call);
}

void Model::set(GLenum name, Row value, bool valid, GLenum otherwise) {
    if (!valid) return fail(otherwise);
    values[name] = std::move(value);
}

void Model::push_attributes(GLbitfield mask) {
    if (attributes_.size() >= stack_depth) return fail(GL_STACK_OVERFLOW);
    Saved saved{mask, {}};
    for (const Variable& v : variables())
        if (v.groups & mask) saved.values[v.name] = values[v.name];
    attributes_.push_back(std::move(saved));
}
void Model::pop_attributes() {
    if (attributes_.empty()) return fail(GL_STACK_UNDERFLOW);
    for (const auto& [name, value] : attributes_.back().values) values[name] = value;
    attributes_.pop_back();
}
void Model::push_client(GLbitfield mask) {
    if (client_.size() >= stack_depth) return fail(GL_STACK_OVERFLOW);
    Saved saved{mask, {}};
    for (const Variable& v : client_variables())
        if (v.groups & mask) saved.values[v.name] = values[v.name];
    client_.push_back(std::move(saved));
}
void Model::pop_client() {
    if (client_.empty()) return fail(GL_STACK_UNDERFLOW);
    for (const auto& [name, value] : client_.back().values) values[name] = value;
    client_.pop_back();
}

void Model::new_list(GLuint name, GLenum mode) {
    if (name == 0) return fail(GL_INVALID_VALUE);
    if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return fail(GL_INVALID_ENUM);
    if (open_ != 0) return fail(GL_INVALID_OPERATION);
    open_ = name;
    open_mode_ = mode;
    open_calls_.clear();
}
void Model::end_list() {
    if (open_ == 0) return fail(GL_INVALID_OPERATION);
    lists[open_] = std::move(open_calls_);
    open_calls_.clear();
    open_ = 0;
}
void Model::call_list(GLuint name) {
    const auto found = lists.find(name);
    if (found == lists.end() || nesting_ >= nesting_limit) return;
    const std::vector<Call> calls = found->second;
    ++nesting_;
    for (const Call& call : calls) carry_out(call);
    --nesting_;
}

std::vector<Matrix>& Model::matrices() {
    return stacks_[stack_of(GLenum(values[GL_MATRIX_MODE][0]))];
}
void Model::push_matrix() {
    auto& stack = matrices();
    if (stack.size() >= depths[&stack - stacks_]) return fail(GL_STACK_OVERFLOW);
    stack.push_back(Matrix(stack.back()));
}
void Model::pop_matrix() {
    auto& stack = matrices();
    if (stack.size() == 1) return fail(GL_STACK_UNDERFLOW);
    stack.pop_back();
}
void Model::multiply(const Matrix& by) {
    const Matrix m = matrices().back();
    Matrix& out = matrices().back();
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row) {
            out[4 * column + row] = 0;
            for (std::size_t k = 0; k < 4; ++k)
                out[4 * column + row] += m[4 * k + row] * by[4 * column + k];
            out[4 * column + row] = double(float(out[4 * column + row]));
        }
}

std::map<GLenum, Row> Model::all() const {
    std::map<GLenum, Row> out = values;
    out[GL_ATTRIB_STACK_DEPTH] = {double(attributes_.size())};
    out[GL_CLIENT_ATTRIB_STACK_DEPTH] = {double(client_.size())};
    out[GL_LIST_INDEX] = {double(open_)};
    out[GL_LIST_MODE] = {open_ != 0 ? double(open_mode_) : 0};
    constexpr GLenum tops[] = {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX};
    constexpr GLenum sizes[] = {GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH,
                                GL_TEXTURE_STACK_DEPTH};
    for (std::size_t i = 0; i < 3; ++i) {
        out[tops[i]] = stacks_[i].back();
        out[sizes[i]] = {double(stacks_[i].size())};
    }
    return out;
}

}  // namespace gw::gl::model
