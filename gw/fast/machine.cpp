// The fast machine: segments between barriers, each run tile by tile on all threads.
#include "gw/machine.h"

#include "gw/base/parallel.h"
#include "gw/fast/plan/plan.h"
#include "gw/fast/simd/simd_target.h"
#include "gw/fast/tile/clear.h"
#include "gw/fast/tile/tile_run.h"
#include "gw/sample_queries.h"
#include "gw/stages/tables.h"

#include <bit>
#include <utility>

namespace gw {
namespace fast {
namespace {

class FastMachine final : public Machine {
public:
    FastMachine(const Profile& profile, int width, int height, const FastOptions& options)
        : profile_(profile),
          threads_(options.threads > 0 ? options.threads : hardware_threads()),
          runner_(threads_),
          frame_(width, height, options.log2_tile),
          planes_(width, height, profile.color_planes) {}

    void execute(const CommandList& list) override {
        const FloatEnvironment environment;
        machine_.targets = std::exchange(next_targets_, {});
        validate(list, profile_, grid().width, grid().height,
                 {machine_.state, machine_.slot_planes, machine_.targets,
                  pass_name(machine_.passes), queries_.active()});
        std::span<const Command> rest(list.commands);
        while (!rest.empty()) {
            rest = rest.subspan(plan_segment(rest, machine_, profile_, grid(), threads_));
            run_segment();
            if (!rest.empty() && is_barrier(rest[0], machine_.passes)) {
                std::visit([this](const auto& command) { run_barrier(command); }, rest[0]);
                rest = rest.subspan(1);
            }
        }
        take_digests();
    }

    const Planes& planes() override {
        if (!planes_are_current_) {
            frame_.begin_read(planes_);
            parallel_for(grid().count(), threads_, [this](std::size_t i, int) {
                write_back_blocks(frame_.tile(i));
                frame_.read(i, planes_);
            });
        }
        planes_are_current_ = true;
        return planes_;
    }
    const std::vector<PassReport>& passes() override { return machine_.passes; }
    void reset_passes() override {
        queries_.forget(machine_.passes);
        machine_.passes.clear();
    }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks; }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        next_targets_[key] = {values, layout};
    }
    const Profile& profile() const override { return profile_; }

private:
    const TileGrid& grid() const { return frame_.grid(); }

    void run_segment() {
        const Segment& segment = machine_.segment;
        if (segment.ops.empty()) return;
        if (segment.uses_accum) frame_.need_accum();
        if (segment.scan.color_plane()) frame_.use_color(*segment.scan.color_plane());
        if (segment.uses_both_colors) frame_.need_other_color();
        planes_are_current_ = false;
        const std::vector<OpCounts> totals = runner_.run(segment, frame_, profile_);
        for (std::size_t i = 0; i < totals.size(); ++i) {
            const TileOp& op = segment.ops[segment.count_slots[i]];
            machine_.passes[op.pass].counters += counters_of(op, totals[i], profile_);
        }
        end_segment(machine_);
    }

    void take_digests() {
        if (machine_.passes.empty() || machine_.passes.back().digested == 0) return;
        PassReport& pass = machine_.passes.back();
        for (const Plane plane : every_plane)
            if (pass.digested & mask_of(plane))
                pass.digests[std::size_t(plane)] = digest(planes(), plane);
    }

    void run_barrier(const BeginPass& command) {
        take_digests();
        machine_.passes.push_back({command.name, {}, command.digests, {}, {}});
    }
    void run_barrier(const Copy& command) {
        const Resolved r = resolve(machine_.state, profile_, grid().width, grid().height);
        planes();
        count(
            copy_pixels(command, r, planes_),
            plane_bytes(command.plane, profile_) + written_bytes(command.plane, r.state, profile_));
        frame_.write(planes_);
    }
    /// Draws what the source has now, as a segment of its own.
    void run_barrier(const DrawPixels& command) {
        count(source_box(command, grid().width, grid().height).area(),
              plane_bytes(command.source->plane, profile_));
        const Command drawn = with_values(command, machine_.state.read_buffer, planes());
        plan_segment({&drawn, 1}, machine_, profile_, grid(), threads_);
        run_segment();
    }
    void run_barrier(const CopyTexture& command) {
        planes();
        machine_.slots[command.slot] =
            make_fast_texels(copied_texels(command, machine_.state.read_buffer, planes_, profile_));
        machine_.slot_planes[command.slot] = command.plane;
        count(std::uint64_t(command.rect.width) * std::uint64_t(command.rect.height),
              plane_bytes(command.plane, profile_));
    }
    void run_barrier(const SwapBuffers&) {
        frame_.swap_colors();
        std::swap(planes_.color, planes_.back);
        count(0, 0);
    }
    void run_barrier(const Query& command) { queries_.run(command, machine_.passes); }
    void run_barrier(const auto&) {}

    void count(std::uint64_t pixels, std::uint64_t bytes) {
        if (machine_.passes.empty()) machine_.passes.emplace_back();
        machine_.passes.back().counters.pixels += pixels;
        machine_.passes.back().counters.bytes += pixels * bytes;
    }

    Profile profile_;
    int threads_;
    TileRunner runner_;
    Frame frame_;
    Planes planes_;
    bool planes_are_current_ = true;
    MachineState machine_;
    SampleQueries queries_;
    ReadTargets next_targets_;
};

}  // namespace
}  // namespace fast

std::string simd_target() { return fast::simd_target(); }

std::unique_ptr<Machine> make_fast(const Profile& profile, int width, int height,
                                   const FastOptions& options) {
    check_window(width, height);
    validate(profile);
    return std::make_unique<fast::FastMachine>(profile, width, height, options);
}

}  // namespace gw
