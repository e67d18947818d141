// Passes against rays over sweeps of one scene [K4f], row by row, as gw study passes has them.
#include "inspect/report/prices.h"
#include "render/study/sweeps.h"
#include "render/words/option_values.h"
#include "web/engine/method.h"

namespace gw::lab {
namespace {

Json json_of(const report::Interval& i, const report::PriceList& list) {
    return {{"list", list.name}, {"value", i.value}, {"low", i.low}, {"high", i.high}};
}

report::PictureWork work_of(const render::Cost& cost) { return {cost.passes, cost.rays}; }

Json json_of(const render::Cost& cost) {
    const raytrace::RayCounts& rays = cost.rays;
    Json estimates = Json::array();
    for (const report::PriceList& list : report::built_in_prices())
        estimates.push_back(json_of(report::seconds_interval(work_of(cost), list), list));
    return {{"name", cost.method},
            {"passes", cost.passes.size()},
            {"fragments", cost.sum().fragments},
            {"rays", rays.primary + rays.reflected + rays.transmitted + rays.shadow},
            {"seconds", cost.median()},
            {"estimates", estimates}};
}

}  // namespace

Json LabSession::sweeps(const Json& options) {
    const render::Drawing drawing = drawing_of(options);
    Json sweeps = Json::array();
    for (const render::Sweep& sweep : render::sweeps())
        sweeps.push_back({{"name", sweep.name},
                          {"values", sweep.values},
                          {"log", sweep.log},
                          {"refusal", sweep.refusal(drawing)}});
    return {{"sweeps", sweeps}};
}

Json LabSession::sweep_row(const Json& options) {
    const render::Sweep& sweep = render::sweep_named(options.at("sweep").get<std::string>());
    const int value = options.at("value");
    render::whole_number_from("sweep " + sweep.name, std::to_string(value), sweep.low, sweep.high);
    const render::Drawing drawing = drawing_of(options);
    if (const std::string why = sweep.refusal(drawing); !why.empty())
        throw Error("sweep " + sweep.name + ": " + why);
    const render::StudyRow row =
        render::measured(sweep, value, drawing, 1, [](const std::string&) {});
    Json methods = Json::array(), gains = Json::array();
    for (const render::Cost& cost : row.costs) methods.push_back(json_of(cost));
    for (const report::PriceList& list : report::built_in_prices())
        gains.push_back(json_of(report::ratio_interval(work_of(row.cost("ray-tracing")),
                                                       work_of(row.cost("item-buffer")), list),
                                list));
    return {{"x", row.x}, {"share", row.share()}, {"methods", methods}, {"gains", gains}};
}

const Method study_methods[] = {
    {"sweeps", &LabSession::sweeps},
    {"sweep_row", &LabSession::sweep_row},
};

}  // namespace gw::lab
