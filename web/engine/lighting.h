// Radiosity [F]: a scene that is solved shot by shot, and changed while it is solved.
// A state is named by its options, so that a link leads to it again:
//   hemicube  pixels across
//   shots     how many have been shot
//   changes   [{"after": shots, "object", "what", "value"}], as `gw radiosity --change` has them
//   resolved  true: the changes are there before the first shot
#pragma once

#include "image/picture.h"
#include "radiosity/solver/solver.h"

#include <nlohmann/json.hpp>

namespace gw::lab {

class Lighting {
public:
    using Json = nlohmann::ordered_json;

    /// Before the first shot.
    Lighting(scene::Scene scene, const Json& options);

    /// One step towards the state: a shot, a change, or back to the beginning. False: the state
    /// cannot be reached from here.
    bool go_on(const Json& options);
    /// What is known of the light now; `more`: whether go_on would do anything.
    Json facts(const Json& options) const;
    /// The hemicube of a point of the patch as a cross, a colour for each facet; bottom row first.
    image::Picture hemicube(std::size_t patch, std::size_t point) const;

    const radiosity::Solver& solver() const { return *solver_; }

private:
    static Json beginning(const Json& options);
    bool is_due(const Json& options) const;
    void change(const Json& change);
    void keep_unshot();
    void rewind();

    scene::Scene scene_;
    Json beginning_, applied_ = Json::array();
    std::unique_ptr<radiosity::Solver> solver_;
    radiosity::Shot last_;
    int shots_ = 0, hemicubes_ = 0;
    bool is_dark_ = false;              ///< nothing is unshot
    std::vector<double> unshot_;        ///< shares: before the first shot, and after every step
    std::vector<std::size_t> changed_;  ///< the steps that were changes
};

}  // namespace gw::lab
