#include "inspect/report/pass_observer.h"

namespace gw::report {

void PassObserver::begin_command(std::size_t place) {
    FollowingObserver::begin_command(place);
    if (const auto* set = std::get_if<SetState>(&command())) state_ = set->state;
}

void PassObserver::fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                            const PixelValues& after) {
    if (const auto* draw = std::get_if<Draw>(&command()); draw && fate == Fate::Written)
        polygons_.written(fragment, *draw, *polygon(fragment), state_);
    if (history_)
        history_->add({fragment.x, fragment.y, command_index(), before, after, &fragment, fate,
                       draw(), polygon(fragment)});
}

void PassObserver::pixel(int x, int y, const PixelValues& before, const PixelValues& after) {
    const auto* clear = std::get_if<Clear>(&command());
    if (clear && clear->planes & (mask_of(Plane::Color) | mask_of(Plane::Depth)))
        polygons_.cleared(x, y);
    if (history_) history_->add({x, y, command_index(), before, after});
}

}  // namespace gw::report
