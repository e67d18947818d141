// The robot's picture, and its objects: framebuffers, textures, lists, the skin's buffers.
#pragma once

#include "tests/gl/programs/robot/functions.h"
#include "tests/gl/programs/robot/matrices.h"

#include <array>
#include <string>
#include <vector>

namespace robot {

struct Options {
    int shadow = 4096, sky = 800, width = 320, height = 240, samples = 4;
};

struct Scene {
    Options options;
    bool zero_to_one = false;
    GLuint framebuffer = 0, resolved = 0, shadow_framebuffer = 0, shadow_texture = 0;
    GLuint floor_texture = 0, sky_texture = 0;
    GLuint lists = 0;
    std::array<GLuint, 4> skin{};
    int skin_indices = 0;
    Matrix projection{}, view{};
    float moved = 0;  ///< of the bodies, along x
};
enum List : GLuint { floor_list, sphere_list, sky_list, haze_list, list_count };

/// Makes a context of a door current and the objects; ends the program with a message if it cannot.
void open_scene(Scene& scene, const std::string& door);
void draw_skin(const Scene& scene);

void draw_picture(Scene& scene);
/// Each body in a colour that is its number.
void draw_numbers(const Scene& scene);
/// R, G, B of all pixels, and their depths, by way of the framebuffer without samples.
std::vector<GLubyte> read_colors(const Scene& scene);
std::vector<GLfloat> read_depths(const Scene& scene);

}  // namespace robot
