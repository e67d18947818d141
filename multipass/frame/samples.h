// Superposition [K1, K3.3, K4a]: the values that differ between the averaged pictures. These are
// the sub-pixel position, the point of the lens, the moment of the exposure, the point of each
// light and the displacement of each glaring emitter (Haeberli, Akeley 1990). Picture k of N takes
// the k-th of N evenly spread values of each kind; every kind has an order of its own. Does not
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

/// The sample's point of the unit square; `kind` selects the order. The points are stratified along
/// the first axis, and along the second if N is a power of two.
dvec2 spread(const Sample& sample, unsigned kind);
/// Maps the unit square to the unit disc; areas keep their ratios. Shirley, Chiu 1997.
dvec2 on_disc(const dvec2& square);

/// The number of pictures that the scene needs: the most samples of a soft light or glare. It is 16
/// with a lens or a moving object, else 1.
int samples_of(const scene::Scene& scene);

/// The sub-pixel position of a sample on a machine with `subpixel_bits`; none for a single picture.
JitterState jitter_of(const Sample& sample, int subpixel_bits);

/// Moves `now`, a copy of `still`, to the sample's moment, and its lights to their points. One
/// sample: nothing moves.
void move_to(scene::Scene& now, const scene::Scene& still, const Sample& sample);
/// Whether any object or light moves from picture to picture.
bool moves(const scene::Scene& scene);

/// The view through the sample's point of the camera's lens. Points at the focus distance keep
/// their place.
scene::View view_at(const scene::View& view, const Sample& sample);

/// The displacement of a glaring emitter in this sample, in eye space.
dvec3 glare_displacement(const scene::Glare& glare, const Sample& sample);

}  // namespace gw::multipass
