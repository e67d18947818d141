// The five ID buffers of a hemicube through Mesa's OpenGL 1.1 and OSMesa. Does not measure.
#pragma once

#include "radiosity/hemicube/hemicube.h"

#include <memory>

namespace gw::bench {

class OpenGlHemicube {
public:
    /// Throws Error if OSMesa gives no context. GALLIUM_DRIVER chooses the driver.
    OpenGlHemicube(const radiosity::PixmapModel& model, int size);
    ~OpenGlHemicube();
    OpenGlHemicube(const OpenGlHemicube&) = delete;
    OpenGlHemicube& operator=(const OpenGlHemicube&) = delete;

    /// Draws the five faces and reads them back: of the sides the half over the horizon, as ours.
    void draw(const radiosity::Hemicube& hemicube);
    /// The pixels of the last face that was read; bytes R, G, B, A are the identifier's.
    const std::vector<unsigned char>& read() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace gw::bench
