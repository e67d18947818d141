// The Z-buffer [L8]: the machine's own. The list draws the scene's meshes. The step log and the
// comparisons are computed beside it, by scan conversion and increments of z, and agree with it.
#include "hiddensurface/run/algorithm.h"
#include "hiddensurface/structures/scan_conversion.h"
#include "scene/draw/draw_commands.h"

namespace gw::hiddensurface {
namespace {

/// F and Z of the lecture, for the log.
class Buffers {
public:
    Buffers(const Input& input, StepLog& log) : input_(input), log_(log) {
        const auto pixels = std::size_t(input.view.width) * std::size_t(input.view.height);
        z_.resize(pixels, (std::int64_t{1} << input.profile.depth_bits) - 1);
    }

    std::uint64_t compared() const { return compared_; }

    void draw(const Polygon& polygon) {
        std::vector<Painted> painted;
        for (const WindowTriangle& t : polygon.triangles)
            for (const Run& run : scan_convert(t.corners, input_.subpixel_bits(), input_.window()))
                draw(run, t.depth, polygon.id, painted);
        if (log_.on() && !log_.wants(Level::Pixel) && !painted.empty())
            log_.add(
                {Level::Polygon, Action::Draw, {polygon.id}, "z < Z", "", -1, std::move(painted)});
    }

private:
    void draw(const Run& run, const DepthPlane& depth, std::uint32_t id,
              std::vector<Painted>& painted) {
        DepthWalk walk(depth, run.x0, run.y);
        for (int x = run.x0; x < run.x1; ++x, walk.right()) {
            std::int64_t& stored = z_[input_.view.index(x, run.y)];
            const bool passes = walk.z() < stored;
            compared_ += 1;
            if (passes) stored = walk.z();
            if (log_.wants(Level::Pixel)) log_pixel({run.y, x, x + 1}, id, passes);
            if (passes) add_run(painted, {run.y, x, x + 1}, id);
        }
    }

    void log_pixel(const Run& run, std::uint32_t id, bool passes) {
        Step step{Level::Pixel, passes ? Action::Draw : Action::Compare, {id},
                  "z < Z",      passes ? "nearer" : "not nearer",        run.y};
        if (passes) step.painted = {{run, id}};
        step.before = {{dvec3(run.x0, run.y, 0), dvec3(run.x1, run.y, 0)}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    std::vector<std::int64_t> z_;
    std::uint64_t compared_ = 0;
};

Output run(const Input& input, StepLog& log) {
    Output output{.list = scene::id_pass(input.scene, input.view)};
    Buffers buffers(input, log);
    for (const Polygon& polygon : input.polygons) buffers.draw(polygon);
    output.counts.depths = buffers.compared();
    output.counts.peak_bytes = std::uint64_t(input.view.width) * std::uint64_t(input.view.height) *
                               std::uint64_t((input.profile.depth_bits + 7) / 8);
    return output;
}

}  // namespace

Algorithm z_buffer() {
    return {.name = "z-buffer",
            .title = "Z-buffer, the machine's [L8]",
            .claim = Claim::Always,
            .uses_depth_plane = true,
            .run = run};
}

}  // namespace gw::hiddensurface
