// The planes after every pass as pictures in the report's folder: a plane that a pass left
// unchanged is not written again. Does not execute passes.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "inspect/report/report_folder.h"
#include "inspect/shown/color_map.h"

#include <nlohmann/json_fwd.hpp>

#include <map>

namespace gw::report {

/// The machine's planes, and the identifiers of the polygons that its pixels show
/// (inspect/report/pass_observer.h).
struct Snapshot {
    Planes planes;
    std::vector<std::uint32_t> polygons;
    const inspect::ColorMap* map =
        nullptr;  ///< through which a screen shows the colours; null: none
};

class PassPictures {
public:
    /// `start`: before the first pass that is shown. The folder must outlive it.
    PassPictures(ReportFolder& folder, const Profile& profile, Snapshot start);

    /// Writes the pass's changes. The result has members for "color", "depth", "stencil", "accum",
    /// "polygons" and, if asked for, "identifiers": the colours, read as those of an item buffer.
    /// Each has "before" and "after", names of PNG files without the extension. If the pass changed
    /// the plane it also has "change", the number of "pixels" and, for colours, the amplification
    /// "times".
    nlohmann::ordered_json add(std::size_t pass, Snapshot after, bool with_identifiers);

    /// Large pictures have a small one beside them, NAME_small.png.
    bool with_small() const { return reduction_ > 1; }

    /// A plane as it is shown.
    struct Shown;

private:
    nlohmann::ordered_json plane_json(const Shown& shown, std::size_t pass, const Snapshot& after);
    std::string put(const std::string& name, const image::Picture& picture);

    ReportFolder& folder_;
    Profile profile_;
    int reduction_;
    Snapshot last_;
    std::map<std::string, std::string> files_;  ///< of a plane as it is now
};

}  // namespace gw::report
