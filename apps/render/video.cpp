#include "apps/render/video.h"

#include "apps/command/limited_run.h"
#include "gw/error.h"
#include "image/output/output_file.h"

#include <fmt/format.h>

#include <limits>

namespace gw::apps {
namespace {

struct VideoKind {
    const char* extension;
    const char* muxer;  ///< ffmpeg's name
};
constexpr VideoKind video_kinds[] = {{".mp4", "mp4"}, {".mkv", "matroska"}, {".webm", "webm"},
                                     {".mov", "mov"}, {".avi", "avi"},      {".gif", "gif"}};

const char* muxer_of(const std::filesystem::path& video) {
    std::string known;
    for (const VideoKind& kind : video_kinds) {
        if (video.extension() == kind.extension) return kind.muxer;
        known += std::string(known.empty() ? "" : ", ") + kind.extension;
    }
    throw UsageError("--video '" + video.string() + "': expected a name with one of " + known);
}

/// ffmpeg's name for all pictures; % begins a number.
std::string pattern_of(const std::filesystem::path& picture) {
    std::string text = "file:";
    const std::string stem = (picture.parent_path() / picture.stem()).string();
    for (const char c : stem) text += c == '%' ? "%%" : std::string(1, c);
    return text + "_%03d" + picture.extension().string();
}

/// A file of 4 GB takes hours.
constexpr double any_time = std::numeric_limits<double>::infinity();

}  // namespace

void check_video(const std::filesystem::path& video) {
    muxer_of(video);
    image::check_target(video);
    try {
        if (run_limited({"ffmpeg", "-version"}, {.seconds = 60, .memory = 0}).code == 0) return;
    } catch (const Error&) {
    }
    throw Error("--video: ffmpeg cannot be run; expected it to be installed");
}

void make_video(const std::filesystem::path& video, const std::filesystem::path& picture,
                std::pair<int, int> first_last, double rate, const Session& session) {
    session.inputs.check(video);
    image::OutputFile output(video);
    const auto [first, last] = first_last;
    const std::filesystem::path& written =
        output.temporary().empty() ? output.real_target() : output.temporary();
    // Most players want 4:2:0, which needs even sides. It ends with this process. Without -xerror it
    // succeeds on a full disk.
    const LimitedRun run = run_limited({"setpriv",
                                        "--pdeathsig",
                                        "KILL",
                                        "ffmpeg",
                                        "-nostdin",
                                        "-v",
                                        "error",
                                        "-xerror",
                                        "-y",
                                        "-framerate",
                                        fmt::format("{}", rate),
                                        "-start_number",
                                        std::to_string(first),
                                        "-i",
                                        pattern_of(picture),
                                        "-frames:v",
                                        std::to_string(last - first + 1),
                                        "-vf",
                                        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                        "-pix_fmt",
                                        "yuv420p",
                                        "-f",
                                        muxer_of(video),
                                        "file:" + written.string()},
                                       {.seconds = any_time, .memory = 0});
    if (run.end != RunEnd::Exited || run.code != 0)
        throw Error(video.string(), 0,
                    fmt::format("is not written: ffmpeg ended with {} {}: {}",
                                run.end == RunEnd::Exited ? "code" : "signal", run.code,
                                run.err.substr(0, run.err.find('\n'))));
    output.commit();
}

}  // namespace gw::apps
