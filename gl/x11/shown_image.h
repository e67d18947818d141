// Shows a drawable's colours in a window or pixmap. The image has the server's pixel format and, if
// possible, memory that is shared with it (MIT-SHM).
#pragma once

#include "gl/x11/own_connection.h"
#include "gl/x11/quiet_errors.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gw::gl::x11 {

/// A colour 0 .. 2^color_bits - 1 as a pixel of a visual: each channel to the nearest value.
class PixelFormat {
public:
    PixelFormat(const XVisualInfo& visual, int color_bits);
    std::uint32_t pixel(unsigned r, unsigned g, unsigned b, unsigned a) const {
        return channels_[0][r] | channels_[1][g] | channels_[2][b] | channels_[3][a];
    }
    /// Whether the bytes of a pixel are B, G, R and 0, from the lowest.
    bool is_bgr() const { return is_bgr_; }

private:
    std::array<std::vector<std::uint32_t>, 4> channels_;
    bool is_bgr_ = false;
};

class ShownImage {
public:
    /// `height`: of the window or pixmap, whose origin is at the top left.
    ShownImage(Display* display, const XVisualInfo& visual, XID target, int height);
    ~ShownImage();
    ShownImage(const ShownImage&) = delete;
    ShownImage& operator=(const ShownImage&) = delete;

    int target_height() const { return target_height_; }
    void set_target_height(int height) { target_height_ = height; }

    /// Before the display is closed: nothing is shown any more. The server frees what it holds.
    void lose_display();
    bool has_lost_display() const { return lost_display_; }

    /// A window that is no longer there shows nothing, without an error.
    void show(gl::Drawable& drawable, gw::ReadBuffer buffer = gw::ReadBuffer::Front);
    /// Colours of 8 bits, R lowest, bottom row first.
    void show_packed(std::span<const std::uint32_t> pixels, int width, int height);
    /// Makes the image so large. Precondition: nobody is filling it.
    void fit(int width, int height);
    /// An image's words, to be filled in this layout, and put().
    struct Words {
        std::span<std::uint32_t> pixels;
        gw::ReadLayout layout;
    };
    /// None: the image has another size, its memory is not shared, or the server's pixels differ.
    std::optional<Words> shared_words(int width, int height, int color_bits);
    /// Shows the image in a target of this height. Returns whether it is shown. Uses nothing of the
    /// program's connection. Another thread may change target_height() meanwhile.
    bool put(OwnConnection& own, int height) const;
    /// Waits until the server has read what show() put.
    void wait() { put_.wait(); }

private:
    struct Memory;
    bool has_size(int width, int height) const;
    void put();
    /// None: the server's pixels differ.
    std::optional<Words> words(int color_bits);
    const PixelFormat& format(int color_bits);
    void fill(gl::Drawable& drawable, gw::ReadBuffer buffer);

    Display* const display_;
    const XVisualInfo visual_;
    const XID target_;
    int target_height_;
    std::atomic<bool> lost_display_ = false;
    GC gc_ = nullptr;
    QuietRequests put_;
    std::unique_ptr<PixelFormat> format_;
    std::unique_ptr<Memory> memory_;
    std::vector<std::uint32_t> packed_;  ///< what was read of the drawable
};

}  // namespace gw::gl::x11
