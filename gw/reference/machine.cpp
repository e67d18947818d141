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
#include "gw/stages/tables.h"

#include <algorithm>
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
    ReferenceMachine(const Profile& profile, int width, int height, Observer* observer)
        : profile_(profile), observer_(observer), planes_(width, height, profile.color_planes) {}

    void execute(const CommandList& list) override {
        const FloatEnvironment environment;
        targets_ = std::exchange(next_targets_, {});
        // Nobody else has these textures any more.
        std::erase_if(texels_, [](const auto& kept) { return kept.first.use_count() == 1; });
        validate(list, profile_, planes_.width, planes_.height,
                 {state_, slot_planes_, targets_, pass_name(passes_), queries_.active()});
        for (std::size_t i = 0; i < list.commands.size(); ++i) {
            if (observer_) observer_->begin_command(i);
            std::visit([this](const auto& command) { run_command(command); }, list.commands[i]);
        }
        take_digests();
    }

    const Planes& planes() override { return planes_; }
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
        return {&planes_, &pass().counters, observer_, fragment_bytes(r, profile_)};
    }

    Resolved resolved() const { return resolve(state_, profile_, planes_.width, planes_.height); }

    /// The digests of the current pass.
    void take_digests() {
        if (passes_.empty()) return;
        for (const Plane plane : every_plane)
            if (passes_.back().digested & mask_of(plane))
                passes_.back().digests[std::size_t(plane)] = digest(planes_, plane);
    }

    const Texels* texels(const TextureBinding& binding) {
        if (binding.slot) return &slots_.at(*binding.slot);
        if (!binding.texture) return nullptr;
        auto& entry = texels_[binding.texture];
        if (entry.levels.empty()) entry = make_texels(*binding.texture, texel_bits_of(profile_));
        return &entry;
    }

    BoundTexels bound(const auto& command) {
        BoundTexels out{};
        for (std::size_t unit = 0; unit < out.size(); ++unit)
            out[unit] = texels(map_of(command, unit));
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
        DrawContext context{&command, &profile_, resolved(), {}, {}, {}};
        context.target = target(context.state);
        if (state_.color_source != ColorSource::PolygonId) context.texels = bound(command);
        if (context.state.fragment_fog && state_.fog.enable)
            context.fog_table = fog_table(state_.fog, profile_.color_bits);
        const std::uint64_t before = pass().counters.fragments;
        draw_mesh(context);
        count_texels(before, context.texels);
    }
    void run_command(const WriteSpans& command) {
        const Resolved r = resolved();
        run(command, r, target(r));
    }
    void run_command(const DrawPixels& command) {
        const Resolved r = resolved();
        if (command.source) {
            count_source(command, target(r), profile_);
            return run_command(with_values(command, state_.read_buffer, planes_));
        }
        const BoundTexels used = bound(command);
        const std::uint64_t before = pass().counters.fragments;
        run(command, r, target(r), profile_, used);
        count_texels(before, used);
    }
    void run_command(const Query& command) { queries_.run(command, passes_); }
    void run_command(const SwapBuffers& command) { run(command, target(resolved())); }
    void run_command(const CopyTexture& command) {
        const Resolved r = resolved();
        slots_[command.slot] = copied_texels(command, r, target(r), profile_);
        slot_planes_[command.slot] = command.plane;
    }
    void run_command(const Read& command) {
        const Resolved r = resolved();
        Readback result = run(command, r, target(r), profile_);
        if (const auto to = targets_.find(command.key); to != targets_.end())
            store(result, to->second);
        else
            readbacks_[command.key] = std::move(result);
    }
    void run_command(const auto& command) {
        const Resolved r = resolved();
        run(command, r, target(r), profile_);
    }

    Profile profile_;
    Observer* observer_;
    Planes planes_;
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

std::unique_ptr<Machine> make(const Profile& profile, int width, int height, Observer* observer) {
    check_window(width, height);
    validate(profile);
    return std::make_unique<ReferenceMachine>(profile, width, height, observer);
}

}  // namespace reference

std::unique_ptr<Machine> make_reference(const Profile& profile, int width, int height) {
    return reference::make(profile, width, height, nullptr);
}

}  // namespace gw
