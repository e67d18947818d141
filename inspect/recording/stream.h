// A recording of several windows that is written while it is made, part by part. A window is a
// machine of its own. docs/recordings.md, "Streams". Does not execute.
#pragma once

#include "inspect/recording/part.h"

#include <iosfwd>
#include <set>
#include <string_view>

namespace gw::inspect {

class StreamWriter {
public:
    /// Refers to `out`, which must outlive it. `heading` has everything but size and lists: it is
    /// the same for all windows.
    StreamWriter(std::ostream& out, Recording heading);

    /// A new window. An open window of this name gets the new size, and with it a new machine.
    void open(const std::string& window, int width, int height);
    /// A list that the window's machine executed. It is on the disk when this returns.
    void add(const std::string& window, CommandList list, CallTable calls = {},
             std::optional<ColorMap> color_map = {});
    void close(const std::string& window);
    /// Without this the recording counts as cut short.
    void finish();

    /// Entries in memory: open windows, meshes and maps. They have a bound, whatever was written.
    std::size_t remembered() const { return windows_.size() + stored_.remembered(); }

private:
    void write(const Part& part);
    void check_is_open(const std::string& window) const;

    std::ostream& out_;
    Recording heading_;
    StoredValues stored_;
    std::set<std::string> windows_;
    std::uint64_t parts_ = 0;
};

struct WindowRecording {
    std::string name;  ///< "main"; of later machines under one name "main 2", "main 3"
    Recording recording;
};

/// The recordings of a stream, in the order in which their machines began.
struct Stream {
    std::vector<WindowRecording> windows;
    std::string cut;  ///< why it ends early; empty: it is whole
};

/// Whether a file that begins so is a stream.
bool is_stream(std::string_view beginning);

/// From untrusted bytes. A stream that is cut short gives everything up to its last whole list.
/// Throws Error with the reason for any other defect.
Stream decode_stream(std::istream& in, const Limits& limits = {});

/// The machines of a recording or a stream; of the former one without a name. Throws Error
/// "T.gwt: what is wrong".
Stream read_recordings(const std::filesystem::path& file);

/// The recording of this name or, if there is none, of this number from 0. Empty: the only one.
/// Throws Error that names the windows.
Recording choose_window(Stream stream, const std::string& window);

}  // namespace gw::inspect
