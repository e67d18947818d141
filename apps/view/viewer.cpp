#include "apps/view/viewer.h"

#include "gw/error.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "inspect/replay/pixel_history.h"
#include "scene/draw/fit.h"

#include <fmt/format.h>

#include <thread>

namespace gw::apps {
namespace {

using namespace std::chrono_literals;

/// A picture that takes longer is drawn with less work while the view moves.
constexpr double slowest_while_moving = 0.25;

template <class T>
bool is_ready(const std::future<T>& future) {
    return future.valid() && future.wait_for(0s) == std::future_status::ready;
}

std::string camera_key(const scene::Camera& c) {
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", c.eye.x, c.eye.y, c.eye.z, c.at.x,
                       c.at.y, c.at.z, c.up.x, c.up.y, c.up.z, c.fov, c.ortho_height);
}

/// Columns apart, a line for each row.
std::vector<std::string> lines_of(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i == widths.size()) widths.push_back(0);
            widths[i] = std::max(widths[i], row[i].size());
        }
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += fmt::format("{:<{}}  ", row[i], widths[i]);
        lines.push_back(line);
    }
    return lines;
}

/// As gw radiosity reads it.
std::string word_of(const Change& c) {
    const std::string value = c.what == "dim"
                                  ? fmt::format("{}", c.value.x)
                                  : fmt::format("{},{},{}", c.value.x, c.value.y, c.value.z);
    return fmt::format("'{}:{}={}'", c.object, c.what, value);
}

}  // namespace

Viewer::Viewer(ViewedScene scene, Settings settings)
    : viewed_(std::move(scene)),
      settings_(std::move(settings)),
      first_camera_(settings_.camera),
      drawer_(viewed_.scene, viewed_.passes, viewed_.profiles),
      light_drawer_(settings_.picture.threads),
      picker_(settings_.picture.threads) {}

Viewer::~Viewer() {
    if (job_.valid()) job_.wait();
    if (history_job_.valid()) history_job_.wait();
}

std::optional<Light> Viewer::light() const {
    if (show_ != Show::Light || !light_worker_) return {};
    return light_worker_->light();
}

bool Viewer::is_moving() const { return grasp_.button != 0 || Clock::now() < moving_until_; }

std::size_t Viewer::less_while_moving() const {
    const std::size_t steps = less_work(settings_).size();
    if (costs_of_ != key_of(settings_)) return 0;
    for (std::size_t i = 0; i < steps && i < costs_.size(); ++i)
        if (costs_[i] <= slowest_while_moving) return i;  // 0: not known, so tried
    return steps - 1;
}

Viewer::FrameRequest Viewer::requested() const {
    std::string key = key_of(settings_) + camera_key(settings_.camera);
    std::size_t less = 0;
    switch (show_) {
        case Show::Picture:
            less = is_moving() ? less_while_moving() : 0;
            key += fmt::format("picture {}", less);
            break;
        case Show::Passes: key += "passes"; break;
        case Show::Hidden: key += algorithm_; break;
        case Show::Light:
            key += fmt::format("light {} {}", light_worker_->light().step, exposure_);
            break;
    }
    return {key, less};
}

void Viewer::begin(const FrameRequest& request) {
    job_request_ = request;
    // The work has a copy of all that inputs may change meanwhile.
    const Light light = light_worker_ ? light_worker_->light() : Light{};
    const scene::View seen = view();
    const auto draw = [this, request, light, seen, show = show_, settings = settings_,
                       algorithm = algorithm_, exposure = exposure_] {
        switch (show) {
            case Show::Passes: return drawer_.draw_by_pass(settings);
            case Show::Hidden: return drawer_.draw_hidden(settings, algorithm);
            case Show::Picture: return drawer_.draw(less_work(settings)[request.less].settings);
            case Show::Light: break;
        }
        Frame frame{.settings = settings};
        const auto start = Clock::now();
        if (light.model)
            frame.picture = light_drawer_.draw(light, seen, viewed_.scene.background, exposure);
        frame.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return frame;
    };
    job_ = std::async(std::launch::async, draw);
}

void Viewer::take(Frame frame) {
    const std::string key = key_of(settings_);
    if (costs_of_ != key) {
        costs_of_ = key;
        costs_.clear();
    }
    const auto steps = less_work(settings_);
    costs_.resize(steps.size());
    if (show_ == Show::Picture && job_request_.less < costs_.size() && frame.by_pass == nullptr)
        costs_[job_request_.less] = frame.seconds;
    left_out_ = job_request_.less < steps.size() ? steps[job_request_.less].left_out : "";
    frame_ = std::move(frame);
    frame_key_ = job_request_.key;
    pass_ = std::min(pass_, frame_.passes.empty() ? 0 : frame_.passes.size() - 1);
    is_screen_old_ = true;
}

void Viewer::take_history() {
    try {
        history_ = lines_of(history_job_.get());
        say("");
    } catch (const Error& error) {
        say(error.what());
    }
}

bool Viewer::advance() {
    if (is_ready(job_)) take(job_.get());
    if (is_ready(history_job_)) take_history();
    const FrameRequest next = requested();
    const bool is_new = next.key != frame_key_;
    if (is_picture_wanted_ && !is_new && !job_.valid()) put_picture_now();
    if (is_new && !job_.valid()) begin(next);
    return std::exchange(is_screen_old_, false);
}

bool Viewer::is_busy() const {
    return job_.valid() || history_job_.valid() || is_picture_wanted_ ||
           requested().key != frame_key_ || (show_ == Show::Light && light_worker_->is_busy());
}

void Viewer::settle() {
    while (is_busy() || is_moving()) {
        advance();
        std::this_thread::sleep_for(1ms);
    }
    advance();
}

void Viewer::moved() {
    moving_until_ = Clock::now() + 300ms;
    history_.clear();
}

void Viewer::say(std::string text) {
    message_ = std::move(text);
    is_screen_old_ = true;
}

scene::View Viewer::view() const {
    scene::Scene seen = viewed_.scene;
    seen.camera = settings_.camera;
    return scene::make_view(seen, settings_.picture.size.width, settings_.picture.size.height);
}

std::filesystem::path Viewer::free_name(const std::string& extension) const {
    const std::string stem = viewed_.file.stem().string();
    for (int number = 1;; ++number) {
        const auto file = viewed_.folder / fmt::format("{}_view_{:03}{}", stem, number, extension);
        if (!std::filesystem::exists(file)) return file;
    }
}

void Viewer::put_picture_now() {
    is_picture_wanted_ = false;
    if (frame_.picture.values.empty()) return say("no picture to save");
    try {
        const auto file = free_name(".png");
        image::OutputSet output(viewed_.inputs);
        image::put_picture(output.add(file), frame_.picture);
        output.commit();
        say("saved " + file.filename().string());
    } catch (const Error& error) {
        say(error.what());
    }
}

void Viewer::save_view() {
    try {
        const auto file = free_name(".toml");
        const auto base = std::filesystem::relative(viewed_.file, viewed_.folder);
        scene::SavedView view = saved(settings_, base);
        view.camera.eye += viewed_.origin;
        view.camera.at += viewed_.origin;
        if (viewed_.has_default_light) {
            scene::Light light = viewed_.scene.lights.at(0);
            if (!view.lights_off.empty()) light.Ia = light.Id = vec3(0);
            view.lights_off.clear();
            view.light = light;
        }
        std::string text = scene::to_toml(view);
        if (show_ == Show::Light) {
            std::string command = fmt::format(
                "# The light: gw radiosity {} -o light --profile ideal --shots {} "
                "--exposure {}",
                file.filename().string(), light_worker_->light().shots_before_changes, exposure_);
            for (const Change& c : changes_) command += " --change " + word_of(c);
            text = command + "\n" + text;
        }
        image::OutputSet output(viewed_.inputs);
        output.add(file).write_text(text);
        output.commit();
        say("saved " + file.filename().string());
    } catch (const Error& error) {
        say(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        say(error.what());
    }
}

}  // namespace gw::apps
