// Radiosity that goes on while one looks: shots [F1c], changes [F4], and the light after each of
// them, on a thread of its own. Does not draw.
#pragma once

#include "radiosity/display/displayed_pixmaps.h"
#include "radiosity/model/changes.h"
#include "radiosity/solver/solver.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace gw::apps {

using radiosity::Change;

/// The light at one moment. Its model and colours do not change any more.
struct Light {
    std::shared_ptr<const radiosity::PixmapModel> model;
    std::shared_ptr<const radiosity::DisplayedPixmaps> colors;
    int shots = 0, hemicubes = 0;
    int shots_before_changes = 0;  ///< all, as long as nothing was changed
    double unshot = 1;             ///< share of the emitted energy
    std::string last;              ///< about the last shot or change
    std::string fault;             ///< why there is no light, or no change
    std::uint64_t step = 0;        ///< grows with every shot and change
};

class LightWorker {
public:
    /// Begins at once, with no shot.
    LightWorker(scene::Scene scene, const radiosity::SolverOptions& options);
    LightWorker(const LightWorker&) = delete;
    LightWorker& operator=(const LightWorker&) = delete;
    ~LightWorker();

    /// Shoots until `share` is unshot; 1 or more: no further shot.
    void shoot_until(double share);
    void shoot_once();
    /// Goes on with a changed scene, after the shot that is under way.
    void change(const Change& change);

    Light light() const;
    /// Whether a shot or a change is under way or waits.
    bool is_busy() const;

private:
    void run();
    bool has_work() const;
    void solve();
    void shoot();
    void apply_change(const Change& change);
    void publish(const std::string& last, bool has_new_model);

    scene::Scene scene_;
    radiosity::SolverOptions options_;
    std::unique_ptr<radiosity::Solver> solver_;
    bool is_dark_ = false;     ///< nothing is unshot
    bool is_changed_ = false;  ///< the scene is not that which the light began with

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Change> changes_;
    double until_ = 1;
    int single_shots_ = 0;
    bool is_working_ = true;
    std::atomic<bool> end_ = false;
    Light light_;
    std::thread thread_;
};

}  // namespace gw::apps
