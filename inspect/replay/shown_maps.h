// The colour maps through which a screen showed a recording's passes. Commands are counted through
// all lists.
#pragma once

#include "inspect/recording/recording.h"

#include <vector>

namespace gw::inspect {

class ShownMaps {
public:
    /// Refers to the recording, which must outlive it and what it returns.
    explicit ShownMaps(const Recording& recording);

    /// At the end of the command's pass. Null: colours are not indices.
    const ColorMap* of(std::size_t command) const;
    /// At the recording's end.
    const ColorMap* last() const;

private:
    std::vector<const ColorMap*> after_lists_;
    std::vector<std::size_t> list_ends_;  ///< commands up to and with each list
    std::vector<std::size_t> pass_ends_;
};

}  // namespace gw::inspect
