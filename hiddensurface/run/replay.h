// A step log played forwards and backwards: the picture, the order of the list and the step at any
// place.
// Needs the log only. Does not draw.
#pragma once

#include "hiddensurface/run/steps.h"

namespace gw::hiddensurface {

class Replay {
public:
    Replay(std::vector<Step> steps, int width, int height);

    std::size_t size() const { return steps_.size(); }
    /// Steps done so far: 0 .. size().
    std::size_t position() const { return undo_.size(); }
    const Step& step(std::size_t i) const { return steps_[i]; }
    /// Identifiers after the steps done, bottom row first.
    const std::vector<std::uint32_t>& ids() const { return ids_; }
    /// Identifiers in the order last sorted; empty before.
    const std::vector<std::uint32_t>& order() const { return order_; }

    void forward();
    void backward();
    void go_to(std::size_t position);

private:
    struct Undo {
        std::vector<std::uint32_t> ids;    ///< of the pixels painted, in the order painted
        std::vector<std::uint32_t> order;  ///< of a Sort
    };
    template <class Change>
    void for_painted(const Step& step, const Change& change);

    std::vector<Step> steps_;
    std::vector<std::uint32_t> ids_, order_;
    std::vector<Undo> undo_;
    int width_ = 0;
};

}  // namespace gw::hiddensurface
