#include "scene/obj/obj_builder.h"

namespace gw::scene {

void ObjBuilder::set_object(std::string_view name) {
    object_ = name;
    group_.clear();
    part_primitive_.reset();
}

void ObjBuilder::set_group(std::string_view name) {
    group_ = name;
    part_primitive_.reset();
}

void ObjBuilder::set_material(std::string_view name, int line) {
    material_ = name;
    material_line_ = line;
    part_primitive_.reset();
}

std::uint32_t ObjBuilder::part_of(Primitive primitive) {
    if (part_primitive_ == primitive) return part_;
    part_primitive_ = primitive;
    const std::string& name = group_.empty() ? object_ : group_;
    const auto next = static_cast<std::uint32_t>(obj.parts.size());
    const auto [found, is_new] = parts_.try_emplace({name, material_, primitive}, next);
    if (is_new) obj.parts.push_back({name, material_, material_line_, primitive});
    return part_ = found->second;
}

void ObjBuilder::add(Primitive primitive, std::size_t first, std::uint32_t count, int line) {
    const std::uint32_t index = part_of(primitive);
    obj.parts[index].elements += 1;
    obj.parts[index].corners += count;
    obj.elements.push_back({static_cast<std::uint32_t>(first), count, index, smoothing, line});
}

void ObjBuilder::add_face(std::uint32_t corners, int line) {
    add(Primitive::Polygons, obj.corners.size() - corners, corners, line);
}

void ObjBuilder::add_segments(std::uint32_t corners, int line) {
    const std::vector<Corner> run(obj.corners.end() - corners, obj.corners.end());
    obj.corners.resize(obj.corners.size() - corners);
    for (std::size_t i = 1; i < run.size(); ++i) {
        obj.corners.insert(obj.corners.end(), {run[i - 1], run[i]});
        add(Primitive::Lines, obj.corners.size() - 2, 2, line);
    }
}

void ObjBuilder::add_points(std::uint32_t corners, int line) {
    for (std::size_t i = obj.corners.size() - corners; i < obj.corners.size(); ++i)
        add(Primitive::Points, i, 1, line);
}

}  // namespace gw::scene
