// A solution as rectangles of float32 values, and back, bit for bit [F4]: pixmaps are resources
// that can be drawn, or computed further, at another time. Does not read or write files.
#pragma once

#include "radiosity/hemicube/form_factors.h"
#include "radiosity/solver/solution.h"

#include <map>
#include <string>

namespace gw::radiosity {

/// One pixmap's texels, bottom row first. Channels: R, G, B (B = E + rho H, to look at), then H and
/// unshot of each channel as head and rest (solution.h, storable).
struct SavedPixmap {
    std::string name;
    int width = 0, height = 0;
    std::vector<float> values;
};
const std::vector<std::string>& saved_channels();

struct Saved {
    /// kind, version, scene, model, objects, method, shots, escaped, backs, contents
    std::map<std::string, std::string> facts;
    std::vector<SavedPixmap> pixmaps;
};

/// Two fingerprints agree if going on gives the same bits: they cover figures, pixmaps and
/// materials, and how form factors are found. Names of objects are compared apart from these: no
/// bit depends on them, but a user's choice of an object does.
std::string fingerprint(const PixmapModel& model);
std::string fingerprint(const FormFactorOptions& options);

inline constexpr const char *whole_kind = "radiosity pixmaps", *share_kind = "radiosity share";

Saved save(const PixmapModel& model, const FormFactorOptions& options, const Solution& solution);
/// For R, G, B, with this emission in place of the model's.
Saved save(const PixmapModel& model, const FormFactorOptions& options, const Solution& solution,
           const std::vector<dvec3>& E);

/// Throws Error that names the difference: another kind of file, version, scene or method, or
/// damaged contents. `file`: for the message.
Solution load(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
              const std::string& file, const char* kind = whole_kind);

/// Throws as `load` does if `saved` was computed for another model. Does not read the values.
void check_saved(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
                 const std::string& file, const char* kind = whole_kind);

}  // namespace gw::radiosity
