// A question's scene as files that every command reads.
#pragma once

#include "hiddensurface/quiz/quiz.h"

#include <string>

namespace gw::apps {

std::string mtl_of(const scene::Scene& scene);
/// `mtl`: the name of that file.
std::string obj_of(const scene::Scene& scene, const std::string& mtl);
/// `obj`: the name of that file.
std::string toml_of(const hiddensurface::Question& question, const std::string& obj);

}  // namespace gw::apps
