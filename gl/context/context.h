// A context: OpenGL's state, the mesh that is being assembled, and the drawable that it draws to.
// Not bound to a window system: osmesa/, glx/ and egl/ make contexts and drawables.
#pragma once

#include "gl/assemble/assembler.h"
#include "gl/context/call_trace.h"
#include "gl/context/drawable.h"
#include "gl/draw/mesh.h"
#include "gl/draw/submit.h"
#include "gl/evaluate/evaluators.h"
#include "gl/lists/display_list.h"
#include "gl/pixels/pixel_maps.h"
#include "gl/select/selection.h"
#include "gl/state/arrays.h"
#include "gl/state/attributes.h"
#include "gl/state/matrices.h"
#include "gl/state/state.h"
#include "gl/texture/texture_objects.h"
#include "gw/profile.h"

#include <memory>
#include <mutex>

namespace gw::gl {

/// What contexts may share: [GLX 1.4] "share list". Contexts of several threads lock it while they
/// use it.
struct Shared {
    [[nodiscard]] std::unique_lock<std::recursive_mutex> exclusive() {
        return std::unique_lock(mutex);
    }

    std::recursive_mutex mutex;
    ListNames lists;
    TextureNames textures;
};

struct Context {
    /// Throws Error if the profile is not valid.
    explicit Context(const Profile& profile, std::shared_ptr<Shared> shared = nullptr);

    Profile profile;
    std::shared_ptr<Shared> shared;
    State state;
    Matrices matrices;
    PixelMaps pixel_maps;
    Evaluators evaluators;
    std::vector<SavedAttributes> attribute_stack;
    ClientState client;
    std::vector<SavedClientState> client_stack;
    OpenList lists;
    BoundTextures textures;
    Selection selection;
    Assembler assembler;
    MeshCache meshes;
    MachineState machine_state;
    CallTrace calls;
    Drawable* drawable = nullptr;
    Drawable* read_drawable = nullptr;  ///< of ReadPixels and of copies; both null or none
    bool has_been_current = false;
    GLenum error = GL_NO_ERROR;
};

/// Keeps the first error until GetError. [GL11] 2.5
void set_error(Context& c, GLenum error);

/// Draws what was assembled and executes the drawable's commands.
void finish_drawing(Context& c, Cause cause = Cause::Flush);
/// Draws what was assembled. The drawable's frame is to be swapped next.
void finish_frame(Context& c);

/// Binds a context and drawables to draw to and read from to the calling thread; all null: none.
/// Draws what the thread's former context has left. The first time, viewport and scissor box get the
/// drawable's size.
void make_current(Context* context, Drawable* draw, Drawable* read);
inline void make_current(Context* context, Drawable* drawable) {
    make_current(context, drawable, drawable);
}

/// In a handler: a lack of memory becomes OUT_OF_MEMORY, any other exception one line on stderr.
void report_exception(Context& c);

/// Carries out `call`; if it throws, report_exception() and a result of 0.
template <class Call>
auto guarded(Context& c, Call call) -> decltype(call()) {
    try {
        return call();
    } catch (...) {
        report_exception(c);
        return decltype(call())();
    }
}

}  // namespace gw::gl
