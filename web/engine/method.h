// The table of the engine's methods: what the page may ask for by name. A row stands beside its body,
// so a new method is one file. Does not know JavaScript: engine.cpp does.
#pragma once

#include "web/engine/session/lab_session.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace gw::lab {

class Method {
public:
    /// A text reaches the page as the member `text`.
    using Answer = std::variant<Json, std::string>;
    using Body = std::function<Answer(LabSession&, const Json& options)>;
    /// Bytes of the session that come with the answer, as the member `name`.
    struct Plane {
        std::string name;
        const std::vector<std::uint8_t>& (LabSession::*bytes)() const;
    };

    /// Adds the row to the table. The row must live as long as the program.
    Method(std::string name, Body body, std::vector<Plane> planes = {});
    Method(const Method&) = delete;

    const std::string name;
    const Body body;
    const std::vector<Plane> planes;
};

/// Throws Error if there is none.
const Method& method_named(const std::string& name);

}  // namespace gw::lab
