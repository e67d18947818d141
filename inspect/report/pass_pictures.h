// The planes after every pass as pictures in the report's folder: what a pass left as it was is not
// written again. Does not execute passes.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "inspect/report/report_folder.h"

#include <nlohmann/json.hpp>

#include <map>

namespace gw::report {

/// The machine's planes, and the identifiers of the polygons that its pixels show
/// (inspect/report/polygon_plane.h).
struct Snapshot {
    Planes planes;
    std::vector<std::uint32_t> polygons;
};

class PassPictures {
public:
    /// `start`: before the first pass that is shown. The folder must outlive it.
    PassPictures(ReportFolder& folder, const Profile& profile, Snapshot start);

    /// Writes what the pass changed. For "color", "depth", "stencil", "accum", "polygons" and,
    /// where wanted, "identifiers" (the colours, read as those of an item buffer): "before" and
    /// "after", names of PNG files without the extension; where the pass changed the plane "change"
    /// too, how many "pixels", and for colours "times", by what the change is amplified.
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
