// Progressive refinement [F1c]: the patch with the most unshot energy shoots, step by step.
//
//     Solver solver(make_model(scene), {.form_factors = {.hemicube = 256}});
//     while (books(solver.model(), solver.solution()).unshot_share() > 0.01) solver.shoot();
//
// Does not draw pictures (display.h) and does not save (saved.h). docs/radiosity.md has a worked
// example.
#pragma once

#include "radiosity/hemicube/form_factors.h"
#include "radiosity/model/figures.h"
#include "radiosity/solver/rows.h"
#include "radiosity/solver/solution.h"

#include <cmath>
#include <memory>
#include <optional>

namespace gw::radiosity {

/// The size of a flux, by which shots are chosen: the sum of its channels' absolute values.
inline double magnitude(const dvec3& flux) {
    return (std::abs(flux.x) + std::abs(flux.y)) + std::abs(flux.z);
}

struct SolverOptions {
    FormFactorOptions form_factors;
    /// bytes of form factors that are kept for later shots
    std::size_t row_memory = std::size_t{512} << 20;
};

/// The record of one shot.
struct Shot {
    std::size_t patch = 0;
    dvec3 flux{0};
    int hemicubes = 0;  ///< drawn; 0: the form factors were known
};

/// The work of an update (update.cpp).
struct Update {
    int hemicubes = 0;
    std::size_t patches = 0;  ///< whose light was taken back and sent anew
    /// the solution began again, because sending the difference would take more hemicubes
    bool anew = false;
};

class Solver {
public:
    /// Throws Error if an option is out of range, or nothing emits.
    explicit Solver(PixmapModel model, const SolverOptions& options = {});
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// One shot; none if nothing is unshot. Throws FormFactors::Canceled, and nothing has changed
    /// then.
    std::optional<Shot> shoot();

    const PixmapModel& model() const { return *model_; }
    const Solution& solution() const { return solution_; }
    /// Continues another one, of the same model. Throws Error if its arrays have other lengths.
    void resume(Solution solution);

    /// From now on, every shot also sends the light of these solutions of the same model, with the
    /// same form factors: parts of the whole, as the light of one lamp (shares.h). resume and update
    /// end it. Throws Error if their arrays have other lengths.
    void follow(std::vector<Solution> parts);
    const std::vector<Solution>& parts() const { return parts_; }

    /// From now on draws form factors together with other processes, which have the same model,
    /// options and light and make the same calls. All get the bits of one process.
    void draw_with(std::shared_ptr<RowExchange> others) { exchange_ = std::move(others); }

    /// The patch that is next, and its unshot flux.
    std::pair<std::size_t, dvec3> brightest() const;

    /// Goes on with a model in which emitters were dimmed or recoloured, reflectances changed or
    /// figures moved: only the difference is shot [F4]. The pixmaps must be the same in number and
    /// size. After a move the light of a patch is sent anew if it met the moved figure. Patches
    /// whose part in this is, all together, below `tolerance` of the emitted energy are left as
    /// they are. The solution begins again if that draws about as many hemicubes as all lit patches
    /// do, or if a large difference would be sent with form factors that are not kept.
    /// Throws Error for another scene or one in which nothing emits. Throws Canceled as shoot does;
    /// then the model is the new one, and some light is still where it fell before.
    Update update(PixmapModel model, double tolerance = 0.002);

private:
    /// The rows are drawn if they are not kept, and valid until the next call.
    const PatchRows& rows_of(std::size_t patch, int* drawn);
    DrawnRows draw(std::size_t patch);
    void draw_together(std::size_t patch);
    void send(std::size_t patch, const dvec3& flux, const PatchRows& rows, Solution& solution);
    std::vector<dvec3> light_of_quarters(std::size_t patch, const Solution& solution) const;
    void add_light(const PatchRows& rows, const std::vector<dvec3>& light, Solution& solution);
    void receive(Solution& solution);
    dvec3 unshot_flux(const Patch& patch, const Solution& solution) const;
    dvec3 shot_flux(const Patch& patch) const;
    void change_materials(const PixmapModel& to);
    bool is_less_to_begin_again(double least) const;

    struct Affected;
    Update move(PixmapModel to, double tolerance);
    std::vector<Affected> affected_by(const PixmapModel& to) const;
    static void keep_largest(std::vector<Affected>& affected, double least);
    std::size_t hemicubes_of(const PixmapModel& model, std::size_t patch) const;
    std::size_t hemicubes_to_send(const std::vector<Affected>& affected,
                                  const PixmapModel& to) const;
    Update begin_again(PixmapModel to);
    void send_anew(const std::vector<Affected>& affected, FormFactors& next, Rows& kept,
                   Update& done);

    std::unique_ptr<PixmapModel> model_;  ///< does not move in memory: form_factors_ refers to it
    SolverOptions options_;
    std::unique_ptr<FormFactors> form_factors_;
    Solution solution_;
    std::vector<Solution> parts_;  ///< that follow
    Rows rows_;
    PatchRows drawn_;                        ///< the last rows that were not kept yet
    std::shared_ptr<RowExchange> exchange_;  ///< null: alone
    std::vector<dvec3> incoming_;            ///< flux to each element, in the shot in progress
};

}  // namespace gw::radiosity
