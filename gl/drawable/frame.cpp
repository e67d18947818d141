#include "gl/drawable/frame.h"

#include <string>
#include <variant>

namespace gw::gl {

namespace {

/// A frame of more vertices is executed in parts.
constexpr std::uint64_t largest_frame = 1u << 20;
constexpr std::size_t most_commands = 1u << 16;
constexpr std::size_t most_bytes = 1u << 28;  // of textures and pixels

std::size_t pixel_bytes(const gw::DrawPixels& pixels) {
    return pixels.colors.size() * sizeof(Rgba) + pixels.bits.size() +
           (pixels.depths.size() + pixels.stencils.size()) * sizeof(std::uint32_t);
}

}  // namespace

void Frame::begin() {
    if (std::exchange(is_new_, false))
        commands_.list.add(BeginPass{"frame " + std::to_string(number_)});
}

void Frame::add(Command command, std::span<const CallRun> calls) {
    begin();
    CommandList& list = commands_.list;
    if (const auto* draw = std::get_if<Draw>(&command))
        vertices_ += draw->mesh->vertex_count();
    else if (const auto* pixels = std::get_if<gw::DrawPixels>(&command))
        bytes_ += pixel_bytes(*pixels);
    else if (const auto* set = std::get_if<SetState>(&command))
        last_state_ = set->state;
    for (const CallRun& run : calls) {
        commands_.calls.push_back(run);
        commands_.calls.back().command = static_cast<std::uint32_t>(list.commands.size());
    }
    list.add(std::move(command));
}

void Frame::add_read(Plane plane, const Rect& rect, bool packed) {
    commands_.list.add(Read{.key = 0, .plane = plane, .rect = rect, .packed = packed});
}

bool Frame::is_full() const {
    return vertices_ >= largest_frame || commands_.list.commands.size() >= most_commands ||
           bytes_ >= most_bytes;
}

CollectedCommands Frame::take() {
    vertices_ = 0;
    bytes_ = 0;
    return std::exchange(commands_, {});
}

void Frame::reuse(CollectedCommands executed) {
    executed.list.commands.clear();
    executed.calls.clear();
    commands_ = std::move(executed);
}

void Frame::drop() {
    take();
    last_state_ = std::nullopt;
    is_new_ = true;
}

void Frame::end() {
    ++number_;
    is_new_ = true;
}

}  // namespace gw::gl
