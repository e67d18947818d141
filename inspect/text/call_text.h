// The calls that made a recording's commands, in words.
#pragma once

#include "inspect/recording/recording.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

/// The calls of a command's primitives from `first` on, in words around the numbers.
struct CallWords {
    std::uint32_t first = 0;
    std::string before;  ///< "call 14 glCallList, list 7: call "
    std::uint32_t number = 0, step = 0;
    std::string after;      ///< " glVertex3f"
    std::string primitive;  ///< "quad"; "" if the command draws no mesh
    std::uint32_t ordinal = 0;

    /// Of a primitive; without one, of the first.
    std::string text(std::optional<std::uint32_t> primitive) const;
};

class CallNames {
public:
    /// Refers to the recording, which must outlive it.
    explicit CallNames(const Recording& recording);

    bool empty() const { return empty_; }
    /// "call 4711 glCallList, list 7: call 3 glVertex3f, quad 1" of a command, counted through all
    /// lists, and of a primitive of its mesh; without one, of its first. "" if it is unknown.
    std::string text(std::size_t command, std::optional<std::uint32_t> primitive = {}) const;
    /// Of all runs of a command.
    std::vector<CallWords> words(std::size_t command) const;

private:
    /// The command's list, if it has calls, and its place there.
    struct Place {
        const CallTable* table;
        const CommandList& list;
        std::uint32_t command;
    };
    Place place_of(std::size_t command) const;

    const Recording& recording_;
    std::vector<std::size_t> first_commands_;  ///< of each list, and of their end
    bool empty_ = true;
};

}  // namespace gw::inspect
