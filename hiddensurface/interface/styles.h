// The lecture's line styles of one object [L1 a, b, c] as command lists: wireframe, depth cueing,
// hidden lines removed. The shaded ones [L1 d, e, f] are passes: multipass/ draws them.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

namespace gw::hiddensurface {

/// [L1 a] Every polygon's sides, white on black; no depth test.
CommandList wireframe(const scene::Scene& scene, const scene::View& view);

/// [L1 b] The same with lines that grow darker with distance: linear black fog from the scene's
/// nearest to its farthest point.
CommandList depth_cueing(const scene::Scene& scene, const scene::View& view);

/// [L1 c] Z of the faces first, then the sides under LEqual. Faces must lie slightly behind their
/// own sides. Polygon offset does this if the profile has it; else the depth range, with faces in its
/// upper 1023/1024 and sides in its lower. That shift is the same everywhere: on steep faces parts of
/// sides may break, and sides less than the shift behind a face show through.
CommandList hidden_lines(const scene::Scene& scene, const scene::View& view,
                         const Profile& profile);

}  // namespace gw::hiddensurface
