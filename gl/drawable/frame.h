// The frame that is being collected for a drawable: its commands, the calls that made them, and its
// size. Does not execute.
#pragma once

#include "gl/drawable/call_trace.h"
#include "gw/command_list.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gw::gl {

/// Commands and the calls that made them.
struct CollectedCommands {
    CommandList list;
    std::vector<CallRun> calls;  ///< empty if calls_are_kept is false
};

class Frame {
public:
    /// From 0.
    std::uint64_t number() const { return number_; }
    /// Whether it has had no command yet, executed or not.
    bool is_new() const { return is_new_; }
    bool has_commands() const { return !commands_.list.commands.empty(); }
    /// The state after the commands so far; null: none has set one.
    const gw::State* state() const { return last_state_ ? &**last_state_ : nullptr; }

    /// Whether the commands that follow find this state already.
    bool finds_state(const SharedValue<gw::State>& state) {
        if (last_state_ != state) return false;
        last_state_ = state;  // one object: compared by its address from now on
        return true;
    }

    /// Begins its pass, "frame 12", as the first command does.
    void begin();
    /// The state that a command finds.
    gw::State state_or_initial() const { return last_state_ ? **last_state_ : gw::State(); }
    void add(Command command, std::span<const CallRun> calls = {});
    /// What is collected, for commands that change no state and begin no frame.
    CommandList& list() { return commands_.list; }
    /// A read of the plane's colours or values, with the key 0. Part of no frame.
    void add_read(Plane plane, const Rect& rect, bool packed);
    /// Adds to the memory that the commands keep: textures made for them.
    void hold(std::size_t bytes) { bytes_ += bytes; }
    /// Whether it has so many vertices, commands or bytes that it is executed in parts.
    bool is_full() const;

    /// Moves the commands out. What follows belongs to the same frame.
    CollectedCommands take();
    /// Takes back the memory of executed commands. Precondition: there are no new ones.
    void reuse(CollectedCommands executed);
    /// After an error of execution: the machine's state is unknown.
    std::optional<SharedValue<gw::State>> take_state() {
        return std::exchange(last_state_, std::nullopt);
    }
    void restore_state(std::optional<SharedValue<gw::State>> state) {
        last_state_ = std::move(state);
    }
    /// Drops commands that were not executed. The frame keeps its number.
    void drop();
    /// The commands that follow are those of the next frame.
    void end();

private:
    CollectedCommands commands_;
    std::uint64_t vertices_ = 0;
    std::size_t bytes_ = 0;  ///< of textures and pixels
    std::uint64_t number_ = 0;
    bool is_new_ = true;
    std::optional<SharedValue<gw::State>> last_state_;
};

}  // namespace gw::gl
