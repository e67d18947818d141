// Form factors from a patch to all texels, by hemicubes [F2.2]. Knows no energy. The same bits for
// any number of threads: hemicubes are drawn in parallel and pixmaps scanned in parallel. A texel's
// light is summed in the order of the points [F2.2p, F4].
#pragma once

#include "radiosity/hemicube/plane_figure.h"
#include "radiosity/hemicube/scan.h"
#include "radiosity/hemicube/texel_scan.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gw::radiosity {

struct FormFactorOptions {
    int hemicube = 128;  ///< pixels across, even, 8 .. 4096
    ScanOptions scan;
    PointOptions points;
    /// of the turns of the hemicubes about their normals: each has its own
    std::uint64_t seed = 0;
    int threads = 0;                            ///< 0: all
    const std::atomic<bool>* cancel = nullptr;  ///< looked at between hemicubes
    /// Makes a machine of id_profile() for hemicubes of this size; none: the fast one, on one
    /// thread.
    std::function<std::unique_ptr<Machine>(int size)> make_machine;
};

/// Throws Error naming the option that is out of its range.
void check(const FormFactorOptions& options);
/// The points of a patch with these options: near parts need texels in closed form.
PointOptions point_options(const FormFactorOptions& options);

/// The distribution of a patch's (or point's) light. texels + backs + escaped = 1.
struct Row {
    std::vector<std::uint32_t> texels;  ///< elements (PixmapModel) that receive anything, ascending
    std::vector<double> factors;        ///< form factor to each
    double backs = 0;                   ///< to sides of figures that neither emit nor reflect
    double escaped = 0;                 ///< out of the scene
    int hemicubes = 0;

    double sum() const;
};

class FormFactors {
public:
    FormFactors(const PixmapModel& model, const FormFactorOptions& options);

    /// Throws Canceled when asked to stop.
    Row from_patch(std::size_t patch);
    /// Of the patch's quarters; one row if it has none (Shooting). All light goes somewhere in the
    /// mean over the quarters. One alone may add up to a little more or less than 1.
    std::vector<Row> from_quarters(std::size_t patch);
    /// If the quarters send the same light. Each bit is as from_patch's.
    Row combined(const std::vector<Row>& quarters);
    /// From differential elements, each with its share of the whole. `turns`: a number that names
    /// them.
    Row from_points(const std::vector<ShootPoint>& points, std::uint64_t turns);

    /// The hemicube that stands on the point `number` of `points`, with which from_points draws.
    Hemicube hemicube_on(const std::vector<ShootPoint>& points, std::size_t number,
                         std::uint64_t turns) const;

    struct Canceled {};

private:
    /// Memory of a thread.
    struct Scratch {
        std::unique_ptr<HemicubePainter> painter;
        std::vector<double> alone;  ///< factors of one facet
        TexelScratch texels;
        PixelScratch pixels;
    };
    /// A hemicube and the results of its scan.
    struct Slot {
        const NearPart* beside = nullptr;  ///< whose texels are left out
        Hemicube hemicube;
        IdBuffers buffers;
        SeenIds seen;
        std::vector<double>
            factors;                ///< for all texels; those of pixmaps whose sum is 0 are not set
        std::vector<double> sums;   ///< of each pixmap
        std::vector<double> backs;  ///< for each pixmap
        std::vector<double> left_out;  ///< for each pixmap
        double escaped = 0;
    };

    std::vector<Row> from(const Shooting& shooting, std::uint64_t turns);
    void draw(const Shooting& shooting, std::size_t first, std::size_t count, std::uint64_t turns);
    void scan(std::size_t count);
    void scan_pixmap(Slot& slot, std::uint32_t pixmap, Scratch& scratch) const;
    double scan_facet(Slot& slot, std::uint32_t facet, std::span<double> factors,
                      Scratch& scratch) const;
    double scan_beside(Slot& slot, const NearTexels& texels, Scratch& scratch) const;
    void sum(const Shooting& shooting, std::size_t first, std::size_t count,
             std::vector<Row>& rows);
    static bool is_enclosed(const Slot& slot);
    static double divide_among_open(Row& row, double enclosed, std::vector<double>& factors);
    void add_near(const Shooting& shooting, const std::array<double, 4>& grow,
                  std::vector<Row>& rows);
    double scale_of(const Slot& slot) const;

    const PixmapModel& model_;
    FormFactorOptions options_;
    DeltaFormFactors delta_;
    std::vector<std::optional<PlaneFigure>> figures_;  ///< by facet
    Pieces pieces_;                                    ///< of curved figures
    std::vector<std::vector<std::uint32_t>> joined_;   ///< texels that are no elements, by pixmap
    std::vector<Scratch> scratch_;                     ///< one for each thread
    std::vector<Slot> slots_;
    std::array<std::vector<double>, 4> factors_;  ///< of the quarters
    std::array<double, 4> enclosed_{};            ///< shares of their points
};

}  // namespace gw::radiosity
