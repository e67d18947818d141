// Plays a command list through another implementation of OpenGL, off the screen: the peer that the
// machine is compared with. docs/manual/differences.md, "Against Mesa". Not exact, and not meant to
// be: its planes depend on version, driver and processor. Does not write files.
#pragma once

#include "gw/machine.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gw::peer {

/// One context with planes of 8 colour, 24 depth and 8 stencil bits, of a library that is loaded at
/// run time. Mesa chooses its driver when a process makes its first context, by the environment
/// variable GALLIUM_DRIVER (`llvmpipe`, `softpipe`). Lights, generated texture coordinates and fog at
/// the vertex are computed by gw/stages/vertex.h and passed on as colours and coordinates. Transform,
/// clipping, rasterization and everything after are OpenGL's.
class Player {
public:
    /// `implementation`: "osmesa" (Mesa's off-screen library), "gl" (the libGL.so.1 that programs
    /// find, on $DISPLAY), or the path of a libOSMesa or a libGL. Throws Error for a window outside
    /// 1 .. max_window_size, for a profile of other bits, and if the library cannot be loaded, is no
    /// OpenGL, or makes no such context.
    Player(const Profile& profile, int width, int height,
           const std::string& implementation = "osmesa");
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Plays the first `count` commands. State, planes and texture slots persist, as a machine's
    /// do. `Read` and `BeginPass` have no effect. Throws Error if `validate` does (before anything
    /// is drawn), and "command 3 (Draw): ..." for what it cannot express: sizes beyond its own, both
    /// colour planes at once, surfaces with other depths than OpenGL's, and functions of later versions
    /// if it has neither them nor extensions.
    void play(const CommandList& list, std::size_t count = std::numeric_limits<std::size_t>::max());

    /// Colour, depth and stencil, as Planes has them; `accum` stays 0, as OpenGL cannot read it.
    Planes planes() const;

    /// The results of the queries that ended, in order.
    const std::vector<QueryResult>& queries() const;

    /// GL_RENDERER and GL_VERSION: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa
    /// 22.3.6".
    std::string renderer() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace gw::peer
