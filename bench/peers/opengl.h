// A workload through Mesa's OpenGL 1.1, as fast as we know how: vertices in buffers or display
// lists, fixed-function lighting, texture coordinate generation and fog. Does not measure.
#pragma once

#include "bench/peers/frame.h"
#include "bench/peers/workload.h"

#include <memory>
#include <string>
#include <vector>

namespace gw::peers {

/// The memory in which the vertices wait for the draws.
enum class Store { Buffers, Lists, Strips };

class OpenGl {
public:
    /// Throws std::runtime_error if OSMesa gives no context. GALLIUM_DRIVER chooses the driver.
    OpenGl(const Frame& frame, Store store);
    ~OpenGl();
    OpenGl(const OpenGl&) = delete;
    OpenGl& operator=(const OpenGl&) = delete;

    /// Draws one frame and waits for it.
    void run(const Workload& workload);
    /// RGBA, 8 bits, rows from the bottom.
    const std::vector<unsigned char>& picture() const;
    std::string renderer() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace gw::peers
