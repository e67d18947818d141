#include "apps/hidden/quiz/quiz_files.h"

#include <fmt/format.h>

namespace gw::apps {

std::string mtl_of(const scene::Scene& scene) {
    std::string text;
    for (const scene::Material& m : scene.materials)
        text += fmt::format("newmtl {0}\nKa {1:.9g} {2:.9g} {3:.9g}\nKd {1:.9g} {2:.9g} {3:.9g}\n",
                            m.name, m.Kd.x, m.Kd.y, m.Kd.z);
    return text;
}

std::string obj_of(const scene::Scene& scene, const std::string& mtl) {
    std::string text = "mtllib " + mtl + "\n";
    for (const scene::Object& object : scene.objects) {
        const auto& corners = object.mesh->data().positions;
        text += "o " + object.name + "\nusemtl " + scene.materials[object.material].name + "\n";
        for (const vec3& p : corners)
            text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        text += "f";
        for (std::size_t k = 0; k < corners.size(); ++k)
            text += fmt::format(" -{}", corners.size() - k);
        text += "\n";
    }
    return text;
}

std::string toml_of(const hiddensurface::Question& question, const std::string& obj) {
    const scene::Camera& c = *question.scene.camera;
    const vec3& b = question.scene.background;
    std::string text = fmt::format(
        "background = [{:.9g}, {:.9g}, {:.9g}]\n\n[camera]\neye = [{}, {}, {}]\nat = [{}, {}, "
        "{}]\n",
        b.x, b.y, b.z, c.eye.x, c.eye.y, c.eye.z, c.at.x, c.at.y, c.at.z);
    text += c.ortho_height > 0 ? fmt::format("ortho = {}\n", c.ortho_height)
                               : fmt::format("fov = {}\n", c.fov);
    return text +
           "\n[[light]]\ndirection = [-0.4, -0.5, -0.8]\nIa = 0.4\nId = 0.6\n\n[[object]]\nfile "
           "= \"" +
           obj + "\"\n";
}

}  // namespace gw::apps
