// Draws a viewer's pictures with the papers' figures: passes and their parameter sets, counters,
// estimated time. Knows no window and no keys.
#pragma once

#include "apps/picture/picture_options.h"
#include "apps/view/settings.h"
#include "gw/names.h"
#include "image/picture.h"
#include "inspect/replay/replayed.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

/// A pass that ran.
struct FramePass {
    std::string name;
    std::string set;  ///< the paper's tuple [K3p]; empty for passes that the driver adds
    Counters counters;
    double seconds = 0;  ///< estimated, on a VGX
};

struct Frame {
    Settings settings;
    image::Picture picture;  ///< of the profile's bits, bottom row first; empty: see `fault`
    std::vector<FramePass> passes;
    double seconds = 0;              ///< that drawing took
    std::string fault;               ///< why there is no picture
    std::vector<std::string> notes;  ///< of a hidden-surface algorithm: its title and counts
    /// the planes between passes, if the frame was drawn pass by pass
    std::shared_ptr<inspect::Replayed> by_pass;
};

class FrameDrawer {
public:
    /// `profiles` by the words of --profile.
    FrameDrawer(scene::Scene scene, std::optional<multipass::PassList> own_passes,
                std::map<std::string, Profile> profiles);
    FrameDrawer(const FrameDrawer&) = delete;
    FrameDrawer& operator=(const FrameDrawer&) = delete;
    ~FrameDrawer();

    /// Never throws gw::Error: a Frame has its text.
    Frame draw(const Settings& settings);
    /// The same bits, and the planes after each pass.
    Frame draw_by_pass(const Settings& settings);
    /// A hidden-surface or hidden-line algorithm in place of the renderer [L].
    Frame draw_hidden(const Settings& settings, const std::string& algorithm);

private:
    struct Cache;
    Frame timed(const Settings& settings, const std::function<void(Frame&)>& work);
    Drawing drawing_of(const Settings& settings) const;
    Machine& machine_for(const Settings& settings);
    void add_passes(Frame& frame, const std::map<std::string, std::string>& sets,
                    Machine& machine) const;
    std::string hidden_picture(Machine& machine, const std::string& algorithm,
                               const scene::Scene& scene, Frame& frame) const;

    scene::Scene scene_;
    std::optional<multipass::PassList> own_passes_;
    std::map<std::string, Profile> profiles_;
    std::unique_ptr<Cache> cache_;
};

}  // namespace gw::apps
