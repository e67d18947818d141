// The options of gw radiosity. Does not solve.
#pragma once

#include "apps/picture/picture_options.h"
#include "apps/radiosity/ranks.h"
#include "radiosity/model/changes.h"
#include "radiosity/solver/solver.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

class Progress;

using radiosity::Change;

/// Throws UsageError with the expected form.
Change change_from(const std::string& word);

/// How many times as strong a lamp is, by channel.
struct Strength {
    std::string lamp;
    dvec3 factor{1};
};

/// "lamp=0.5" or "lamp=1,0.5,0.2". Throws UsageError with the expected form.
Strength strength_from(const std::string& word);

struct RadiosityOptions {
    PictureOptions picture{{.size = {512, 512}, .profile = "ideal"}};
    std::filesystem::path output;
    radiosity::ModelOptions model;
    radiosity::SolverOptions solver;
    int shots = -1;       ///< in total; -1: as many as `until` takes
    double until = 1e-4;  ///< the unshot share that ends shooting
    int every = 0;        ///< a picture after each `every` shots; 0: none
    bool save = false, resume = false, record = false;
    Rank rank;                        ///< this process of several; only the first one writes
    std::string display = "texture";  ///< texture, strips or both
    std::vector<std::pair<dvec3, dvec3>> views;  ///< eye, at; none: the camera
    double exposure = 0, gamma = 1;
    bool no_ambient = false, specular = false;
    bool units = false;         ///< also writes each view in radiosity units and in false colours
    bool lux = false;           ///< also writes the illuminance in each view
    std::vector<dvec3> lux_at;  ///< points whose illuminance is printed
    double rgbm = 0;            ///< above 0: light maps also as RGBM of this range
    bool light_maps = false;    ///< also writes the solution for other programs
    std::vector<std::string> form_factor;  ///< two names, or none
    std::vector<Change> changes;           ///< of the solved scene
    bool anew = false;                     ///< also solves the changed scene anew
    bool shares = false;                   ///< keeps the light of each lamp apart
    std::vector<Strength> mix;             ///< shows shares of DIR in these strengths; none: solves
};

/// Adds SCENE and all options. Parsing checks the words.
void add_radiosity_options(CLI::App& command, RadiosityOptions& options);

/// Throws UsageError if options exclude each other.
void check(const RadiosityOptions& options);

/// Prints the form factors between two figures. Throws Error for a name that no figure has
/// (form_factor.cpp).
void print_form_factor(const RadiosityOptions& options, const radiosity::PixmapModel& model,
                       Progress& progress);

}  // namespace gw::apps
