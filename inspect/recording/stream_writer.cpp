#include "gw/error.h"
#include "inspect/recording/content.h"
#include "inspect/recording/stream.h"
#include "inspect/recording/stream_format.h"

#include <fmt/format.h>

#include <ostream>

namespace gw::inspect {
namespace {

void put_number(std::ostream& out, std::uint64_t v) {
    for (int shift = 0; shift < 64; shift += 8) out.put(static_cast<char>(v >> shift & 255));
}

void put(std::ostream& out, const PartHead& head) {
    for (const std::uint64_t v : {head.size, head.digest.high, head.digest.low}) put_number(out, v);
}

void check_written(std::ostream& out) {
    out.flush();
    if (!out) throw Error("the recording cannot be written");
}

}  // namespace

StreamWriter::StreamWriter(std::ostream& out, Recording heading)
    : out_(out), heading_(std::move(heading)) {
    heading_.lists.clear();
    out_ << stream_identifier;
    check_written(out_);
}

void StreamWriter::check_is_open(const std::string& window) const {
    if (!windows_.contains(window)) throw Error(fmt::format("window '{}' is not open", window));
}

void StreamWriter::open(const std::string& window, int width, int height) {
    if (window.empty()) throw Error("a window without a name");
    Part part{window, WindowEvent::Open, heading_};
    part.recording.width = width;
    part.recording.height = height;
    write(part);
    windows_.insert(window);
}

void StreamWriter::add(const std::string& window, CommandList list, CallTable calls,
                       std::optional<ColorMap> color_map) {
    check_is_open(window);
    Part part{.window = window};
    part.recording.lists.push_back(std::move(list));
    part.recording.calls.push_back(std::move(calls));
    part.recording.color_maps.push_back(std::move(color_map));
    write(part);
}

void StreamWriter::close(const std::string& window) {
    check_is_open(window);
    write({.window = window, .event = WindowEvent::Close});
    windows_.erase(window);
}

void StreamWriter::write(const Part& part) {
    stored_.begin_part();
    const std::vector<std::uint8_t> bytes = encode_part(part, stored_);
    put(out_, {bytes.size(), digest_of_bytes(bytes)});
    out_.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    check_written(out_);
    ++parts_;
}

void StreamWriter::finish() {
    put(out_, {0, {parts_, 0}});
    check_written(out_);
}

}  // namespace gw::inspect
