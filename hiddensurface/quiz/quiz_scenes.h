// The random scenes of a quiz. Does not ask anything.
#pragma once

#include "scene/scene.h"

#include <random>

namespace gw::hiddensurface {

/// The same numbers everywhere.
class QuizRandom {
public:
    QuizRandom(std::uint32_t seed, std::uint32_t number);
    double operator()(double low, double high);
    int whole(int low, int high);  ///< both included

private:
    std::mt19937 engine_;
};

/// `count` tilted polygons of `corners` corners (3 or 4) over each other; 4: plane
/// rectangles. `size`: against that of the window, 1 for about a quarter of it.
scene::Scene tilted_polygons(QuizRandom& random, int count, int corners, double size = 1);
/// `count` rectangles that face the eye, seen in parallel; `distances`: of each from the eye.
scene::Scene facing_rectangles(QuizRandom& random, int count, std::vector<int>& distances);
/// A closed solid with corners at whole coordinates; the eye too.
scene::Scene whole_number_solid(QuizRandom& random);

/// Colours in turn: objects of one polygon each, materials of their own.
inline constexpr int quiz_colors = 8;

}  // namespace gw::hiddensurface
