// The steps that random programs are made of. A step draws its numbers from a generator of its own,
// so it is the same call by call on every implementation, and a program can leave it out.
#pragma once

#include "tests/gl/peer/library.h"
#include "tests/gl/peer/random.h"
#include "tests/gl/peer/results.h"

#include <span>

namespace gw::gl_peer {

struct StepKind {
    const char* name;
    void (*play)(const Gl&, Random&, Results&);
};

// Steps that set state, by chapter of the specification.
std::span<const StepKind> transform_steps();
std::span<const StepKind> rasterization_steps();
std::span<const StepKind> size_steps();
std::span<const StepKind> lighting_steps();
std::span<const StepKind> texture_steps();
std::span<const StepKind> unit_steps();
std::span<const StepKind> fragment_steps();
std::span<const StepKind> pixel_steps();

// Steps that draw and give results.
void draw_shape(const Gl& gl, Random& random, Results& out);
void draw_inner_shape(const Gl& gl, Random& random, Results& out);
void draw_textured_shape(const Gl& gl, Random& random, Results& out);
void draw_lit_shape(const Gl& gl, Random& random, Results& out);
void draw_rectangle(const Gl& gl, Random& random, Results& out);
void draw_copy(const Gl& gl, Random& random, Results& out);
void draw_surface(const Gl& gl, Random& random, Results& out);
void accumulate(const Gl& gl, Random& random, Results& out);
void feed_back(const Gl& gl, Random& random, Results& out);
void select(const Gl& gl, Random& random, Results& out);
void copy_to_texture(const Gl& gl, Random& random, Results& out);
void read_rectangle(const Gl& gl, Random& random, Results& out);
void read_texture(const Gl& gl, Random& random, Results& out);
void ask(const Gl& gl, Random& random, Results& out);

/// Mesa draws with the texture of one dimension if that of two, which comes first, has no image.
void use_one_texture(const Gl& gl);
/// Adds the planes of the window, and the error.
void look(const Gl& gl, Results& out);
/// A colour of whole 255ths.
std::array<GLfloat, 4> some_color(Random& random);
/// One to three shapes, without looking at the result.
void emit_shapes(const Gl& gl, Random& random, bool may_be_uneven);

}  // namespace gw::gl_peer
