// The state set by OBJ statements (object, group, material, smoothing), and the elements added
// under it. Does not read text.
#pragma once

#include "scene/obj/obj_data.h"

#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

namespace gw::scene {

class ObjBuilder {
public:
    ObjData obj;
    std::int32_t smoothing = smooth_by_angle;

    /// A new `o` ends the group before it.
    void set_object(std::string_view name);
    void set_group(std::string_view name);
    void set_material(std::string_view name, int line);

    /// Of the corners at the end of obj.corners: one face of them all, segments between neighbours,
    /// or single points.
    void add_face(std::uint32_t corners, int line);
    void add_segments(std::uint32_t corners, int line);
    void add_points(std::uint32_t corners, int line);

private:
    std::uint32_t part_of(Primitive primitive);
    void add(Primitive primitive, std::size_t first, std::uint32_t count, int line);

    std::string object_, group_, material_;
    int material_line_ = 0;
    std::map<std::tuple<std::string, std::string, Primitive>, std::uint32_t> parts_;
    std::uint32_t part_ = 0;
    std::optional<Primitive>
        part_primitive_;  ///< of part_; absent after a statement that may change the part
};

}  // namespace gw::scene
