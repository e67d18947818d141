#include "gl/drawable/drawable.h"

#include "gl/drawable/settings.h"
#include "gw/base/parallel.h"

#include <malloc.h>
#include <cstdio>
#include <system_error>
#include <utility>

namespace gw::gl {

namespace {

/// A program that shows more frames is an animation: the next follows soon.
constexpr std::uint64_t frames_before_animation = 16;

/// The memory that a frame frees is for the next one. The C library would give large blocks back to the
/// system, and take each of their pages anew. These are its own values for a program that once freed
/// 32 MB.
bool keep_freed_memory() {
#ifdef __GLIBC__
    return mallopt(M_MMAP_THRESHOLD, 32 << 20) != 0 && mallopt(M_TRIM_THRESHOLD, 64 << 20) != 0;
#else
    return false;
#endif
}

/// Never destroyed: other threads draw while the program ends.
std::unique_ptr<FrameLog>& log = *new std::unique_ptr<FrameLog>;

}  // namespace

FrameLog* frame_log() { return log.get(); }
void set_frame_log(std::unique_ptr<FrameLog> to) { log = std::move(to); }

Drawable::Drawable(const Profile& profile, int width, int height, std::string name, Buffers buffers,
                   int samples)
    : name_(std::move(name)),
      width_(width),
      height_(height),
      buffers_(buffers),
      wanted_samples_(samples),
      machine_(make_machine(profile, width, height)) {
    [[maybe_unused]] static const bool is_kept = keep_freed_memory();
    make_samples();
    if (log) log->open(*this);
}

Drawable::~Drawable() {
    end_background();
    counts_.forget_segments();
    if (log) log->close(*this);
}

void Drawable::make_samples() {
    const int count = fitting_samples(width_, height_, wanted_samples_);
    if (count != wanted_samples_)
        std::fprintf(stderr,
                     "gw: warning: %s: %d x %d pixels have %d samples, not %d; the machine has at "
                     "most %lld in all\n",
                     name_.c_str(), width_, height_, count, wanted_samples_,
                     static_cast<long long>(max_surface_samples));
    samples_ = count > 0 ? std::optional(WindowSamples(width_, height_, count)) : std::nullopt;
}

CommandList Drawable::resolve_samples() {
    if (!samples_) return {};
    CommandList list;
    samples_->resolve(surface_planes, *state(), list);
    execute_reads(list);
    return samples_->remade(*state());
}

void Drawable::resize(int width, int height) {
    const auto lock = exclusive();
    settle();
    std::unique_ptr<Machine> made = make_machine(Profile(profile()), width, height);
    if (log) log->close(*this);
    machine_ = std::move(made);
    width_ = width;
    height_ = height;
    is_back_old_ = false;
    make_samples();
    frame_.drop();
    counts_.forget_segments();
    if (log) log->open(*this);
}

const Planes& Drawable::planes() {
    const auto lock = exclusive();
    settle();
    return machine_->planes();
}

void Drawable::add(Command command, std::span<const CallRun> calls) {
    const auto lock = exclusive();
    if (log && frame_.is_new()) log->begin_frame(*this);
    if (is_back_old_) bring_back_up_to_date(command);
    if (samples_) {
        frame_.begin();
        samples_->prepare(command, frame_.state_or_initial(), frame_.list());
    }
    if (!are_counts_paused_ && !std::holds_alternative<SetState>(command))
        if (const auto query = counts_.begin_segment()) frame_.add(*query);
    frame_.add(std::move(command), calls);
    if (frame_.is_full()) flush(Cause::Full);
}

void Drawable::bring_back_up_to_date(const Command& command) {
    if (std::holds_alternative<SetState>(command)) return;
    if (const auto* clear = std::get_if<gw::Clear>(&command)) {
        if ((clear->planes & mask_of(Plane::Color)) == 0) return;
        const gw::State now = frame_.state_or_initial();
        if (now.draw_buffer == DrawBuffer::Back && !now.scissor.test &&
            now.color_mask == ColorMask{} && now.color_mask_bits == ColorMaskBits{}) {
            is_back_old_ = false;
            return;
        }
    }
    copy_to_back();
}

void Drawable::copy_to_back() {
    is_back_old_ = false;
    const gw::State kept = frame_.state_or_initial();
    gw::State copying;
    copying.draw_buffer = DrawBuffer::Back;
    copying.read_buffer = gw::ReadBuffer::Front;
    frame_.add(SetState{copying});
    frame_.add(gw::Copy{.plane = Plane::Color, .source = {0, 0, width_, height_}});
    frame_.add(SetState{kept});
}

void Drawable::hold(std::size_t bytes) {
    const auto lock = exclusive();
    frame_.hold(bytes);
}

void Drawable::begin_count(SampleCountRef count) {
    const auto lock = exclusive();
    end_segment();
    counts_.begin(std::move(count));
}

void Drawable::end_count(const SampleCountRef& count) {
    const auto lock = exclusive();
    end_segment();
    counts_.end(count);
}

bool Drawable::pause_counts(bool pause) {
    const auto lock = exclusive();
    if (pause) end_segment();
    return std::exchange(are_counts_paused_, pause);
}

void Drawable::end_segment() {
    if (const auto query = counts_.end_segment()) frame_.add(*query);
}

void Drawable::finish_counts() {
    const auto lock = exclusive();
    settle();
    if (!counts_.are_open()) return;
    end_segment();
    flush(Cause::Query);
}

void Drawable::end_frame() {
    const auto lock = exclusive();
    front_drawn_ = false;
    if (frame_.is_new()) return;
    if (log) log->end_frame(*this);
    logged_indices_ = log ? std::optional(shown_indices()) : std::nullopt;
    frame_.end();
}

void Drawable::end_recolored_frame() {
    const auto lock = exclusive();
    if (!log || !frame_.is_new() || frame_.number() == 0) return;
    const auto before = std::exchange(logged_indices_, shown_indices());
    if (!before || before == logged_indices_) return;
    log->begin_frame(*this);
    frame_.begin();
    flush(Cause::Shown);
    end_frame();
}

void Drawable::set_state(const SharedValue<gw::State>& state, std::span<const CallRun> calls) {
    const auto lock = exclusive();
    const bool to_front = has_back_plane() ? state->draw_buffer == DrawBuffer::Front ||
                                                 state->draw_buffer == DrawBuffer::FrontAndBack
                                           : !is_double_buffered();
    front_changed_ |= to_front;
    front_drawn_ |= to_front;
    if (!frame_.finds_state(state)) add(SetState{state}, calls);
}

void Drawable::settle() {
    if (!background_) return;
    try {
        background_->wait();
    } catch (...) {
        // After an error, the machine's state is not known.
        executed_.list.commands.clear();
        frame_.drop();
        if (samples_) samples_->forget();
        counts_.forget_segments();
        throw;
    }
    executed_.list.commands.clear();
    front_changed_ |= std::exchange(is_left_unseen_, false);
    counts_.add(std::exchange(counted_behind_, {}));
}

void Drawable::end_background() noexcept {
    background_ = nullptr;
    executed_.list.commands.clear();
}

bool Drawable::runs_behind() const {
    return frame_.number() >= frames_before_animation && !log && settings().threads != 1 &&
           hardware_threads() > 1 && Background::is_available();
}

bool Drawable::swap_behind() {
    const auto lock = exclusive();
    if (!runs_behind()) return false;
    settle();
    std::optional<FrameTarget> target = frame_target();
    if (!target) return false;
    try {
        if (!background_) background_ = std::make_unique<Background>();
    } catch (const std::system_error&) {
        return false;  // the system gives no thread
    }
    start_behind(std::move(*target));
    return true;
}

void Drawable::start_behind(FrameTarget target) {
    select(gw::ReadBuffer::Front);
    read_window(Plane::Color);
    frame_.add_read(Plane::Color, {0, 0, width_, height_}, true);
    machine_->read_into(0, target.pixels, target.layout);
    frame_.reuse(std::exchange(executed_, frame_.take()));
    front_changed_ = false;
    background_->start([this, show = std::move(target.show)] {
        machine_->execute(executed_.list);
        counted_behind_ = query_results(machine_->passes());
        machine_->reset_passes();
        is_left_unseen_ = !show();
    });
}

void Drawable::flush(Cause cause) {
    const auto lock = exclusive();
    settle();
    if (!frame_.has_commands()) return;
    CollectedCommands commands = frame_.take();
    auto state = frame_.take_state();
    const auto samples = samples_;
    if (samples_) samples_->forget();
    machine_->execute(commands.list);
    frame_.restore_state(std::move(state));
    samples_ = samples;
    if (log) {
        Counters sum;
        for (const PassReport& pass : machine_->passes()) sum += pass.counters;
        log->executed(*this, {commands.list, commands.calls, cause, sum});
    }
    counts_.add(query_results(machine_->passes()));
    machine_->reset_passes();
    frame_.reuse(std::move(commands));
}

const std::map<std::uint32_t, Readback>& Drawable::execute_reads(const CommandList& list) {
    settle();
    machine_->execute(list);
    machine_->reset_passes();
    return machine_->readbacks();
}

bool Drawable::finish_execution(Cause cause) {
    const auto lock = exclusive();
    const bool ends = front_drawn_ || is_off_screen();
    if (ends) end_segment();   // recordings begin with frames
    if (!ends && background_)  // nothing that anybody sees: executed when it is swapped
        settle();
    else
        flush(ends ? Cause::Shown : cause);
    return ends;
}

// Not locked as a whole: windows lock their display before the drawable.
bool Drawable::finish(Cause cause) {
    const bool ends = finish_execution(cause);
    present();
    wait_until_shown();
    if (ends) end_frame();
    return ends;
}

void Drawable::flush_swapped() {
    const auto lock = exclusive();
    flush(Cause::Shown);
    front_changed_ = true;
}

void Drawable::swap() {
    {
        const auto lock = exclusive();
        end_segment();
    }
    if (has_back_plane()) add(SwapBuffers{});
    is_back_old_ = has_back_plane() && swap_method_ == SwapMethod::Copy;
    if (samples_ && has_back_plane() && samples_->follow_swap()) is_back_old_ = false;
    if (!swap_behind()) {
        flush_swapped();
        present();
    }
    end_frame();
}

void Drawable::select(gw::ReadBuffer buffer) {
    gw::State state = frame_.state_or_initial();
    if (state.read_buffer == buffer) return;
    state.read_buffer = buffer;
    set_state(state);
}

void Drawable::read_window(Plane plane) {
    if (samples_) samples_->resolve_read(plane, frame_.state_or_initial(), frame_.list());
}

void Drawable::execute_read(Plane plane, const Rect& rect, Cause cause, bool packed) {
    const bool is_of_back = state() != nullptr && state()->read_buffer == gw::ReadBuffer::Back;
    if (is_back_old_ && is_of_back) copy_to_back();
    read_window(plane);
    frame_.add_read(plane, rect, packed);
    flush(cause);
}

Readback Drawable::read(Plane plane, const Rect& rect, Cause cause) {
    const auto lock = exclusive();
    execute_read(plane, rect, cause, false);
    return machine_->readbacks().at(0);
}

void Drawable::read_values(Plane plane, const Rect& rect, Cause cause,
                           std::span<std::uint32_t> values) {
    const auto lock = exclusive();
    settle();
    machine_->read_into(0, values);
    execute_read(plane, rect, cause, false);
}

Readback Drawable::read_colors(gw::ReadBuffer buffer, const Rect& rect, Cause cause) {
    const auto lock = exclusive();
    select(buffer);
    return read(Plane::Color, rect, cause);
}

void Drawable::read_packed(const Rect& rect, Cause cause, std::span<std::uint32_t> pixels,
                           ReadLayout layout) {
    const auto lock = exclusive();
    settle();
    machine_->read_into(0, pixels, layout);
    execute_read(Plane::Color, rect, cause, true);
}

void Drawable::read_packed(gw::ReadBuffer buffer, const Rect& rect, Cause cause,
                           std::span<std::uint32_t> pixels, ReadLayout layout) {
    const auto lock = exclusive();
    select(buffer);
    read_packed(rect, cause, pixels, layout);
}

}  // namespace gw::gl
