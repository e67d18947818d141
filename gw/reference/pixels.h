// Commands on pixels: clear, spans and rectangles from the host, accumulation, copies, reads, swap.
// docs/manual/pixels.md. Makes fragments only of spans and of rectangles of colours.
#pragma once

#include "gw/command_list.h"
#include "gw/machine.h"
#include "gw/reference/fragment.h"
#include "gw/stages/pixels/blit.h"
#include "gw/stages/texels.h"

namespace gw::reference {

/// `target` has the planes and counters.
void run(const Clear& command, const Resolved& state, const FragmentTarget& target,
         const Profile& profile);
void run(const WriteSpans& command, const Resolved& state, const FragmentTarget& target);
void run(const WritePixels& command, const Resolved& state, const FragmentTarget& target,
         const Profile& profile);
void run(const Accumulate& command, const Resolved& state, const FragmentTarget& target,
         const Profile& profile);
void run(const Copy& command, const Resolved& state, const FragmentTarget& target,
         const Profile& profile);
/// Counts the pixels of a command's source.
void count_source(const DrawPixels& command, const FragmentTarget& target, const Profile& profile);
/// `texels` null: texturing is off.
void run(const DrawPixels& command, const Resolved& state, const FragmentTarget& target,
         const Profile& profile, const BoundTexels& texels);
void run(const SwapBuffers& command, const FragmentTarget& target);
Readback run(const Read& command, const Resolved& state, const FragmentTarget& target,
             const Profile& profile);

/// Copies from a surface to the one in use; `to` says which planes that has.
void run(const Blit& command, const BlitSource& from, const Surface& to, const Resolved& state,
         const FragmentTarget& target, const Profile& profile);

/// The texels of a slot, from a rectangle of the colour or depth plane.
Texels copied_texels(const CopyTexture& command, const Resolved& state,
                     const FragmentTarget& target, const Profile& profile);

}  // namespace gw::reference
