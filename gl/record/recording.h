// Records what a program draws: GW_RECORD names the file. docs/recordings.md, "Streams".
#pragma once

#include "gl/drawable/frame_log.h"
#include "gl/drawable/settings.h"
#include "gl/record/call_table.h"
#include "gw/profile.h"
#include "inspect/recording/stream.h"

#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace gw::gl {

/// Writes each list before the program goes on. If the disk is full, it says so once and stops;
/// the program does not. A window whose first recorded frame is not its first one begins with its
/// planes, in a pass "before frame 10".
class Recording : public FrameLog {
public:
    /// Throws Error if the file cannot be written.
    Recording(std::string file, const Profile& profile, const FrameRange& frames);
    /// Finishes the file. Says so if no frame is in it.
    ~Recording() override;
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    void open(Drawable& drawable) override;
    void begin_frame(Drawable& drawable) override;
    void executed(Drawable& drawable, const Execution& execution) override;
    void end_frame(Drawable& drawable) override;
    void close(Drawable& drawable) override;

private:
    /// Throws Error if the file cannot be written.
    void check(const char* what);
    /// Carries out `write`, unless the file has failed.
    template <class Write>
    void attempt(Write write);
    void begin_window(Drawable& drawable);
    /// What the drawable has drawn before this frame.
    CommandList drawn_before(Drawable& drawable) const;
    /// How the window shows its colours, if it differs from what the recording has.
    std::optional<inspect::ColorMap> new_color_map(const Drawable& drawable);

    std::string file_;
    FrameRange frames_;
    std::ofstream out_;
    inspect::StreamWriter writer_;
    CallNamer namer_;
    std::set<std::string> windows_;  ///< that are open in the recording
    std::map<std::string, inspect::ColorMap>
        color_maps_;  ///< of windows_, as the recording has them
    bool is_empty_ = true;
    bool failed_ = false;
};

}  // namespace gw::gl
