// The options of gw radiosity and what they mean together. Does not compute.
#pragma once

#include "apps/radiosity/changes.h"
#include "apps/render/picture_options.h"
#include "radiosity/solver/solver.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

struct RadiosityOptions {
    PictureOptions picture{.size = {512, 512}, .profile = "ideal"};
    std::filesystem::path output;
    radiosity::ModelOptions model;
    radiosity::SolverOptions solver;
    int shots = -1;       ///< in all; -1: until `until`
    double until = 0.01;  ///< unshot share
    int every = 0;        ///< a picture after each so many shots
    bool save = false, resume = false, record = false;
    std::string display = "texture";             ///< texture, strips or both
    std::vector<std::pair<dvec3, dvec3>> views;  ///< eye, at; none: the camera
    double exposure = 0, gamma = 1;
    bool no_ambient = false, specular = false;
    std::vector<std::string> form_factor;  ///< two names, or none
    std::vector<Change> changes;           ///< of the solved scene
    bool anew = false;                     ///< also solve the changed scene anew
};

/// Adds SCENE and all options. Wording is checked while parsing.
void add_radiosity_options(CLI::App& command, RadiosityOptions& options);

/// Throws UsageError where options do not go together.
void check(const RadiosityOptions& options);

}  // namespace gw::apps
