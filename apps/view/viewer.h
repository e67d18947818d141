// The state of gw view: the user's choices, and the work that they ask for. Drawing runs beside it,
// so that it always answers. Knows no window: inputs go in, a screen comes out.
#pragma once

#include "apps/view/frame_drawer.h"
#include "apps/view/light_drawer.h"
#include "apps/view/screen.h"
#include "apps/view/viewed_scene.h"
#include "apps/view/window.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

class Viewer {
public:
    enum class Show { Picture, Passes, Hidden, Light };

    Viewer(ViewedScene scene, Settings settings);
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;
    ~Viewer();

    void handle(const Input& input);
    /// Takes finished work and begins the next. True if the screen has changed.
    bool advance();
    /// Until there is nothing to do. Light that still shoots counts as work.
    void settle();
    image::Picture screen() const;
    bool is_finished() const { return is_finished_; }
    /// Whether a picture is being drawn or light being computed.
    bool is_busy() const;

    const Settings& settings() const { return settings_; }
    const Frame& frame() const { return frame_; }
    Show show() const { return show_; }
    const std::string& message() const { return message_; }
    std::optional<Light> light() const;

    /// A key, its text for the help, and its effect.
    struct Key {
        const char* key;
        const char* help;  ///< "": the next key's text has it too
        void (Viewer::*press)();
    };
    static const std::vector<Key>& keys();

private:
    using Clock = std::chrono::steady_clock;
    struct FrameRequest {
        std::string key;
        std::size_t less = 0;  ///< index of less_work
    };
    FrameRequest requested() const;
    std::size_t less_while_moving() const;
    bool is_moving() const;
    void begin(const FrameRequest& request);
    void take(Frame frame);
    void take_history();
    void moved();
    void say(std::string text);

    // Keys.
    void step_renderer(int by);
    void next_renderer() { step_renderer(1); }
    void previous_renderer() { step_renderer(-1); }
    void next_profile();
    void more_samples();
    void fewer_samples();
    void next_shadow();
    void next_reflections();
    void next_translucency();
    void deeper();
    void less_deep();
    void toggle_fog();
    void toggle_light(std::size_t place);
    void toggle_passes();
    void step_pass(int by);
    void next_pass() { step_pass(1); }
    void previous_pass() { step_pass(-1); }
    void next_plane();
    void step_algorithm(int by);
    void next_algorithm() { step_algorithm(1); }
    void previous_algorithm() { step_algorithm(-1); }
    void show_history();
    void toggle_radiosity();
    void toggle_shooting();
    void shoot_once();
    void dim();
    void brighten();
    void dim_by(double factor);
    void brighter_picture() { exposure_ += 0.5; }
    void darker_picture() { exposure_ -= 0.5; }
    void turn_left() { turn(-5, 0); }
    void turn_right() { turn(5, 0); }
    void turn_up() { turn(0, 5); }
    void turn_down() { turn(0, -5); }
    void turn(double right, double above);
    void nearer();
    void farther();
    void first_view();
    void save_view();
    void save_picture() { is_picture_wanted_ = true; }
    void toggle_help() { is_help_shown_ = !is_help_shown_; }
    void finish() { is_finished_ = true; }

    // Mouse.
    void press(const Input& input);
    void drag(const Input& input);
    void release(const Input& input);
    bool is_in_picture(int x, int y) const;
    scene::View view() const;
    void grasp_figure(const Input& input);
    dvec3 grasped_by(const Input& input) const;

    // Panel.
    std::vector<PanelLine> panel() const;
    void add_settings(std::vector<PanelLine>& lines) const;
    void add_passes(std::vector<PanelLine>& lines) const;
    void add_light(std::vector<PanelLine>& lines) const;
    void add_help(std::vector<PanelLine>& lines) const;
    image::Picture picture() const;
    std::vector<std::array<int, 4>> grasped_box() const;

    std::filesystem::path free_name(const std::string& extension) const;
    void put_picture_now();

    ViewedScene viewed_;
    Settings settings_;
    const scene::Camera first_camera_;
    FrameDrawer drawer_;
    LightDrawer light_drawer_;  ///< of the work beside
    LightDrawer picker_;
    std::unique_ptr<LightWorker> light_worker_;
    std::vector<Change> changes_;

    Show show_ = Show::Picture;
    std::string algorithm_;
    std::size_t pass_ = 0;
    std::optional<Plane> plane_;  ///< of Show::Passes; none: all four
    double exposure_ = 0;
    bool is_help_shown_ = false, is_shooting_ = true, is_picture_wanted_ = false,
         is_finished_ = false, is_screen_old_ = true;
    std::string message_;

    std::future<Frame> job_;
    FrameRequest job_request_;
    Frame frame_;
    std::string frame_key_;      ///< empty: none
    std::string left_out_;       ///< of the frame, for speed
    std::string costs_of_;       ///< key_of the settings that costs_ belong to
    std::vector<double> costs_;  ///< seconds of each step of less work; 0: not known
    std::future<std::vector<std::vector<std::string>>> history_job_;
    std::vector<std::string> history_;

    struct Grasp {
        int button = 0;  ///< 0: none
        int x = 0, y = 0, first_x = 0, first_y = 0;
        bool pan = false;
        std::string figure{};  ///< that is moved
        dvec3 center{0}, from{0}, by{0};
    } grasp_;
    int mouse_x_ = -1, mouse_y_ = -1;
    Clock::time_point moving_until_{};
};

}  // namespace gw::apps
