// The study of passes against rays [K4f], row by row.
#include "inspect/report/prices.h"
#include "python/binding/casters.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/warn.h"
#include "python/binding/module.h"
#include "render/options.h"
#include "render/study/sweeps.h"
#include "render/words/option_words.h"
#include "scene/validate/check.h"

#include <pybind11/stl.h>

#include <algorithm>

namespace gw::python {
namespace {

py::dict counts_of(const render::StudyRow& row, const render::Cost& cost) {
    py::dict counts;
    counts["triangles"] = row.triangles;
    counts["passes"] = cost.passes.size();
    const Counters sum = cost.sum();
    for (const CounterName& counter : counter_names()) counts[counter.name] = sum.*counter.count;
    counts["primary"] = cost.rays.primary;
    counts["reflected"] = cost.rays.reflected;
    counts["transmitted"] = cost.rays.transmitted;
    counts["shadow"] = cost.rays.shadow;
    counts["shaded"] = cost.rays.shaded;
    counts["boxes_tested"] = cost.rays.tests.boxes;
    counts["triangles_tested"] = cost.rays.tests.triangles;
    return counts;
}

py::tuple tuple_of(const report::Interval& i) { return py::make_tuple(i.low, i.value, i.high); }

void add_rows(py::list& rows, const render::StudyRow& row,
              const std::vector<report::PriceList>& lists) {
    const auto work = [](const render::Cost& cost) {
        return report::PictureWork{cost.passes, cost.rays};
    };
    for (const render::Cost& cost : row.costs) {
        py::dict out, estimated, gain;
        for (const report::PriceList& list : lists) {
            estimated[py::str(list.name)] = tuple_of(report::seconds_interval(work(cost), list));
            gain[py::str(list.name)] = tuple_of(report::ratio_interval(
                work(row.cost("ray-tracing")), work(row.cost("item-buffer")), list));
        }
        out["sweep"] = row.sweep;
        out["value"] = row.value;
        out["x"] = row.x;
        out["share"] = row.share();
        out["method"] = cost.method;
        out["counts"] = counts_of(row, cost);
        out["picture"] = to_string(cost.picture);
        out["seconds"] = cost.seconds;
        out["estimated"] = estimated;
        out["gain"] = gain;
        rows.append(out);
    }
}

py::list pass_study(const scene::Scene& scene, const std::string& sweep_name,
                    const std::optional<std::vector<int>>& values, int width, int height,
                    const Profile& profile, int depth, int runs, int threads,
                    const std::vector<std::string>& price_files) {
    const render::Sweep& sweep = render::sweep_named(sweep_name);
    render::Request request;
    render::set(request, "size", std::to_string(width) + "x" + std::to_string(height));
    render::set(request, "depth", std::to_string(depth));
    render::set(request, "threads", std::to_string(threads));
    const std::vector<int> wanted = values.value_or(sweep.values);
    for (const int value : wanted)
        render::whole_number_from("sweep " + sweep.name, std::to_string(value), sweep.low,
                                  sweep.high);
    render::whole_number_from("runs", std::to_string(runs), 0, 1000);
    std::vector<report::PriceList> lists;
    for (const std::string& file : price_files) lists.push_back(report::read_prices(file));
    if (lists.empty()) lists = report::built_in_prices();
    scene::check_scene(scene);
    const render::Drawing drawing = render::make_drawing(request, profile, {.scene = scene});
    if (const std::string why = sweep.refusal(drawing); !why.empty())
        throw Error("sweep " + sweep.name + ": " + why);
    warn(render::warnings(drawing));
    py::list rows;
    for (const int value : wanted)
        add_rows(rows, cancelable([&] {
                     return render::measured(sweep, value, drawing, runs,
                                             [](const std::string&) {});
                 }),
                 lists);
    return rows;
}

}  // namespace

void add_pass_study(py::module_& m) {
    m.def("pass_study", &pass_study, py::arg("scene"), py::arg("sweep") = "scene",
          py::arg("values") = py::none(), py::arg("width") = 640, py::arg("height") = 480,
          py::kw_only(), py::arg("profile") = vgx(), py::arg("depth") = 2, py::arg("runs") = 0,
          py::arg("threads") = 1, py::arg("prices") = std::vector<std::string>{},
          "The scene by passes, item buffer and ordinary ray tracing [K4f], as gw study passes has "
          "it: a dict for each method at each value. sweep: scene, lights, samples, share, "
          "polygons, resolution or depth. runs: timed ones; 0: counts and estimates alone. prices: "
          "files of lists instead of those built in; estimates are (low, value, high).");
}

}  // namespace gw::python
