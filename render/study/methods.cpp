#include "render/study/methods.h"

#include <algorithm>
#include <ctime>
#include <memory>

namespace gw::render {
namespace {

double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// One method with its machine, ready to draw one view after the other.
class Contender {
public:
    Contender(const Drawing& drawing, const Method& method)
        : drawing_(drawing), machine_(make_machine(drawing.request, drawing.profile)) {
        method.choose(drawing_.request);
        drawing_.pass_list = std::nullopt;
        drawing_.counts = &cost_.rays;
        cost_.method = method.name;
        view_ = drawing_.view();
    }
    Contender(const Contender&) = delete;

    void draw_first() {
        cost_.first_seconds = seconds_of([&] {
            draw_view_ = view_drawer(drawing_, *machine_);
            draw_view_(view_);
        });
        for (const PassReport& pass : machine_->passes()) cost_.passes.push_back(pass.counters);
        cost_.picture = digest(machine_->planes(), Plane::Color);
        cost_.color = machine_->planes().color;
        counted_ = cost_.rays;
    }
    /// From another eye than the last, but so near that no picture changes: nothing kept for this
    /// view serves again.
    void draw_again() {
        view_.eye_from_world[3][0] += 1e-12;
        cost_.seconds.push_back(seconds_of([&] { draw_view_(view_); }));
        machine_->reset_passes();
    }
    Cost take() {
        cost_.rays = counted_;
        return std::move(cost_);
    }

private:
    Cost cost_;
    raytrace::RayCounts counted_;
    Drawing drawing_;
    std::unique_ptr<Machine> machine_;
    scene::View view_;
    std::function<void(const scene::View&)> draw_view_;
};

void trace(Request& request, bool shadow_maps) {
    request.renderer = "multipass";
    request.traced = true;
    request.shadow_maps = shadow_maps;
}

}  // namespace

const std::vector<Method>& methods() {
    static const std::vector<Method> all{
        {"maps", "passes, reflection maps",
         [](Request& request) {
             trace(request, false);
             request.traced = false;
         }},
        {"item-buffer", "item buffer, shadow rays", [](Request& r) { trace(r, false); }},
        {"item-buffer-maps", "item buffer, shadow maps", [](Request& r) { trace(r, true); }},
        {"ray-tracing", "ordinary ray tracing", [](Request& request) {
             trace(request, false);
             request.renderer = "raytrace";
         }}};
    return all;
}

Counters Cost::sum() const {
    Counters all;
    for (const Counters& pass : passes) all += pass;
    return all;
}

double Cost::median() const {
    if (seconds.empty()) return 0;
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
double Cost::least() const {
    return seconds.empty() ? 0 : *std::min_element(seconds.begin(), seconds.end());
}
double Cost::most() const {
    return seconds.empty() ? 0 : *std::max_element(seconds.begin(), seconds.end());
}

std::vector<Cost> costs(const Drawing& drawing, int runs,
                        const std::function<void(const std::string&)>& say) {
    std::vector<std::unique_ptr<Contender>> contenders;
    for (const Method& method : methods()) {
        say(method.about);
        contenders.push_back(std::make_unique<Contender>(drawing, method));
        contenders.back()->draw_first();
    }
    for (int run = 0; run < runs; ++run)
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            say(methods()[i].about + ", run " + std::to_string(run + 1));
            contenders[i]->draw_again();
        }
    std::vector<Cost> all;
    for (const auto& contender : contenders) all.push_back(contender->take());
    return all;
}

}  // namespace gw::render
