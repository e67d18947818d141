// Superposition [K1, K3.3, K4a]: the pictures that are averaged, and what is different in each:
// sub-pixel position, point of the lens, moment of the exposure, point of each light, displacement
// of each glaring emitter. Haeberli, Akeley 1990. One index counts them all: picture k of N takes
// the k-th of N evenly spread values of everything, each kind in an order of its own. Does not
// draw.
#pragma once

#include "gw/state.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace gw::multipass {

/// Picture `index` of `count`.
struct Sample {
    std::size_t index = 0, count = 1;
};

/// The sample's point of the unit square, `kind` saying in which order: one in each N-th of the
/// first axis, and of the second where N is a power of two.
dvec2 spread(const Sample& sample, unsigned kind);
/// A point of the unit square as one of the unit disc, areas kept. Shirley, Chiu 1997.
dvec2 on_disc(const dvec2& square);

/// How many pictures the scene asks for by itself: the most samples of a soft light or glare; 16
/// with a lens or a moving object; else 1.
int samples_of(const scene::Scene& scene);

/// The sub-pixel position of a sample of pictures of a machine with so many sub-pixel bits; none
/// for a single one.
JitterState jitter_of(const Sample& sample, int subpixel_bits);

/// Moves `now`, a copy of `still`, to the sample's moment, and its lights to their points. One
/// sample: nothing moves.
void move_to(scene::Scene& now, const scene::Scene& still, const Sample& sample);
/// Whether anything that throws a shadow, or any light, moves from picture to picture.
bool moves(const scene::Scene& scene);

/// The view through the sample's point of the camera's lens: points at the focus distance stay
/// where they are.
scene::View view_at(const scene::View& view, const Sample& sample);

/// Where the sample moves a glaring emitter, in eye space.
dvec3 glare_displacement(const scene::Glare& glare, const Sample& sample);

}  // namespace gw::multipass
