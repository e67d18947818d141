// The reference machine: the manual in code, command by command, primitive by primitive, fragment
// by fragment.
#include "gw/machine.h"

#include "gw/base/parallel.h"
#include "gw/reference/make.h"
#include "gw/reference/pixels.h"
#include "gw/reference/primitives.h"
#include "gw/sample_queries.h"
#include "gw/stages/fog.h"
#include "gw/stages/pixels/draw_pixels.h"
#include "gw/stages/pixels/plane_texels.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace gw {
namespace reference {
namespace {

/// Words into the caller's memory, in its layout.
void store(const Readback& read, const ReadTarget& to) {
    const int width = read.rect.width, height = read.rect.height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint32_t word = read.values[pixel_index(x, y, width)];
            const int row = to.layout.top_first ? height - 1 - y : y;
            to.values[pixel_index(x, row, width)] =
                to.layout.blue_first ? (word & 0xFF) << 16 | (word & 0xFF00) | (word >> 16 & 0xFF)
                                     : word;
        }
}

class ReferenceMachine final : public Machine {
public:
    ReferenceMachine(const Profile& profile, int width, int height, Observer* observer,
                     std::uint32_t observed)
        : profile_(profile),
          observer_(observer),
          observed_(observed),
          window_{
              {width, height, all_planes}, profile, {Planes(width, height, profile.color_planes)}} {
    }

    void execute(const CommandList& list) override {
        const FloatEnvironment environment;
        targets_ = std::exchange(next_targets_, {});
        // Nobody else has these textures any more.
        std::erase_if(texels_, [](const auto& kept) { return kept.first.use_count() == 1; });
        validate(list, profile_, window_.surface.width, window_.surface.height,
                 {state_, slot_planes_, targets_, pass_name(passes_), queries_.active(), made_,
                  number_});
        for (std::size_t i = 0; i < list.commands.size(); ++i) {
            if (observer_) observer_->begin_command(i);
            std::visit([this](const auto& command) { run_command(command); }, list.commands[i]);
        }
        take_digests();
    }

    const Planes& planes() override { return window_.planes(); }
    const std::vector<PassReport>& passes() override { return passes_; }
    void reset_passes() override {
        queries_.forget(passes_);
        passes_.clear();
    }
    const std::map<std::uint32_t, Readback>& readbacks() override { return readbacks_; }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        next_targets_[key] = {values, layout};
    }
    const Profile& profile() const override { return profile_; }

private:
    PassReport& pass() {
        if (passes_.empty()) passes_.emplace_back();
        return passes_.back();
    }

    FragmentTarget target(const Resolved& r) {
        return {used().samples, &pass().counters, number_ == observed_ ? observer_ : nullptr,
                fragment_bytes(r, used().profile)};
    }

    Resolved resolved() { return resolve(state_, used().profile, used().surface); }

    struct Drawable {
        Surface surface;
        Profile profile;              ///< with its depth_bits
        std::vector<Planes> samples;  ///< one, or those of each sample
        const Planes& planes() const { return samples[0]; }
    };
    Drawable& drawable(std::uint32_t number) {
        return number == 0 ? window_ : surfaces_.at(number);
    }
    Drawable& used() { return drawable(number_); }

    /// The digests of the current pass.
    void take_digests() {
        if (passes_.empty()) return;
        for (const Plane plane : every_plane)
            if (passes_.back().digested & mask_of(plane))
                passes_.back().digests[std::size_t(plane)] = digest(window_.planes(), plane);
    }

    const Texels* texels(const TextureBinding& binding, std::size_t unit) {
        if (binding.slot) return &slots_.at(*binding.slot);
        if (binding.surface) {
            const Drawable& from = surfaces_.at(binding.surface->surface);
            const Rect whole{0, 0, from.surface.width, from.surface.height};
            return &(surface_texels_[unit] =
                         plane_texels(binding.surface->plane, whole, from.planes().color,
                                      from.planes(), from.profile));
        }
        if (!binding.texture) return nullptr;
        auto& entry = texels_[binding.texture];
        if (entry.levels.empty()) entry = make_texels(*binding.texture, texel_bits_of(profile_));
        return &entry;
    }

    BoundTexels bound(const auto& command) {
        BoundTexels out{};
        for (std::size_t unit = 0; unit < out.size(); ++unit)
            out[unit] = texels(map_of(command, unit), unit);
        return out;
    }

    /// The look-ups of the fragments that were made since there were `before`.
    void count_texels(std::uint64_t before, const BoundTexels& texels) {
        const std::uint64_t fragments = pass().counters.fragments - before;
        for (std::size_t unit = 0; unit < texels.size(); ++unit)
            if (texels[unit])
                pass().counters.texels +=
                    fragments * std::uint64_t(look_ups(texture_of(state_, unit).min_filter,
                                                       texels[unit]->dimensions));
    }

    void run_command(const BeginPass& command) {
        take_digests();
        passes_.push_back({command.name, {}, command.digests, {}, {}});
    }
    void run_command(const SetState& command) { state_ = command.state; }
    void run_command(const Draw& command) {
        DrawContext context{&command, &used().profile, resolved(), {}, {}, {}};
        context.target = target(context.state);
        if (state_.color_source != ColorSource::PolygonId) context.texels = bound(command);
        if (context.state.fragment_fog && state_.fog.enable)
            context.fog_table = fog_table(state_.fog, profile_.color_bits);
        const std::uint64_t before = pass().counters.fragments;
        draw_mesh(context);
        count_texels(before, context.texels);
    }
    void run_command(Clear command) {
        const Resolved r = resolved();
        command.planes &= used().surface.planes;
        run(command, r, target(r), used().profile);
    }
    void run_command(const WriteSpans& command) {
        const Resolved r = resolved();
        run(command, r, target(r));
    }
    void run_command(const DrawPixels& command) {
        const Resolved r = resolved();
        if (command.source) {
            count_source(command, target(r), used().profile);
            return run_command(with_values(command, r.state.read_buffer, used().planes()));
        }
        const BoundTexels maps = bound(command);
        const std::uint64_t before = pass().counters.fragments;
        run(command, r, target(r), used().profile, maps);
        count_texels(before, maps);
    }
    void run_command(const Query& command) { queries_.run(command, passes_); }
    void run_command(const SwapBuffers& command) { run(command, target(resolved())); }
    void run_command(const CopyTexture& command) {
        const Resolved r = resolved();
        slots_[command.slot] = copied_texels(command, r, target(r), used().profile);
        slot_planes_[command.slot] = command.plane;
    }
    void run_command(const MakeSurface& command) {
        pass();
        surfaces_.erase(command.number);
        made_.erase(command.number);
        if (command.surface.width == 0) return;
        surfaces_.emplace(command.number,
                          Drawable{command.surface, profile_of(profile_, command.surface),
                                   std::vector(std::size_t(command.surface.sample_count()),
                                               Planes(command.surface))});
        made_[command.number] = command.surface;
    }
    void run_command(const UseSurface& command) {
        pass();
        number_ = command.number;
    }
    void run_command(const Blit& command) {
        const Drawable& from = drawable(command.from_surface);
        // Copies: it may be the target, too.
        const std::vector<Planes> before = blit_samples(from.samples, used().surface);
        const Resolved r = resolved();
        run(command, {from.surface, before, state_.read_buffer}, used().surface, r, target(r),
            used().profile);
    }
    void run_command(const Read& command) {
        const Resolved r = resolved();
        Readback result = run(command, r, target(r), used().profile);
        if (const auto to = targets_.find(command.key); to != targets_.end())
            store(result, to->second);
        else
            readbacks_[command.key] = std::move(result);
    }
    void run_command(const auto& command) {
        const Resolved r = resolved();
        run(command, r, target(r), used().profile);
    }

    Profile profile_;
    Observer* observer_;
    std::uint32_t observed_;  ///< the surface whose pixels it is told of
    Drawable window_;
    std::map<std::uint32_t, Drawable> surfaces_;
    std::map<std::uint32_t, Surface> made_;                 ///< of surfaces_
    std::uint32_t number_ = 0;                              ///< of the surface in use
    std::array<Texels, max_texture_units> surface_texels_;  ///< of the command in execution
    State state_;
    std::vector<PassReport> passes_;
    SampleQueries queries_;
    std::map<std::uint32_t, Texels> slots_;
    std::map<std::uint32_t, Plane> slot_planes_;
    std::map<TextureRef, Texels> texels_;
    std::map<std::uint32_t, Readback> readbacks_;
    ReadTargets targets_, next_targets_;  ///< of the list in execution, and of the next one
};

}  // namespace

std::unique_ptr<Machine> make(const Profile& profile, int width, int height, Observer* observer,
                              std::uint32_t surface) {
    check_window(width, height);
    validate(profile);
    return std::make_unique<ReferenceMachine>(profile, width, height, observer, surface);
}

}  // namespace reference

std::unique_ptr<Machine> make_reference(const Profile& profile, int width, int height) {
    return reference::make(profile, width, height, nullptr);
}

}  // namespace gw
