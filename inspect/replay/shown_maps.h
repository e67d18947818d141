// The colour maps through which a screen showed a recording's passes. Commands are counted through
// all lists.
#pragma once

#include "gw/machine.h"
#include "gw/names.h"
#include "inspect/recording/recording.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

class ShownMaps {
public:
    /// Refers to the recording, which must outlive it and what it returns.
    explicit ShownMaps(const Recording& recording);

    /// At the end of the command's pass. Null: colours are not indices.
    const ColorMap* of(std::size_t command) const;
    /// At the end of the pass at this place.
    const ColorMap* of_pass(std::size_t pass) const { return of(pass_ends_.at(pass) - 1); }
    /// At the recording's end.
    const ColorMap* last() const;

private:
    std::vector<const ColorMap*> after_lists_;
    std::vector<std::size_t> list_ends_;  ///< commands up to and with each list
    std::vector<std::size_t> pass_ends_;
};

/// The digests of a recording's shown pictures, pass by pass; none while colours are not indices.
class ShownDigests {
public:
    /// Refers to the recording, which must outlive it.
    explicit ShownDigests(const Recording& recording) : maps_(recording) {}

    /// Of the machine that plays it, at the end of the next pass.
    void add(Machine& machine);
    const std::vector<std::optional<Digest>>& all() const { return all_; }

private:
    ShownMaps maps_;
    std::vector<std::optional<Digest>> all_;
};

/// The plane's value at a pixel of the window, as gw::value_at; of colours with a map, "index 37
/// through map entry 37 (200 100 50)".
std::string shown_value(const Planes& planes, Plane plane, int x, int y, const ColorMap* map);

}  // namespace gw::inspect
