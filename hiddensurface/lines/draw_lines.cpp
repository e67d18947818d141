#include "hiddensurface/lines/draw_lines.h"

#include "hiddensurface/interface/styles.h"

namespace gw::hiddensurface {
namespace {

std::vector<bool> lit_pixels(Machine& machine, const CommandList& list) {
    machine.execute(list);
    std::vector<bool> lit;
    for (const Rgba& color : machine.planes().color) lit.push_back(color[0] > 0);
    return lit;
}

/// The number of pixels of `of` with none of `others` in the square of 3 x 3 around.
std::uint64_t alone(const std::vector<bool>& of, const std::vector<bool>& others, int width,
                    int height) {
    const auto near = [&](int x, int y) {
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                if (i >= 0 && j >= 0 && i < width && j < height &&
                    others[std::size_t(j * width + i)])
                    return true;
        return false;
    };
    std::uint64_t count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            count += of[std::size_t(y * width + x)] && !near(x, y) ? 1 : 0;
    return count;
}

}  // namespace

CommandList draw_lines(const Input& input, const std::string& name,
                       const std::vector<Line>& lines) {
    CommandList list = begin_picture(input, name);
    const double unit = double(1 << input.subpixel_bits());
    const auto in_clip = [&](const dvec3& p) {
        return vec3(float(2 * p.x / (unit * input.view.width) - 1),
                    float(2 * p.y / (unit * input.view.height) - 1), 0);
    };
    MeshData data{.primitive = Primitive::Lines};
    for (const Line& line : lines)
        for (const auto& [from, to] : line.visible)
            for (const double t : {from, to})
                data.positions.push_back(in_clip(line.a + t * (line.b - line.a)));
    if (!data.positions.empty()) list.add(Draw{.mesh = make_mesh(std::move(data))});
    return list;
}

LineResult run_on(Machine& machine, const LineAlgorithm& algorithm, const Input& input,
                  StepLog& log) {
    LineOutput output = algorithm.run(input, log);
    log.watch({});
    LineResult result{
        .counts = output.counts, .lines = std::move(output.lines), .lit = {}, .z_buffer = {}};
    result.lit = lit_pixels(machine, draw_lines(input, algorithm.name, result.lines));
    result.z_buffer = lit_pixels(machine, hidden_lines(input.scene, input.view, input.profile));
    for (const bool lit : result.lit) result.counts.pixels += lit ? 1 : 0;
    result.counts.missing = alone(result.z_buffer, result.lit, input.view.width, input.view.height);
    result.counts.extra = alone(result.lit, result.z_buffer, input.view.width, input.view.height);
    return result;
}

}  // namespace gw::hiddensurface
