#include "inspect/replay/pixel_history.h"

#include "gw/names.h"
#include "gw/reference/make.h"
#include "inspect/replay/following_observer.h"

namespace gw::inspect {
namespace {

class PixelObserver : public FollowingObserver {
public:
    PixelObserver(const Recording& recording, int x, int y)
        : FollowingObserver(recording), x_(x), y_(y) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        if (f.x != x_ || f.y != y_) return;
        PixelEvent e = event(before, after);
        e.polygon = polygon(f);
        e.fragment = f;
        e.fate = fate;
        events.push_back(std::move(e));
    }
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override {
        if (x != x_ || y != y_) return;
        const PixelEvent e = event(before, after);
        if (!events.empty() && events.back().command == e.command && !events.back().fragment)
            events.back().after = after;
        else
            events.push_back(e);
    }

    std::vector<PixelEvent> events;

private:
    PixelEvent event(const PixelValues& before, const PixelValues& after) const {
        PixelEvent e{.pass = pass(), .pass_name = pass_name(), .command = command_index()};
        e.command_name = name_of(command());
        e.draw = draw();
        e.before = before;
        e.after = after;
        return e;
    }

    int x_, y_;
};

class MapObserver : public FollowingObserver {
public:
    MapObserver(const Recording& recording, std::optional<std::size_t> pass, FragmentMaps& maps)
        : FollowingObserver(recording), width_(recording.width), wanted_(pass), maps_(maps) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues&, const PixelValues&) override {
        if (wanted_ && *wanted_ != pass()) return;
        const std::size_t i = std::size_t(f.y) * std::size_t(width_) + std::size_t(f.x);
        maps_.made[i] += 1;
        switch (fate) {
            case Fate::AlphaTest: maps_.alpha_killed[i] += 1; break;
            case Fate::StencilTest: maps_.stencil_killed[i] += 1; break;
            case Fate::DepthTest: maps_.depth_killed[i] += 1; break;
            case Fate::Written: maps_.written[i] += 1; break;
        }
    }
    void pixel(int, int, const PixelValues&, const PixelValues&) override {}

private:
    int width_;
    std::optional<std::size_t> wanted_;
    FragmentMaps& maps_;
};

void observe(const Recording& recording, Observer& observer) {
    const auto machine =
        reference::make(recording.profile, recording.width, recording.height, &observer);
    Player(recording, *machine).play();
}

}  // namespace

std::vector<PixelEvent> pixel_history(const Recording& recording, int x, int y) {
    PixelObserver observer(recording, x, y);
    observe(recording, observer);
    return observer.events;
}

const char* name_of(Fate fate) {
    switch (fate) {
        case Fate::AlphaTest: return "alpha test";
        case Fate::StencilTest: return "stencil test";
        case Fate::DepthTest: return "depth test";
        case Fate::Written: return "written";
    }
    return "";
}

FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass) {
    const std::vector<std::uint32_t> none(std::size_t(recording.width) *
                                          std::size_t(recording.height));
    FragmentMaps maps{none, none, none, none, none};
    MapObserver observer(recording, pass, maps);
    observe(recording, observer);
    return maps;
}

}  // namespace gw::inspect
