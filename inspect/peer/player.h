// Plays a command list through OpenGL, on an off-screen context of Mesa (OSMesa): the peer that the
// machine is compared with. docs/manual/differences.md, "Against Mesa". Not exact, and not meant to
// be: its planes depend on Mesa's version, driver and processor. Does not write files.
#pragma once

#include "gw/machine.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>

namespace gw::peer {

/// One OSMesa context with planes of 8 colour, 24 depth and 8 stencil bits. Mesa chooses its driver
/// when a process makes its first context, by the environment variable GALLIUM_DRIVER (`llvmpipe`,
/// `softpipe`). Lights, generated texture coordinates and fog at the vertex are computed by
/// gw/stages/vertex.h and passed on as colours and coordinates. Transform, clipping, rasterization
/// and everything after are OpenGL's.
class Player {
public:
    /// Throws Error for a window outside 1 .. max_window_size, for a profile of other bits, and if
    /// OSMesa makes no context.
    Player(const Profile& profile, int width, int height);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Plays the first `count` commands. State, planes and texture slots persist, as a machine's
    /// do. `Read` and `BeginPass` have no effect. Throws Error if `validate` does (before anything
    /// is drawn), and "command 3 (Draw): ..." for state that OpenGL cannot express:
    /// lighting.two_side, and sizes beyond Mesa's.
    void play(const CommandList& list, std::size_t count = std::numeric_limits<std::size_t>::max());

    /// Colour, depth and stencil, as Planes has them; `accum` stays 0, as OpenGL cannot read it.
    Planes planes() const;

    /// GL_RENDERER and GL_VERSION: "llvmpipe (LLVM 15.0.6, 256 bits), 3.1 Mesa 22.3.6".
    std::string renderer() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace gw::peer
