#include "apps/view/light_worker.h"

#include "apps/command/command.h"
#include "gw/error.h"
#include "radiosity/solver/direct_light.h"

#include <fmt/format.h>

namespace gw::apps {

LightWorker::LightWorker(scene::Scene scene, const radiosity::SolverOptions& options)
    : scene_(std::move(scene)), options_(options) {
    options_.form_factors.cancel = &end_;
    thread_ = std::thread([this] { run(); });
}

LightWorker::~LightWorker() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void LightWorker::shoot_until(double share) {
    {
        const std::lock_guard lock(mutex_);
        until_ = share;
    }
    wake_.notify_all();
}

void LightWorker::shoot_once() {
    {
        const std::lock_guard lock(mutex_);
        ++single_shots_;
    }
    wake_.notify_all();
}

void LightWorker::change(const Change& change) {
    {
        const std::lock_guard lock(mutex_);
        changes_.push_back(change);
    }
    wake_.notify_all();
}

Light LightWorker::light() const {
    const std::lock_guard lock(mutex_);
    return light_;
}

bool LightWorker::is_busy() const {
    const std::lock_guard lock(mutex_);
    return is_working_ || has_work();
}

bool LightWorker::has_work() const {
    if (!solver_) return false;
    if (!changes_.empty()) return true;
    return !is_dark_ && (single_shots_ > 0 || light_.unshot > until_);
}

void LightWorker::run() {
    try {
        solver_ = std::make_unique<radiosity::Solver>(
            radiosity::make_lit_model(scene_, {}, options_.form_factors), options_);
        publish("before the first shot", true);
        solve();
    } catch (const radiosity::FormFactors::Canceled&) {
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        light_.fault = error.what();
        ++light_.step;
    }
    const std::lock_guard lock(mutex_);
    is_working_ = false;
}

void LightWorker::solve() {
    while (!end_) {
        std::unique_lock lock(mutex_);
        is_working_ = false;
        wake_.wait(lock, [this] { return end_ || has_work(); });
        if (end_) return;
        is_working_ = true;
        if (changes_.empty()) {
            if (single_shots_ > 0) --single_shots_;
            lock.unlock();
            shoot();
            continue;
        }
        const Change next = changes_.front();
        changes_.pop_front();
        lock.unlock();
        apply_change(next);
    }
}

void LightWorker::shoot() {
    const auto shot = solver_->shoot();
    if (!shot) {
        const std::lock_guard lock(mutex_);
        is_dark_ = true;
        single_shots_ = 0;
        return;
    }
    const auto& model = solver_->model();
    const std::string name = model.pixmaps[model.patches[shot->patch].pixmap].name;
    {
        const std::lock_guard lock(mutex_);
        ++light_.shots;
        if (!is_changed_) light_.shots_before_changes = light_.shots;
        light_.hemicubes += shot->hemicubes;
    }
    publish(fmt::format("shot from {}", name), false);
}

void LightWorker::apply_change(const Change& change) {
    scene::Scene changed = scene_;
    try {
        apply(change, changed);
        const radiosity::Update done =
            solver_->update(radiosity::make_lit_model(changed, {}, options_.form_factors));
        scene_ = std::move(changed);
        is_changed_ = true;
        {
            const std::lock_guard lock(mutex_);
            light_.hemicubes += done.hemicubes;
            light_.fault.clear();
            is_dark_ = false;
        }
        publish(fmt::format("{} of {}: {} hemicubes{}", change.what, change.object, done.hemicubes,
                            done.anew ? ", begun again" : ""),
                true);
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        light_.fault = error.what();
        ++light_.step;
    }
}

void LightWorker::publish(const std::string& last, bool has_new_model) {
    const radiosity::PixmapModel& model = solver_->model();
    const double unshot = radiosity::books(model, solver_->solution()).unshot_share();
    auto colors = std::make_shared<const radiosity::DisplayedPixmaps>(
        radiosity::displayed_pixmaps(model, solver_->solution(), true));
    std::shared_ptr<const radiosity::PixmapModel> copy;
    if (has_new_model) copy = std::make_shared<const radiosity::PixmapModel>(model);
    const std::lock_guard lock(mutex_);
    if (copy) light_.model = std::move(copy);
    light_.colors = std::move(colors);
    light_.unshot = unshot;
    light_.last = last;
    ++light_.step;
}

}  // namespace gw::apps
