// The field of quads through Mesa's OpenGL 1.1, by the methods of its time. Does not measure.
#pragma once

#include "bench/draws/field.h"

#include <memory>
#include <string>

namespace gw::draws {

/// Begin and End for each quad; the same in one display list; an array in a buffer, with a draw for
/// each quad.
enum class Method { Begin, List, Arrays };

class OpenGl {
public:
    /// Throws std::runtime_error if OSMesa gives no context.
    OpenGl();
    ~OpenGl();
    OpenGl(const OpenGl&) = delete;
    OpenGl& operator=(const OpenGl&) = delete;

    /// Gets ready to draw a field; not to be timed.
    void prepare(const std::vector<Quad>& quads, Own own, Method method);
    /// Draws a frame and waits for it.
    void run();
    /// RGBA, 8 bits, rows from the bottom.
    const std::vector<unsigned char>& picture() const;
    std::string renderer() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace gw::draws
