// What the specification says that calls do to GL's state: written from its text and tables, and
// nothing of gl/. A state variable is a row of numbers by its name for GetDoublev.
#pragma once

#include <GL/gl.h>

#include <functional>
#include <map>
#include <vector>

namespace gw::gl::model {

using Row = std::vector<double>;

/// Where a function may stand. [GL11] 2.6.3, 5.4
enum class Place { Anywhere, Outside, Now, Client };

struct Model;
struct Call {
    Place place = Place::Outside;
    std::function<void(Model&)> apply;
};

using Matrix = std::vector<double>;  ///< 16 numbers, column by column

struct Model {
    Model();

    void fail(GLenum code) {
        if (error == GL_NO_ERROR) error = code;
    }
    /// Carries a call out, keeps it in the open list, or both.
    void perform(const Call& call);
    /// A variable gets its value if `valid`; else the error.
    void set(GLenum name, Row value, bool valid = true, GLenum otherwise = GL_INVALID_ENUM);

    void push_attributes(GLbitfield mask);
    void pop_attributes();
    void push_client(GLbitfield mask);
    void pop_client();
    void new_list(GLuint name, GLenum mode);
    void end_list();
    void call_list(GLuint name);
    void push_matrix();
    void pop_matrix();
    std::vector<Matrix>& matrices();
    void multiply(const Matrix& by);

    /// The variables with the depths of the stacks and the matrices.
    std::map<GLenum, Row> all() const;

    std::map<GLenum, Row> values;
    /// The name of the list that is compiled; 0: none.
    GLuint open() const { return open_; }

    GLenum error = GL_NO_ERROR;
    bool inside = false;
    std::map<GLuint, std::vector<Call>> lists;

private:
    struct Saved {
        GLbitfield mask;
        std::map<GLenum, Row> values;
    };
    void carry_out(const Call& call);

    std::vector<Saved> attributes_, client_;
    std::vector<Matrix> stacks_[3];
    GLuint open_ = 0;
    GLenum open_mode_ = 0;
    std::vector<Call> open_calls_;
    int nesting_ = 0;
};

/// The switches of Enable and Disable.
bool is_capability(GLenum name);
Matrix identity();

}  // namespace gw::gl::model
