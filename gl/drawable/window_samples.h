// The samples of a drawable. Its machine draws to a surface with samples in place of the window.
// Whatever needs the window's planes gets the means of colours, and the depth and stencil value of the
// first sample, before. GLX_ARB_multisample; [GL 1.5] 3.2.1; [R17.6]
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <optional>

namespace gw::gl {

/// The samples of a pixel that windows are offered with, beside none; 0 on a profile without them. Of
/// 8, two lie on sides of the pixel ([R17.2]): what fills a window would leave its lowest row out.
int offered_window_samples(const Profile& profile);

/// The samples that so many pixels can have of those that are wanted: 0, 2, 4 or 8.
int fitting_samples(int width, int height, int wanted);

class WindowSamples {
public:
    /// The surface with samples. The numbers above it are free for others.
    static constexpr std::uint32_t surface = 1;

    WindowSamples(int width, int height, int count)
        : width_(width), height_(height), count_(count) {}

    int count() const { return count_; }

    /// Adds what a command needs before it. `now` is the state that it finds.
    void prepare(const Command& command, const gw::State& now, CommandList& out);
    /// Brings planes of the window up to what was drawn, and uses the window.
    void resolve(PlaneMask planes, const gw::State& now, CommandList& out);
    /// The same for a read of one plane of the read buffer.
    void resolve_read(Plane plane, const gw::State& now, CommandList& out);
    /// After SwapBuffers. Returns whether the samples are the back buffer's still.
    bool follow_swap();
    /// After an error, what the machine has is unknown.
    void forget();

    /// The commands that make the samples of a new machine, whose window has the resolved planes.
    CommandList remade(const gw::State& now) const;

private:
    void use(std::uint32_t number, CommandList& out);
    void make(CommandList& out);
    void draw(const gw::State& now, CommandList& out);
    void load_colors(const gw::State& now, CommandList& out);
    MakeSurface own_surface() const;
    gw::Blit whole(std::uint32_t from, PlaneMask planes) const;

    int width_, height_, count_;
    bool is_made_ = false;
    std::optional<std::uint32_t> in_use_ = 0;  ///< none: unknown
    /// The buffer whose colours the samples are; none: they are to be loaded.
    std::optional<DrawBuffer> buffer_;
    PlaneMask unresolved_ = 0;
};

}  // namespace gw::gl
