// A drawable: a machine of its size, and the frame that is being collected for it. A frame is a
// command list; flush() executes it. Window systems derive from it to show what was drawn.
#pragma once

#include "gw/command_list.h"
#include "gw/machine.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace gw::gl {

/// Whether a drawable has a front buffer only, front and back, or a back buffer only (a pbuffer of
/// EGL), which is then the front plane.
enum class Buffers : std::uint8_t { Single, Double, Back };

class Drawable {
public:
    /// Throws Error for a size outside 1 .. max_window_size.
    Drawable(const Profile& profile, int width, int height, std::string name = "main",
             Buffers buffers = Buffers::Single);
    virtual ~Drawable();
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    bool is_double_buffered() const { return buffers_ != Buffers::Single; }
    /// Whether its machine has a plane for each buffer; else both are the one plane.
    bool has_back_plane() const {
        return buffers_ == Buffers::Double && profile().color_planes == 2;
    }
    const Profile& profile() const { return machine_->profile(); }

    /// Contexts of several threads may draw to one drawable. Every function locks it; a caller that
    /// needs several calls in a row, as a state and its draw, holds this lock meanwhile.
    [[nodiscard]] std::unique_lock<std::recursive_mutex> exclusive() {
        return std::unique_lock(mutex_);
    }

    /// Adds a command to the frame; a state only if it differs from the frame's last one.
    void add(Command command);
    void set_state(const gw::State& state);

    /// Executes the frame. What follows belongs to it too, until begin_frame().
    void flush();
    /// Exchanges front and back buffer; the frame is then whole, and shown.
    void swap();
    /// The commands that follow are those of a new frame, a pass "frame 12".
    void begin_frame();
    /// Shows the frame: to the window, or in the caller's memory.
    virtual void present() {}
    /// Executes the frame and reads a rectangle inside the drawable.
    Readback read(Plane plane, const Rect& rect);
    /// The colours of a buffer, whatever the read buffer is.
    Readback read_colors(gw::ReadBuffer buffer, const Rect& rect);
    /// The same of at most 8 bits a channel, into the caller's memory: R in the lowest byte, then G,
    /// B and A.
    void read_packed(gw::ReadBuffer buffer, const Rect& rect, std::span<std::uint32_t> pixels);
    void read_packed(const Rect& rect, std::span<std::uint32_t> pixels);

    /// New planes of another size, cleared to 0. What was not executed yet is left out.
    void resize(int width, int height);

    /// How often the frame was executed because pixels were read or memory ran out, not because
    /// the program had finished it.
    std::uint64_t barriers() const { return barriers_; }

protected:
    /// Whether the shown buffer may differ from the last time: it was drawn to, or exchanged.
    bool take_front_changed() { return std::exchange(front_changed_, false); }

private:
    void execute_read(Plane plane, const Rect& rect, bool packed);
    /// Reads are of this buffer from here on.
    void select(gw::ReadBuffer buffer);

    std::recursive_mutex mutex_;
    std::string name_;  ///< in recordings
    int width_, height_;
    Buffers buffers_;
    std::unique_ptr<Machine> machine_;
    CommandList frame_;
    std::uint64_t frame_vertices_ = 0;
    std::uint64_t frames_ = 0;
    bool frame_begins_ = true;
    bool front_changed_ = false;
    std::unique_ptr<gw::State> last_state_;
    std::uint64_t barriers_ = 0;
};

}  // namespace gw::gl
