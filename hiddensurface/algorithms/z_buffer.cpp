// The Z-buffer [L8]: the machine's own. The list draws the scene's meshes. The step log and the
// comparisons are computed beside it, by scan conversion and increments of z, and agree with it.
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/model/scan_conversion.h"
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

    const std::uint64_t& compared() const { return compared_; }

    void draw(const Polygon& polygon) {
        std::vector<Painted> painted;
        const std::uint64_t before = compared_;
        for (const WindowTriangle& t : polygon.triangles)
            for (const Run& run : scan_convert(t.corners, input_.subpixel_bits(), input_.window()))
                draw(run, t.depth, polygon, painted);
        if (!log_.on() || log_.wants(Level::Pixel) || compared_ == before) return;
        const std::int64_t passed = size_of(painted), tested = std::int64_t(compared_ - before);
        log_.add({.action = Action::Draw,
                  .test = "z-buffer",
                  .result = passed == tested ? "all"
                            : passed == 0    ? "none"
                                             : "some",
                  .pieces = {name_of(polygon)},
                  .values = {{"passed", passed}, {"tested", tested}},
                  .decisive = passed < tested,
                  .painted = std::move(painted)});
    }

private:
    void draw(const Run& run, const DepthPlane& depth, const Polygon& polygon,
              std::vector<Painted>& painted) {
        DepthWalk walk(depth, run.x0, run.y);
        for (int x = run.x0; x < run.x1; ++x, walk.right()) {
            std::int64_t& stored = z_[input_.view.index(x, run.y)];
            const bool passes = walk.z() < stored;
            compared_ += 1;
            if (log_.wants(Level::Pixel)) log_pixel({run.y, x, x + 1}, polygon, walk.z(), stored);
            if (passes) stored = walk.z();
            if (passes) add_run(painted, {run.y, x, x + 1}, polygon.id);
        }
    }

    void log_pixel(const Run& run, const Polygon& polygon, std::int64_t z, std::int64_t stored) {
        const bool passes = z < stored;
        Step step{.level = Level::Pixel,
                  .action = passes ? Action::Draw : Action::Compare,
                  .test = "z",
                  .result = passes ? "nearer" : "not-nearer",
                  .pieces = {name_of(polygon)},
                  .values = {{"z", z}, {"Z", stored}},
                  .decisive = !passes,
                  .window = pixels_of(run)};
        if (passes) step.painted = {{run, polygon.id}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    std::vector<std::int64_t> z_;
    std::uint64_t compared_ = 0;
};

Output run(const Input& input, StepLog& log) {
    Output output{.list = scene::id_pass(input.scene, input.view, {.name = "Z-buffer"})};
    Buffers buffers(input, log);
    log.watch({{"depths", &buffers.compared()}});
    for (const Polygon& polygon : input.polygons) buffers.draw(polygon);
    log.watch({});
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
