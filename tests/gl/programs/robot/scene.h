// The objects of the robot's picture: framebuffers, textures, lists, the skin's buffers.
#pragma once

#include "tests/gl/programs/robot/functions.h"
#include "tests/gl/programs/robot/matrices.h"

#include <array>
#include <string>

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
};
enum List : GLuint { floor_list, sphere_list, sky_list, haze_list, list_count };

void make_framebuffers(Scene& scene);
void make_textures(Scene& scene);
void make_lists(Scene& scene);
void make_skin(Scene& scene);
void draw_skin(const Scene& scene);

}  // namespace robot
