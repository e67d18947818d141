// Rules that join several values of a scene, beside the limits of each (limits.h). Does not say
// where a value is from: readers of files know its line, check.h its object.
#pragma once

#include "scene/validate/limits.h"

#include <optional>
#include <string>

namespace gw::scene {

/// A value that no scene may have: its field `is` this; `expected` something else.
struct Fault {
    FieldName field;
    std::string is, expected;
};

/// The first fault; none: the value is allowed.
std::optional<Fault> fault_of(const Camera& camera);
std::optional<Fault> fault_of(const Fog& fog);
std::optional<Fault> fault_of(const AreaLight& area);
std::optional<Fault> fault_of(const Light& light);  ///< not of its area
std::optional<Fault> fault_of(const PixmapChoice& pixmap);
/// An object's matrix.
std::optional<Fault> fault_of(const dmat4& world_from_object);

}  // namespace gw::scene
