#include "scene/draw/components.h"

namespace gw::scene {

std::string_view name_of(Component component) {
    switch (component) {
        case Component::Ambient: return "ambient";
        case Component::Diffuse: return "diffuse";
        case Component::Specular: return "specular";
        case Component::Reflection: return "reflection";
        case Component::Refraction: return "refraction";
        case Component::Emission: return "emission";
    }
    return "";
}

vec3 coefficient(const Material& material, Component component) {
    switch (component) {
        case Component::Ambient: return material.Ka;
        case Component::Diffuse: return material.Kd;
        case Component::Specular: return material.Ks;
        case Component::Reflection: return material.Ks;
        case Component::Refraction: return material.Tf;
        case Component::Emission: return material.Ke;
    }
    return vec3(0);
}

std::span<const Map> maps(const Material& material, Component component) {
    switch (component) {
        case Component::Ambient: return material.map_Ka.empty() ? material.map_Kd : material.map_Ka;
        case Component::Diffuse: return material.map_Kd;
        case Component::Specular: return material.map_Ks;
        case Component::Reflection: return material.refl;
        case Component::Refraction: return material.refraction;
        case Component::Emission: return material.map_Ke;
    }
    return {};
}

bool has_component(const Material& material, Component component) {
    const bool by_map = component == Component::Reflection || component == Component::Refraction;
    return coefficient(material, component) != vec3(0) &&
           !(by_map && maps(material, component).empty());
}

const Map* hardware_map(const Material& material) {
    for (const auto* list :
         {&material.map_Kd, &material.map_Ka, &material.map_Ks, &material.map_Ke})
        if (!list->empty()) return &list->front();
    return nullptr;
}

}  // namespace gw::scene
