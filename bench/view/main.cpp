// Pictures a second of gw view: a scene orbited at its own size, with everything, and with each step
// of less work that motion may ask for. Usage: bench_view [SCENE [PICTURES]].
#include "apps/view/frame_drawer.h"
#include "apps/view/orbit.h"
#include "apps/view/viewed_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

int main(int count, char** arguments) {
    using namespace gw::apps;
    PictureOptions options{{.scene = count > 1 ? arguments[1] : GW_SOURCE_DIR "/scenes/fig9.toml"}};
    const int pictures = count > 2 ? std::atoi(arguments[2]) : 40;
    Session session;
    ViewedScene scene = load_viewed_scene(options, ".", session);
    const Settings first{.picture = options, .camera = *scene.scene.camera};
    FrameDrawer drawer(scene.scene, scene.passes, scene.profiles);
    fmt::print("{} at {}x{}, {} pictures each, a degree apart\n", options.scene.string(),
               options.size.width, options.size.height, pictures);
    for (const LessWork& step : less_work(first)) {
        Settings settings = step.settings;
        drawer.draw(settings);  // makes what no view changes
        std::vector<double> seconds;
        for (int i = 0; i < pictures; ++i) {
            settings.camera = orbited(settings.camera, 1, 0);
            const Frame frame = drawer.draw(settings);
            if (!frame.fault.empty()) fmt::print("{}\n", frame.fault);
            seconds.push_back(frame.seconds);
        }
        std::sort(seconds.begin(), seconds.end());
        const double median = seconds[seconds.size() / 2];
        fmt::print("{:<24} median {:7.1f} ms, {:5.1f} pictures a second; slowest {:7.1f} ms\n",
                   step.left_out.empty() ? "whole" : step.left_out, median * 1000, 1 / median,
                   seconds.back() * 1000);
    }
}
