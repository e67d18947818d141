// Views, textures and shapes that several programs draw.
#pragma once

#include <GL/gl.h>

#include <vector>

namespace gw::bench {

/// A seeded sequence of numbers 0 .. 1, the same everywhere.
class Numbers {
public:
    explicit Numbers(unsigned seed) : state_(seed) {}
    float next() {
        state_ = state_ * 1664525u + 1013904223u;
        return float(state_ >> 8) / float(1u << 24);
    }
    float between(float low, float high) { return low + (high - low) * next(); }

private:
    unsigned state_;
};

/// Projection and camera: a perspective view of the origin from `distance`.
void look_from(float distance, float height = 0);
/// Pixels as units, the origin at the bottom left.
void look_at_pixels();
void clear_all();

/// A texture of noisy bricks, or of light and shadow; bound.
GLuint make_bricks(int size, bool mipmaps);
GLuint make_lightmap(int size);
/// A soft white dot, its alpha falling to the rim; bound.
GLuint make_dot(int size);
/// All levels from `size` down by halving, each of one pattern.
std::vector<unsigned char> noise_image(int size, unsigned seed);

/// A light at the viewer's shoulder and a material with a highlight; lighting is on.
void light_scene(int lights);

/// A torus by Begin and End, with normals and texture coordinates.
void draw_torus(float inner, float outer, int sides, int rings);

/// The same as arrays.
struct Torus {
    std::vector<float> positions, normals, texcoords;
    std::vector<unsigned> indices;  ///< of triangles
};
Torus make_torus(float inner, float outer, int sides, int rings);

}  // namespace gw::bench
