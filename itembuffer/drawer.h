// Eq. 5 for one view after the other [K4]: what no view decides is made once, hierarchies and
// shadow maps of reflected hits too. Does not choose views.
#pragma once

#include "itembuffer/render.h"

#include <memory>

namespace gw::itembuffer {

/// What `render` draws with; the machine must outlive it.
std::unique_ptr<multipass::Drawer> make_drawer(Machine& machine, const scene::Scene& scene,
                                               const multipass::Options& passes,
                                               const Options& options = {});

}  // namespace gw::itembuffer
