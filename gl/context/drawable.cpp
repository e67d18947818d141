#include "gl/context/drawable.h"

#include "gl/context/frame_log.h"
#include "gl/context/settings.h"

#include <utility>

namespace gw::gl {

namespace {

/// A frame of more vertices is executed in parts.
constexpr std::uint64_t largest_frame = 1u << 20;
constexpr std::size_t most_commands = 1u << 16;

std::unique_ptr<FrameLog> log;

}  // namespace

FrameLog* frame_log() { return log.get(); }
void set_frame_log(std::unique_ptr<FrameLog> to) { log = std::move(to); }

Drawable::Drawable(const Profile& profile, int width, int height, std::string name, Buffers buffers)
    : name_(std::move(name)),
      width_(width),
      height_(height),
      buffers_(buffers),
      machine_(make_fast(profile, width, height, {.threads = settings().threads})) {
    if (log) log->open(name_, width, height);
}

Drawable::~Drawable() {
    if (log) log->close(name_);
}

void Drawable::resize(int width, int height) {
    const auto lock = exclusive();
    machine_ = make_fast(Profile(profile()), width, height, {.threads = settings().threads});
    width_ = width;
    height_ = height;
    frame_ = {};
    frame_vertices_ = 0;
    last_state_ = nullptr;
    frame_begins_ = true;
    if (!log) return;
    log->close(name_);
    log->open(name_, width, height);
}

void Drawable::add(Command command) {
    const auto lock = exclusive();
    if (std::exchange(frame_begins_, false))
        frame_.add(BeginPass{"frame " + std::to_string(frames_)});
    if (const auto* draw = std::get_if<Draw>(&command))
        frame_vertices_ += draw->mesh->vertex_count();
    frame_.add(std::move(command));
    if (frame_vertices_ < largest_frame && frame_.commands.size() < most_commands) return;
    ++barriers_;
    flush();
}

void Drawable::begin_frame() {
    const auto lock = exclusive();
    if (frame_begins_) return;
    ++frames_;
    frame_begins_ = true;
}

void Drawable::set_state(const gw::State& state) {
    const auto lock = exclusive();
    if (has_back_plane())
        front_changed_ |=
            state.draw_buffer == DrawBuffer::Front || state.draw_buffer == DrawBuffer::FrontAndBack;
    else
        front_changed_ |= !is_double_buffered();
    if (last_state_ && *last_state_ == state) return;
    last_state_ = std::make_unique<gw::State>(state);
    add(SetState{state});
}

void Drawable::flush() {
    const auto lock = exclusive();
    if (frame_.commands.empty()) return;
    const CommandList frame = std::exchange(frame_, {});
    frame_vertices_ = 0;
    machine_->execute(frame);
    machine_->reset_passes();
    if (log) log->add(name_, frame);
}

void Drawable::swap() {
    if (has_back_plane()) add(SwapBuffers{});
    flush();
    front_changed_ = true;
    present();
    begin_frame();
}

void Drawable::select(gw::ReadBuffer buffer) {
    if ((last_state_ ? last_state_->read_buffer : gw::ReadBuffer::Front) == buffer) return;
    gw::State state = last_state_ ? *last_state_ : gw::State();
    state.read_buffer = buffer;
    set_state(state);
}

void Drawable::execute_read(Plane plane, const Rect& rect, bool packed) {
    if (!frame_.commands.empty()) ++barriers_;
    frame_.add(Read{.key = 0, .plane = plane, .rect = rect, .packed = packed});
    flush();
}

Readback Drawable::read(Plane plane, const Rect& rect) {
    const auto lock = exclusive();
    execute_read(plane, rect, false);
    return machine_->readbacks().at(0);
}

Readback Drawable::read_colors(gw::ReadBuffer buffer, const Rect& rect) {
    const auto lock = exclusive();
    select(buffer);
    return read(Plane::Color, rect);
}

void Drawable::read_packed(const Rect& rect, std::span<std::uint32_t> pixels) {
    const auto lock = exclusive();
    machine_->read_into(0, pixels);
    execute_read(Plane::Color, rect, true);
}

void Drawable::read_packed(gw::ReadBuffer buffer, const Rect& rect,
                           std::span<std::uint32_t> pixels) {
    const auto lock = exclusive();
    select(buffer);
    read_packed(rect, pixels);
}

}  // namespace gw::gl
