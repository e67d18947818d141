// The fast machine: segments between barriers, each run tile by tile on all threads.
#include "gw/machine.h"

#include "gw/base/parallel.h"
#include "gw/fast/plan/plan.h"
#include "gw/fast/simd/simd_target.h"
#include "gw/fast/tile/blit.h"
#include "gw/fast/tile/clear.h"
#include "gw/fast/tile/tile_run.h"
#include "gw/sample_queries.h"
#include "gw/stages/pixels/blit.h"
#include "gw/stages/pixels/plane_texels.h"
#include "gw/stages/tables.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gw {
namespace fast {
namespace {

/// The tiles of a surface, or of each of its samples, and their planes in the host's layout, which
/// are made when they are first asked for.
struct Drawable {
    Surface surface;
    Profile profile;  ///< with its depth_bits
    std::deque<Frame> frames;
    std::vector<Frame*> all_frames;  ///< of `frames`
    std::vector<Planes> planes;      ///< of each frame
    bool planes_are_current;         ///< they are those of the frames
    KeptGeometry geometry;           ///< projected to this surface, while another one is in use

    Drawable(const Surface& of, const Profile& p, int log2_tile)
        : surface(of),
          profile(profile_of(p, of)),
          planes(std::size_t(of.sample_count())),
          planes_are_current(of.is_window()) {
        for (int k = 0; k < of.sample_count(); ++k)
            all_frames.push_back(&frames.emplace_back(of.width, of.height, log2_tile));
        if (of.is_window()) planes[0] = Planes(of.width, of.height, p.color_planes);
    }
    SegmentTarget target() const { return {surface, frames[0].grid()}; }
    /// Of a window, makes this colour plane the one in use.
    void use_color(bool back) {
        if (surface.is_window()) frames[0].use_color(back ? Plane::Back : Plane::Color);
    }
    /// Of a surface without samples, or of the first one.
    Planes& read(int threads) { return read_samples(threads)[0]; }
    std::span<Planes> read_samples(int threads) {
        for (std::size_t k = 0; k < frames.size() && !planes_are_current; ++k)
            read(frames[k], planes[k], threads);
        planes_are_current = true;
        return planes;
    }
    void write() {
        for (std::size_t k = 0; k < frames.size(); ++k)
            frames[k].write(frames[k].whole(), planes[k]);
    }
    /// Some planes of a rectangle of each frame, which write_part() puts back. Color is the front plane.
    std::vector<Planes> read_part(const Rect& rect, PlaneMask wanted, int threads) {
        Planes part;
        part.width = rect.width;
        part.height = rect.height;
        if (wanted & mask_of(Plane::Color)) part.color.resize(rect.area());
        if ((wanted & mask_of(Plane::Back)) && profile.color_planes == 2 && surface.is_window())
            part.back.resize(rect.area());
        if (wanted & mask_of(Plane::Depth)) part.depth.resize(rect.area());
        if (wanted & mask_of(Plane::Stencil)) part.stencil.resize(rect.area());
        std::vector<Planes> parts(frames.size(), part);
        for (std::size_t k = 0; k < frames.size(); ++k) read(frames[k], rect, parts[k], threads);
        return parts;
    }
    void write_part(const Rect& rect, std::span<const Planes> parts) {
        for (std::size_t k = 0; k < frames.size(); ++k) frames[k].write(rect, parts[k]);
        change();
    }
    /// The frames have other values from here on.
    void change() { planes_are_current = false; }

private:
    void read(Frame& frame, Planes& to, int threads) const {
        if (to.width == 0) to = Planes(surface);
        read(frame, frame.whole(), to, threads);
    }
    static void read(Frame& frame, const Rect& rect, Planes& to, int threads) {
        frame.begin_read(to);
        const std::vector<std::size_t> tiles = frame.tiles_of(rect);
        parallel_for(tiles.size(), threads, [&](std::size_t i, int) {
            write_back_blocks(frame.tile(tiles[i]));
            frame.read(tiles[i], rect, to);
        });
    }
};

/// The tiles of all samples at one place.
struct SampleTiles {
    std::array<Tile, max_samples> all;
    std::size_t count;

    SampleTiles(Drawable& of, std::size_t index) : count(of.frames.size()) {
        for (std::size_t k = 0; k < count; ++k) all[k] = of.frames[k].tile(index);
    }
    SampleTiles(Drawable& of, int x, int y) : SampleTiles(of, of.frames[0].tile_at(x, y)) {}
    std::span<const Tile> span() const { return std::span(all).first(count); }
};

class FastMachine final : public Machine {
public:
    FastMachine(const Profile& profile, int width, int height, const FastOptions& options)
        : threads_(options.threads > 0 ? options.threads : hardware_threads()),
          log2_tile_(options.log2_tile),
          runner_(threads_),
          window_({width, height, all_planes}, profile, log2_tile_) {
        machine_.profile = profile;
        machine_.surface_texels = [this](const SurfacePlane& plane, bool compared) -> FastTexels& {
            return texels_of(plane, compared && plane.plane == Plane::Depth);
        };
    }

    void execute(const CommandList& list) override {
        const FloatEnvironment environment;
        machine_.targets = std::exchange(next_targets_, {});
        validate(list, profile(), window_.surface.width, window_.surface.height,
                 {machine_.state, machine_.slot_planes, machine_.targets,
                  pass_name(machine_.passes), queries_.active(), made_, number_});
        std::span<const Command> rest(list.commands);
        while (!rest.empty()) {
            rest = rest.subspan(
                plan_segment(rest, machine_, used_->profile, used_->target(), threads_));
            run_segment();
            if (!rest.empty() && is_barrier(rest[0], machine_.passes)) {
                std::visit([this](const auto& command) { run_barrier(command); }, rest[0]);
                rest = rest.subspan(1);
            }
        }
        take_digests();
    }

    const Planes& planes() override { return window_.read(threads_); }
    const std::vector<PassReport>& passes() override { return machine_.passes; }
    void reset_passes() override {
        queries_.forget(machine_.passes);
        machine_.passes.clear();
    }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks; }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        next_targets_[key] = {values, layout};
    }
    const Profile& profile() const override { return machine_.profile; }

private:
    void run_segment() {
        const Segment& segment = machine_.segment;
        if (segment.ops.empty()) return;
        Frame& frame = used_->frames[0];  // the window's, if the following are needed
        if (segment.uses_accum) frame.need_accum();
        if (segment.scan.color_plane()) frame.use_color(*segment.scan.color_plane());
        if (segment.uses_both_colors) frame.need_other_color();
        used_->change();
        forget_texels(number_);
        const std::vector<OpCounts> totals =
            runner_.run(segment, used_->all_frames, used_->profile);
        for (std::size_t i = 0; i < totals.size(); ++i) {
            const TileOp& op = segment.ops[segment.count_slots[i]];
            machine_.passes[op.pass].counters += counters_of(op, totals[i], used_->profile);
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

    Drawable& drawable(std::uint32_t number) {
        return number == 0 ? window_ : *surfaces_.at(number);
    }
    Resolved resolved() const { return resolve(machine_.state, used_->profile, used_->surface); }

    /// The texels of a plane; in place: depths that are compared.
    FastTexels& texels_of(const SurfacePlane& from, bool in_place) {
        const auto [found, is_new] =
            surface_texels_.try_emplace({from.surface, from.plane, in_place});
        if (!is_new) return found->second;
        Drawable& surface = drawable(from.surface);
        if (in_place) return found->second = depths_in_place(surface.frames[0], surface.profile);
        const Rect whole = surface.frames[0].whole();
        const Planes part = surface.read_part(whole, mask_of(from.plane), threads_)[0];
        return found->second = make_fast_texels(
                   plane_texels(from.plane, whole, part.color, part, surface.profile));
    }
    void forget_texels(std::uint32_t number) {
        std::erase_if(surface_texels_,
                      [&](const auto& plane) { return std::get<0>(plane.first) == number; });
    }

    void run_barrier(const BeginPass& command) {
        take_digests();
        machine_.passes.push_back({command.name, {}, command.digests, {}, {}});
    }
    void run_barrier(const Copy& command) {
        const Resolved r = resolved();
        count(copy_pixels(command, r, used_->read(threads_)),
              plane_bytes(command.plane, used_->profile) +
                  written_bytes(command.plane, r.state, used_->profile));
        write_planes();
    }
    /// The host's planes of the surface in use were changed.
    void write_planes() {
        used_->write();
        forget_texels(number_);
    }
    /// Draws what the source has now, as a segment of its own.
    void run_barrier(const DrawPixels& command) {
        const Surface& surface = used_->surface;
        const Rect box = source_box(command, surface.width, surface.height);
        count(box.area(), plane_bytes(command.source->plane, used_->profile));
        const ReadBuffer buffer = resolved().state.read_buffer;
        const Plane plane = command.source->plane == Plane::Color && buffer == ReadBuffer::Back
                                ? Plane::Back
                                : command.source->plane;
        DrawPixels of_part = command;
        of_part.source->x -= box.x;
        of_part.source->y -= box.y;
        const Command drawn =
            with_values(of_part, buffer, used_->read_part(box, mask_of(plane), threads_)[0]);
        plan_segment({&drawn, 1}, machine_, used_->profile, used_->target(), threads_);
        run_segment();
    }
    void run_barrier(const CopyTexture& command) {
        machine_.slots[command.slot] = make_fast_texels(copied_texels(
            command, resolved().state.read_buffer, used_->read(threads_), used_->profile));
        machine_.slot_planes[command.slot] = command.plane;
        count(std::uint64_t(command.rect.width) * std::uint64_t(command.rect.height),
              plane_bytes(command.plane, used_->profile));
    }
    void run_barrier(const SwapBuffers&) {
        window_.frames[0].swap_colors();
        std::swap(window_.planes[0].color, window_.planes[0].back);
        count(0, 0);
    }
    void run_barrier(const Query& command) { queries_.run(command, machine_.passes); }
    void run_barrier(const MakeSurface& command) {
        surfaces_.erase(command.number);
        made_.erase(command.number);
        forget_texels(command.number);
        count(0, 0);
        if (command.surface.width == 0) return;
        surfaces_[command.number] =
            std::make_unique<Drawable>(command.surface, profile(), log2_tile_);
        made_[command.number] = command.surface;
    }
    void run_barrier(const UseSurface& command) {
        std::swap(machine_.geometry, used_->geometry);
        number_ = command.number;
        used_ = &drawable(number_);
        std::swap(machine_.geometry, used_->geometry);
        count(0, 0);
    }
    void run_barrier(const Blit& command) {
        const Resolved r = resolved();
        Drawable& from = drawable(command.from_surface);
        const PlaneMask planes = blitted_planes(command, from.surface, used_->surface);
        if (stays_in_place(command, planes, r.state.draw_buffer))
            blit_tiles(command, planes, r, from);
        else
            blit_planes(command, planes, r, from);
        forget_texels(number_);
    }
    /// Whether each pixel keeps its place, in planes of another surface, one of colours.
    bool stays_in_place(const Blit& c, PlaneMask planes, DrawBuffer to) const {
        return c.from_surface != number_ && c.source == c.target && !c.flip_x && !c.flip_y &&
               ((planes & mask_of(Plane::Color)) == 0 || to == DrawBuffer::Front ||
                to == DrawBuffer::Back);
    }
    /// Copies tile by tile.
    void blit_tiles(const Blit& command, PlaneMask planes, const Resolved& r, Drawable& from) {
        const Rect box = intersect(intersect(r.pixel_box, command.target),
                                   {0, 0, from.surface.width, from.surface.height});
        for (const Plane plane : every_plane)
            if (planes & mask_of(plane))
                count(box.area(),
                      blit_bytes(plane, from.surface, used_->surface, r.state, used_->profile));
        if (planes & mask_of(Plane::Color)) {
            from.use_color(machine_.state.read_buffer == ReadBuffer::Back);
            used_->use_color(r.state.draw_buffer == DrawBuffer::Back);
        }
        const std::vector<std::size_t> tiles = used_->frames[0].tiles_of(box);
        parallel_for(tiles.size(), threads_, [&](std::size_t i, int) {
            const SampleTiles to(*used_, tiles[i]), source(from, to.all[0].x, to.all[0].y);
            blit_blocks({source.span(), to.span(), block_box(box, to.all[0]), planes});
        });
        used_->change();
    }
    static PlaneMask with_back(PlaneMask planes) {
        return planes & mask_of(Plane::Color) ? PlaneMask(planes | mask_of(Plane::Back)) : planes;
    }
    void blit_planes(const Blit& command, PlaneMask planes, Resolved r, Drawable& from) {
        const BlitParts parts = blit_parts(command, r.pixel_box, from.surface);
        r.pixel_box = {0, 0, parts.target.width, parts.target.height};
        const Profile& p = used_->profile;
        const PlaneMask both = with_back(planes);
        // Copies: it may be the target, too.
        const std::vector<Planes> source =
            blit_samples(from.read_part(parts.source, both, threads_), used_->surface);
        std::vector<Planes> to = used_->read_part(parts.target, both, threads_);
        for (const Plane plane : every_plane) {
            if ((planes & mask_of(plane)) == 0) continue;
            std::uint64_t pixels = 0;
            for (std::size_t k = 0; k < to.size(); ++k)
                pixels = blit_plane(parts.blit, plane,
                                    {from.surface, source, machine_.state.read_buffer}, k, r,
                                    p.color_bits, to[k]);
            count(pixels, blit_bytes(plane, from.surface, used_->surface, r.state, p));
        }
        used_->write_part(parts.target, to);
    }
    void run_barrier(const auto&) {}

    void count(std::uint64_t pixels, std::uint64_t bytes) {
        if (machine_.passes.empty()) machine_.passes.emplace_back();
        machine_.passes.back().counters.pixels += pixels;
        machine_.passes.back().counters.bytes += pixels * bytes;
    }

    int threads_, log2_tile_;
    TileRunner runner_;
    Drawable window_;
    std::map<std::uint32_t, std::unique_ptr<Drawable>> surfaces_;
    std::map<std::uint32_t, Surface> made_;  ///< of surfaces_
    std::uint32_t number_ = 0;               ///< of the surface in use
    Drawable* used_ = &window_;
    /// by surface and plane; whether in place
    std::map<std::tuple<std::uint32_t, Plane, bool>, FastTexels> surface_texels_;
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
