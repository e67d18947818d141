// Silences stderr while the picture libraries run: libpng and others print what OpenImageIO reports
// as well. Redirects the descriptor of the whole process, so what other threads print is lost too.
#pragma once

namespace gw::image::oiio {

class SilenceStderr {
public:
    SilenceStderr();
    ~SilenceStderr();
    SilenceStderr(const SilenceStderr&) = delete;
    SilenceStderr& operator=(const SilenceStderr&) = delete;

private:
    int kept_ = -1;
};

}  // namespace gw::image::oiio
