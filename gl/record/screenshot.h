// Keeps the picture of the last frame that was shown: GW_SCREENSHOT names the file.
#pragma once

#include "gl/drawable/frame_log.h"
#include "gl/drawable/settings.h"

#include <string>

namespace gw::gl {

/// Writes after each frame, so that the picture is there however the program ends. It is a PPM
/// (P6); its largest value is that of the profile's colours. It replaces the one before at once.
class Screenshot : public FrameLog {
public:
    Screenshot(std::string file, const FrameRange& frames);

    void open(Drawable&) override {}
    void begin_frame(Drawable&) override {}
    void executed(Drawable&, const Execution&) override {}
    void end_frame(Drawable& drawable) override;
    void close(Drawable&) override {}

private:
    std::string file_;
    FrameRange range_;
    bool failed_ = false;
};

/// The front plane as bytes of a PPM, top row first.
std::string ppm_of(const Planes& planes, int color_bits);

}  // namespace gw::gl
