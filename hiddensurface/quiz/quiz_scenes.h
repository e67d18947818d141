// The random scenes of a quiz. Does not ask anything.
#pragma once

#include "scene/scene.h"

#include <random>

namespace gw::hiddensurface {

/// Random numbers that are the same everywhere.
class QuizRandom {
public:
    QuizRandom(std::uint32_t seed, std::uint32_t number);
    double operator()(double low, double high);
    int whole(int low, int high);  ///< both included

private:
    std::mt19937 engine_;
};

/// `count` tilted polygons of `corners` corners (3 or 4) over each other; 4: plane rectangles.
/// A polygon of `size` 1 has about a quarter of the window's size.
scene::Scene tilted_polygons(QuizRandom& random, int count, int corners, double size = 1);
/// `count` rectangles that face the eye, in parallel projection; `distances` are those from the eye.
scene::Scene facing_rectangles(QuizRandom& random, int count, std::vector<int>& distances);
/// A closed solid; its corners and the eye have whole coordinates.
scene::Scene whole_number_solid(QuizRandom& random);

/// The number of colours; polygons take them in turn.
inline constexpr int quiz_colors = 8;

}  // namespace gw::hiddensurface
