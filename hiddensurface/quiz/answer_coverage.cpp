#include "hiddensurface/quiz/answer_coverage.h"

namespace gw::hiddensurface {

std::vector<std::vector<std::uint32_t>> polygons_over(const Input& input) {
    const auto width = std::size_t(input.view.width);
    std::vector<std::vector<std::uint32_t>> over(width * std::size_t(input.view.height));
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const Polygon& polygon = input.polygons[i];
        for (const Run& run :
             runs_of(whole(i, polygon), polygon, input.subpixel_bits(), input.window()))
            for (int x = run.x0; x < run.x1; ++x)
                over[std::size_t(run.y) * width + std::size_t(x)].push_back(polygon.id);
    }
    return over;
}

}  // namespace gw::hiddensurface
