// An observer of a recording's replay that knows the command in execution and its pass. Subclasses
// use the fragments.
#pragma once

#include "gw/reference/observer.h"
#include "inspect/replay/player.h"

#include <optional>

namespace gw::inspect {

class FollowingObserver : public Observer {
public:
    /// Refers to the recording, which must outlive it.
    explicit FollowingObserver(const Recording& recording);

    void begin_command(std::size_t command) override;

protected:
    const Command& command() const { return *commands_[command_]; }
    /// Through all lists, from 0.
    std::size_t command_index() const { return command_; }
    std::size_t pass() const { return pass_; }
    const std::string& pass_name() const { return passes_[pass_].name; }
    /// Of a draw: its place among the draws of the pass.
    std::optional<std::size_t> draw() const;
    /// Of a draw: the place of the fragment's polygon, line or point in its mesh.
    std::optional<std::uint32_t> place_in_mesh(const Fragment& fragment) const;
    /// Of a draw: the identifier of the fragment's polygon in its mesh.
    std::optional<std::uint32_t> polygon(const Fragment& fragment) const;

private:
    std::vector<PassRange> passes_;
    std::vector<const Command*> commands_;
    std::size_t command_ = 0, pass_ = 0, draws_ = 0;
    bool started_ = false;
};

}  // namespace gw::inspect
