#include "inspect/pixel_history.h"

#include "gw/reference/make.h"
#include "inspect/player.h"

namespace gw::inspect {
namespace {

/// Knows which command of the recording is being executed, and in which pass.
class FollowingObserver : public Observer {
public:
    explicit FollowingObserver(const Recording& recording) : passes_(pass_ranges(recording)) {
        for (const CommandList& list : recording.lists)
            for (const Command& command : list.commands) commands_.push_back(&command);
    }

    void begin_command(std::size_t) override {
        if (started_) ++command_;
        started_ = true;
        while (pass_ + 1 < passes_.size() && command_ >= passes_[pass_].end) {
            ++pass_;
            draws_ = 0;
        }
        if (std::holds_alternative<Draw>(command())) ++draws_;
    }

protected:
    const Command& command() const { return *commands_[command_]; }
    std::size_t pass() const { return pass_; }

    PixelEvent event(const PixelValues& before, const PixelValues& after) const {
        PixelEvent e{.pass = pass_, .pass_name = passes_[pass_].name, .command = command_};
        e.command_name = inspect::name_of(command());
        if (std::holds_alternative<Draw>(command())) e.draw = draws_ - 1;
        e.before = before;
        e.after = after;
        return e;
    }

private:
    std::vector<PassRange> passes_;
    std::vector<const Command*> commands_;
    std::size_t command_ = 0, pass_ = 0, draws_ = 0;
    bool started_ = false;
};

std::uint32_t polygon_of(const Mesh& mesh, std::uint32_t primitive) {
    return mesh.polygon_id(mesh.kind() == MeshKind::Triangles ? mesh.triangles()[primitive].polygon
                                                              : primitive);
}

class PixelObserver : public FollowingObserver {
public:
    PixelObserver(const Recording& recording, int x, int y) : FollowingObserver(recording), x_(x), y_(y) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        if (f.x != x_ || f.y != y_) return;
        PixelEvent e = event(before, after);
        if (const auto* draw = std::get_if<Draw>(&command()))
            e.polygon = polygon_of(*draw->mesh, f.primitive);
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
    const auto machine = reference::make(recording.profile, recording.width, recording.height, &observer);
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
    const std::vector<std::uint32_t> none(std::size_t(recording.width) * std::size_t(recording.height));
    FragmentMaps maps{none, none, none, none, none};
    MapObserver observer(recording, pass, maps);
    observe(recording, observer);
    return maps;
}

}  // namespace gw::inspect
