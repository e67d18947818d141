// A context: OpenGL's state, the mesh that is being assembled, and the drawable that it draws to. Does
// not draw: gl/draw. Not bound to a window system: osmesa/, glx/ and egl/ make contexts and drawables.
#pragma once

#include "gl/assemble/assembler.h"
#include "gl/assemble/mesh.h"
#include "gl/drawable/call_trace.h"
#include "gl/drawable/drawable.h"
#include "gl/drawable/off_screen.h"
#include "gl/drawable/sample_counts.h"
#include "gl/state/client.h"
#include "gl/state/evaluators.h"
#include "gl/state/framebuffer_objects.h"
#include "gl/state/free_names.h"
#include "gl/state/list_names.h"
#include "gl/state/matrices.h"
#include "gl/state/selection.h"
#include "gl/state/state.h"
#include "gl/state/state_parts.h"
#include "gl/state/texture_objects.h"
#include "gw/command_list.h"
#include "gw/profile.h"

#include <GL/gl.h>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gw::gl {

/// What contexts may share: [GLX 1.4] "share list". Contexts of several threads lock it while they
/// use it.
struct Shared {
    [[nodiscard]] std::unique_lock<std::recursive_mutex> exclusive() {
        return std::unique_lock(mutex);
    }

    std::recursive_mutex mutex;
    std::shared_ptr<OffScreen> off_screen;  ///< null: no framebuffer object was bound yet
    ListNames lists;
    TextureNames textures;
    BufferNames buffers;
    RenderbufferNames renderbuffers;
};

/// An entry of the attribute stack: the groups of the state that PushAttrib copies. [GL11] 6.1.10
struct SavedAttributes {
    GLbitfield mask = 0;
    State state;                ///< its groups of `mask` count
    std::vector<bool> enables;  ///< GL_ENABLE_BIT: in the order of capabilities()
    /// GL_TEXTURE_BIT: the parameters of the bound textures
    std::array<std::array<TextureParameters, texture_target_count>, texture_unit_count> textures{};
};
inline constexpr std::size_t attribute_stack_depth = 16;

/// Occlusion queries. [GL15] 4.1.7
struct QueryObjects {
    std::map<GLuint, SampleCountRef> named;  ///< null: reserved by GenQueries, no query yet
    FreeNames free_names;
    GLuint active = 0;  ///< 0: none
};

/// The machine's state and lights that follow from GL's, kept until a part changes.
struct TranslatedState {
    StateParts stale = all_state_parts;
    std::uint64_t changes = 1;        ///< so far
    std::uint64_t runs_drawn_at = 0;  ///< `changes` at the last small runs of a list
    gw::State now;
    SharedValue<gw::State> state;   ///< `now`, shared with the commands that set it
    SharedValue<gw::State> before;  ///< programs switch between two
    LightsRef lights;
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
    Framebuffers framebuffers;
    Selection selection;
    QueryObjects queries;
    BufferRef copy_read_buffer, copy_write_buffer;  ///< GL_ARB_copy_buffer
    Assembler assembler;
    MeshCache meshes;
    TranslatedState translated;
    CallTrace calls;
    /// The framebuffer 0, to draw to and to read from; both null or none.
    Drawable *window = nullptr, *read_window = nullptr;
    /// These, or the machine of the framebuffer objects that are bound.
    Drawable *drawable = nullptr, *read_drawable = nullptr;
    bool has_been_current = false;
    GLenum error = GL_NO_ERROR;
};

/// The largest side of a viewport: that of a surface, or of a window.
inline int largest_viewport(const Profile& profile) {
    return profile.extensions.surfaces ? max_surface_size : max_window_size;
}
/// The units that a profile has.
inline std::size_t unit_count(const Profile& profile) {
    return profile.extensions.texture_units ? texture_unit_count : 1;
}
/// The unit that a name GL_TEXTURE0 .. means; none: there is no such unit.
inline std::optional<std::size_t> unit_index(const Profile& profile, GLenum name) {
    const std::size_t unit = name - GL_TEXTURE0;  // large for smaller names
    return unit < unit_count(profile) ? std::optional(unit) : std::nullopt;
}
/// The texture object that the active unit has at a target.
inline TextureObject& bound_texture(const Context& context, std::size_t target) {
    return *context.textures.bound[context.state.texture.active][target];
}

/// Keeps the first error until GetError. [GL11] 2.5
void set_error(Context& context, GLenum error);

/// Gen..: reserves n names of a kind of objects. [GL11] 3.8.8
template <class Names>
void gen_names(Context& context, Names& names, GLsizei n, GLuint* given) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (given != nullptr) reserve_names(names.named, names.free_names, n, given);
}

/// In a handler: a lack of memory becomes OUT_OF_MEMORY, any other exception one line on stderr.
void report_exception(Context& context);

/// Carries out `call`; if it throws, report_exception() and a result of 0.
template <class Call>
auto guarded(Context& context, Call call) -> decltype(call()) {
    try {
        return call();
    } catch (...) {
        report_exception(context);
        return decltype(call())();
    }
}

}  // namespace gw::gl
