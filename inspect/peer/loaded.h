// The functions of a loaded library. Does not make contexts.
#pragma once

#include "inspect/peer/gl.h"

#include <string>

namespace gw::peer {

/// A loaded library stays loaded: drivers do not survive to be unloaded.
class Loaded {
public:
    /// Throws Error if there is no such library.
    explicit Loaded(std::string path);

    const std::string& path() const { return path_; }
    /// Whether the library exports it. Looking functions up gives an address for any name.
    bool exports(const char* name) const;
    /// The function of this name, as the type that it has. Throws Error if there is none.
    template <typename Function>
    void get(const char* name, Function& out) const {
        out = reinterpret_cast<Function>(address(name));
    }

    /// OpenGL 1.1.
    Functions functions() const;
    /// Adds version, colour buffer and later functions; a context is current. Throws Error if the
    /// planes do not have 8 colour, 24 depth and 8 stencil bits.
    void complete(Functions& functions) const;

private:
    void* find(const char* name) const;
    void* address(const char* name) const;

    std::string path_;
    void* handle_;
};

}  // namespace gw::peer
