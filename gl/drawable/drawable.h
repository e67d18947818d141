// A drawable: a machine of its size, which executes the frames that are collected for it. Window
// systems derive from it to show what was drawn. A window that swaps frame after frame has each
// executed and shown by a thread, while the program makes the next. Whatever needs the machine waits
// for it.
#pragma once

#include "gl/drawable/background.h"
#include "gl/drawable/frame.h"
#include "gl/drawable/frame_log.h"
#include "gl/drawable/sample_counts.h"
#include "gl/drawable/settings.h"
#include "gl/drawable/shown_indices.h"
#include "gl/drawable/window_samples.h"
#include "gw/command_list.h"
#include "gw/machine.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gw::gl {

/// Whether a drawable has a front buffer only, front and back, or a back buffer only. That of a
/// pbuffer of EGL is the front plane.
enum class Buffers : std::uint8_t { Single, Double, Back };

class Drawable {
public:
    /// `samples` of a pixel: 0, or 2, 4, 8 on a profile with surfaces and multisample; fewer, with a
    /// warning, if so many pixels cannot have them. Throws Error for a size outside 1 .. max_window_size.
    Drawable(const Profile& profile, int width, int height, std::string name = "main",
             Buffers buffers = Buffers::Single, int samples = 0);
    virtual ~Drawable();
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    bool is_double_buffered() const { return buffers_ != Buffers::Single; }
    /// The samples of a pixel; 0: none.
    int samples() const { return samples_ ? samples_->count() : 0; }
    /// Whether its machine has a plane for each buffer; else both are the one plane.
    bool has_back_plane() const {
        return buffers_ == Buffers::Double && profile().color_planes == 2;
    }
    const Profile& profile() const { return machine_->profile(); }
    const std::string& name() const { return name_; }
    /// The number of the frame that is being drawn, from 0.
    std::uint64_t frame() const { return frame_.number(); }
    const Planes& planes();
    /// As they are shown, if something lies between planes and screen: of IRIS GL, a colour map.
    virtual const Planes& shown() { return planes(); }
    /// The state after the commands so far; null: none has set one.
    const gw::State* state() const { return frame_.state(); }

    /// Contexts of several threads may draw to one drawable. Every function locks it; a caller that
    /// needs several calls in a row, as a state and its draw, holds this lock meanwhile.
    [[nodiscard]] std::unique_lock<std::recursive_mutex> exclusive() {
        return std::unique_lock(mutex_);
    }

    /// Adds a command to the frame, and the calls that made it; a state only if it differs from the
    /// frame's last one.
    void add(Command command, std::span<const CallRun> calls = {});
    void set_state(const SharedValue<gw::State>& state, std::span<const CallRun> calls = {});

    /// Adds to the memory that the frame's commands keep: textures made for it.
    void hold(std::size_t bytes);

    /// From here on, the samples of commands are counted; until here.
    void begin_count(SampleCountRef count);
    void end_count(const SampleCountRef& count);
    /// Whether commands that follow are left out of all counts: those that only move planes are no
    /// drawing. Returns what was so before.
    bool pause_counts(bool pause);
    /// Executes the commands if counts wait for them, except those that go on.
    void finish_counts();

    /// Executes the commands so far. What follows belongs to the same frame.
    void flush(Cause cause);
    /// Flush and Finish: executes the commands, and shows what was drawn to the front buffer. That
    /// ends the frame, off screen too.
    /// Returns whether it ended.
    bool finish(Cause cause = Cause::Flush);
    /// Shows the back buffer as the front one; the frame is then whole.
    void swap();
    /// The user's, unless it is set here.
    void set_swap_method(SwapMethod method) { swap_method_ = method; }
    /// Shows the frame: to the window, or in the caller's memory.
    virtual void present() {}
    /// Waits until it is there.
    virtual void wait_until_shown() {}
    /// Executes the frame and reads a rectangle inside the drawable.
    Readback read(Plane plane, const Rect& rect, Cause cause);
    /// Reads depths or stencil values in the same way, into the caller's memory.
    void read_values(Plane plane, const Rect& rect, Cause cause, std::span<std::uint32_t> values);
    /// The colours of a buffer, whatever the read buffer is.
    Readback read_colors(gw::ReadBuffer buffer, const Rect& rect, Cause cause);
    /// The same with at most 8 bits a channel, into the caller's memory: R in the lowest byte, then
    /// G, B and A, if `layout` does not differ.
    void read_packed(gw::ReadBuffer buffer, const Rect& rect, Cause cause,
                     std::span<std::uint32_t> pixels, ReadLayout layout = {});
    void read_packed(const Rect& rect, Cause cause, std::span<std::uint32_t> pixels,
                     ReadLayout layout = {});
    /// How its window shows the colours now, if they are indices.
    virtual ShownIndices shown_indices() const { return {}; }
    /// If somebody listens: ends a frame in which nothing was drawn, if it is shown in other colours
    /// than the one before.
    void end_recolored_frame();
    /// Whether nobody sees it: its program may never swap.
    virtual bool is_off_screen() const { return false; }

    /// Makes the window's planes those of its samples, for no frame. Precondition: a state is set, and
    /// the frame has no commands. Returns what makes the samples of a new machine that has these planes.
    CommandList resolve_samples();

    /// New planes of another size, cleared to 0. Drops commands that were not executed.
    void resize(int width, int height);

protected:
    /// Shows frames from another thread.
    struct FrameTarget {
        std::span<std::uint32_t> pixels;  ///< the frame's colours, in `layout`
        ReadLayout layout;
        /// Called when they are there. Returns whether everybody sees them.
        std::function<bool()> show;
    };
    /// Where the frame that ends goes; none: present() shows it. Called while nothing is executed.
    virtual std::optional<FrameTarget> frame_target() { return std::nullopt; }
    /// Called before the target of frame_target() goes away.
    void end_background() noexcept;
    /// Executes a list that belongs to no frame; it changes nothing.
    const std::map<std::uint32_t, Readback>& execute_reads(const CommandList& list);
    /// Waits until all swapped frames are executed and, if possible, shown. Rethrows their errors.
    void settle();

    /// Whether the shown buffer may differ from the last time: it was drawn to, or exchanged.
    bool take_front_changed() {
        const auto lock = exclusive();
        return std::exchange(front_changed_, false);
    }

private:
    /// After a swap by exchange, copies the picture that is shown to the back buffer, unless `command`
    /// clears it or does not touch it.
    void bring_back_up_to_date(const Command& command);
    void copy_to_back();
    void make_samples();
    void end_segment();
    /// The frame's next commands read the window.
    void read_window(Plane plane);
    void execute_read(Plane plane, const Rect& rect, Cause cause, bool packed);
    /// Reads are of this buffer from here on.
    void select(gw::ReadBuffer buffer);
    /// Returns whether the frame ends, off screen or because the front buffer was drawn to.
    bool finish_execution(Cause cause);
    void flush_swapped();
    bool runs_behind() const;
    /// Executes the frame and shows it while the caller goes on. Returns whether it does.
    bool swap_behind();
    void start_behind(FrameTarget target);
    /// The commands that follow are those of a new frame, a pass "frame 12".
    void end_frame();

    std::recursive_mutex mutex_;
    std::string name_;  ///< in recordings
    int width_, height_;
    Buffers buffers_;
    int wanted_samples_;
    std::optional<WindowSamples> samples_;  ///< none: drawing goes to the window
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<Background> background_;  ///< null: no frame was executed behind
    CollectedCommands executed_;              ///< by it
    Frame frame_;
    /// As the last frame ended; none: nobody listened.
    std::optional<ShownIndices> logged_indices_;
    SampleCounts counts_;
    bool are_counts_paused_ = false;
    std::vector<QueryResult> counted_behind_;  ///< by background_
    bool front_changed_ = false;
    bool front_drawn_ = false;  ///< in this frame
    SwapMethod swap_method_ = settings().swap;
    bool is_back_old_ = false;     ///< it is to be a copy of the front buffer, and is not yet
    bool is_left_unseen_ = false;  ///< by the last work of background_
};

/// Nothing that is added to a drawable is counted while this lives.
class PausedCounts {
public:
    explicit PausedCounts(Drawable& drawable)
        : drawable_(drawable), before_(drawable.pause_counts(true)) {}
    ~PausedCounts() { drawable_.pause_counts(before_); }
    PausedCounts(const PausedCounts&) = delete;
    PausedCounts& operator=(const PausedCounts&) = delete;

private:
    Drawable& drawable_;
    bool before_;
};

}  // namespace gw::gl
