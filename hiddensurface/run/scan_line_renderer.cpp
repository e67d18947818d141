#include "hiddensurface/run/scan_line_renderer.h"

#include "gw/base/arithmetic.h"
#include "hiddensurface/model/surface.h"
#include "hiddensurface/structures/visible_spans.h"
#include "scene/draw/draw_commands.h"

namespace gw::hiddensurface {
namespace {

class Shader {
public:
    Shader(const Input& input, const JitterState& jitter)
        : input_(input), surfaces_(input.scene, input.view) {
        const double unit = 1.0 / double(1 << input.subpixel_bits());
        center_ = dvec2(0.5) - dvec2(jitter.x, jitter.y) * unit;
        for (const scene::Object& object : input.scene.objects) {
            lights_.emplace_back();
            for (const scene::Light& light : input.scene.lights)
                if (scene::lights_object(light, object))
                    lights_.back().push_back(scene::eye_light(light, input.view));
        }
    }

    Rgba color(const VisibleSpan& span, int x) const {
        const Polygon& polygon = input_.polygons[span.polygon];
        const WindowTriangle& triangle = polygon.triangles[span.triangle];
        const scene::Object& object = input_.scene.objects[polygon.object];
        const scene::SurfacePoint point = surfaces_.at(
            polygon.object, triangle.source, dvec2(x, span.run.y) + center_, is_front(triangle));
        const dvec3 sum = scene::shade(input_.scene.materials.at(object.material),
                                       lights_[polygon.object], point);
        const auto store = [this](double v) {
            return static_cast<std::uint16_t>(quantize(v, input_.profile.color_bits));
        };
        return {store(sum.x), store(sum.y), store(sum.z), store(1)};
    }

private:
    const Input& input_;
    Surfaces surfaces_;
    dvec2 center_;                                ///< of pixel 0, 0 in the unjittered window
    std::vector<std::vector<gw::Light>> lights_;  ///< of each object
};

void add_line(CommandList& list, const Shader& shader, const std::vector<VisibleSpan>& line) {
    WriteSpans command;
    for (const VisibleSpan& span : line) {
        command.spans.push_back({.x = span.run.x0,
                                 .y = span.run.y,
                                 .length = span.run.x1 - span.run.x0,
                                 .first = static_cast<std::uint32_t>(command.colors.size()),
                                 .flat = false});
        for (int x = span.run.x0; x < span.run.x1; ++x)
            command.colors.push_back(shader.color(span, x));
    }
    if (!line.empty()) list.add(std::move(command));
}

}  // namespace

CommandList scan_line_picture(const scene::Scene& scene, const scene::View& view,
                              const Profile& profile, const JitterState& jitter) {
    const Input input{scene, view, profile, project(scene, view, profile, jitter)};
    CommandList list = begin_picture(input, "scan-line, eq. 3");
    std::get<Clear>(list.commands.back()).color = vec4(scene.background, 1);
    const Shader shader(input, jitter);
    Counts counts;
    StepLog none;
    for_visible_spans(input, counts, none,
                      [&](const std::vector<VisibleSpan>& line) { add_line(list, shader, line); });
    return list;
}

}  // namespace gw::hiddensurface
