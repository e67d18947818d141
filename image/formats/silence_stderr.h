// Nothing from the picture libraries on stderr: libpng and others print there what OpenImageIO
// reports as well. For the time of a call into OpenImageIO on one thread; whoever else prints
// meanwhile is not heard either.
#pragma once

namespace gw::image::oiio {

class Hush {
public:
    Hush();
    ~Hush();
    Hush(const Hush&) = delete;
    Hush& operator=(const Hush&) = delete;

private:
    int kept_ = -1;
};

}  // namespace gw::image::oiio
