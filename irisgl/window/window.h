// A window of IRIS GL: a machine of its size, its state, further planes. Its picture is shown through
// the colour map, with overlay and pop-up planes on top.
#pragma once

#include "gl/context/context.h"
#include "gl/drawable/drawable.h"
#include "irisgl/state/state.h"
#include "irisgl/window/host_window.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gw::irisgl {

/// Overlay, underlay, pop-up: planes of 2 to 8 bits, drawn like the others.
class AsidePlanes;

/// The menus of a window, 2 bits: 0 shows what is below. Bottom row first.
struct PopupPlanes {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
    bool is_used = false;
    void fit(int w, int h);
    void clear();
};

class Window : public gl::Drawable {
public:
    /// `host` is null without a screen.
    Window(long id, int width, int height, std::unique_ptr<HostWindow> host);
    ~Window() override;

    long id() const { return id_; }
    HostWindow* host() const { return host_.get(); }
    /// The lower left pixel on the screen of 1280 x 1024.
    int x = 0, y = 0;
    int screen_x = 0, screen_y = 0, old_width = 0, old_height = 0;  ///< fullscrn

    gl::Context context;
    State state;
    PopupPlanes popup;

    /// The number of the program's call that begins, from 0 in each frame.
    std::uint32_t count_call();

    void make_current();
    /// Calls of OpenGL draw to the planes of the draw mode from here on.
    void select_planes();
    /// Gives the planes another size. Their contents are lost.
    void take_size(int w, int h);
    /// Shows what was drawn to the front buffer, and the map.
    void show_front();
    /// Shows the same pixels, if their colours are others. That is a frame too.
    void show_map();
    /// Shows the picture again: another map, another menu.
    void show_again();

    void present() override;
    const Planes& shown() override;
    gl::ShownIndices shown_indices() const override;

    int aside_bits(int which) const { return aside_bits_[std::size_t(which)]; }
    void set_aside_bits(int which, long bits);
    /// The bits of an index that is shown.
    int aside_index_bits(std::size_t which) const { return std::max(aside_bits_[which], 2); }

private:
    void compose(std::span<std::uint32_t> pixels);

    const long id_;
    std::unique_ptr<HostWindow> host_;
    std::array<std::unique_ptr<AsidePlanes>, 3> aside_;  ///< overlay, underlay, pop-up
    std::array<int, 3> aside_bits_{2, 0, 2};
    std::uint64_t shown_map_ = 0;
    std::uint64_t call_frame_ = 0;
    std::uint32_t next_call_ = 0;  ///< of call_frame_
    Planes shown_;
    std::vector<std::uint32_t> pixels_;
};

/// The pixel of an index in planes of `bits` a channel: its low bits in R, the others in G.
struct IndexColor {
    int bits;
    unsigned low(unsigned index) const { return index & ((1u << bits) - 1); }
    unsigned high(unsigned index) const { return bits >= index_bits ? 0 : index >> bits; }
    unsigned index(unsigned r, unsigned g) const {
        return (r | (bits >= index_bits ? 0 : g << bits)) & index_mask;
    }
};

}  // namespace gw::irisgl
