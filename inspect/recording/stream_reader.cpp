// From untrusted bytes to the recordings of a stream.
#include "gw/error.h"
#include "gw/machine.h"
#include "inspect/recording/check_lists.h"
#include "inspect/recording/content.h"
#include "inspect/recording/read_bytes.h"
#include "inspect/recording/stream.h"
#include "inspect/recording/stream_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <istream>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace gw::inspect {
namespace {

/// The size is not trusted: memory grows with what is read. Empty: there are fewer bytes.
std::optional<std::vector<std::uint8_t>> read_bytes_of(std::istream& in, std::uint64_t size) {
    constexpr std::uint64_t most_at_once = 1 << 20;
    std::vector<std::uint8_t> bytes;
    while (bytes.size() < size) {
        const std::size_t before = bytes.size();
        bytes.resize(before + std::size_t(std::min(size - before, most_at_once)));
        in.read(reinterpret_cast<char*>(bytes.data()) + before,
                std::streamsize(bytes.size() - before));
        if (std::size_t(in.gcount()) < bytes.size() - before) return {};
    }
    return bytes;
}

std::optional<PartHead> read_head(std::istream& in) {
    const auto bytes = read_bytes_of(in, 24);
    if (!bytes) return {};
    std::array<std::uint64_t, 3> numbers{};
    for (std::size_t i = 0; i < bytes->size(); ++i)
        numbers[i / 8] |= std::uint64_t((*bytes)[i]) << 8 * (i % 8);
    return PartHead{numbers[0], {numbers[1], numbers[2]}};
}

class StreamReader {
public:
    StreamReader(std::istream& in, const Limits& limits) : in_(in), limits_(limits) {}

    Stream read() {
        if (const auto first = read_bytes_of(in_, stream_identifier.size());
            !first || !is_stream({reinterpret_cast<const char*>(first->data()), first->size()}))
            throw Error("not a stream of recordings; expected a file that gw record wrote");
        while (read_part()) {
        }
        for (const WindowRecording& w : stream_.windows) check(w);
        return std::move(stream_);
    }

private:
    /// False at the end.
    bool read_part() {
        const auto head = read_head(in_);
        if (!head) return cut_short();
        if (head->size == 0) {
            if (head->digest != Digest{parts_, 0} || in_.peek() != std::istream::traits_type::eof())
                throw Error(fmt::format("damaged after part {}", parts_));
            return false;
        }
        constexpr std::uint64_t largest_part = std::uint64_t{1} << 31;
        if (head->size > largest_part) throw Error(fmt::format("part {} is damaged", parts_));
        const auto bytes = read_bytes_of(in_, head->size);
        if (!bytes) return cut_short();
        if (digest_of_bytes(*bytes) != head->digest)
            throw Error(fmt::format("part {} is damaged", parts_));
        try {
            take(decode_part(*bytes, values_, limits_));
        } catch (const Error& error) {
            throw Error(fmt::format("part {}: {}", parts_, error.what()));
        }
        ++parts_;
        return true;
    }
    bool cut_short() {
        stream_.cut = fmt::format("cut short after part {}: the rest is missing", parts_);
        if (parts_ == 0) throw Error("cut short before its first part");
        return false;
    }

    void take(Part part) {
        if (part.window.empty()) throw Error("a window without a name");
        if (part.event == WindowEvent::Open) open(part);
        const auto found = open_.find(part.window);
        if (found == open_.end()) throw Error(fmt::format("window '{}' is not open", part.window));
        Recording& recording = stream_.windows[found->second].recording;
        std::ranges::move(part.recording.lists, std::back_inserter(recording.lists));
        std::ranges::move(part.recording.calls, std::back_inserter(recording.calls));
        std::ranges::move(part.recording.color_maps, std::back_inserter(recording.color_maps));
        if (part.event == WindowEvent::Close) open_.erase(found);
    }
    void open(Part& part) {
        std::string name = part.window;
        while (names_.contains(name))
            name = fmt::format("{} {}", part.window, ++names_[part.window]);
        names_[name] = 1;
        open_[part.window] = stream_.windows.size();
        stream_.windows.push_back({name, std::move(part.recording)});
        part.recording.lists = std::exchange(stream_.windows.back().recording.lists, {});
        part.recording.calls = std::exchange(stream_.windows.back().recording.calls, {});
        part.recording.color_maps = std::exchange(stream_.windows.back().recording.color_maps, {});
    }
    void check(const WindowRecording& window) const {
        try {
            check_lists(window.recording, limits_);
        } catch (const Error& error) {
            throw Error(fmt::format("window '{}': {}", window.name, error.what()));
        }
    }

    std::istream& in_;
    const Limits& limits_;
    Stream stream_;
    DecodedValues values_;
    std::map<std::string, std::size_t> open_;  ///< places in windows
    std::map<std::string, int> names_;         ///< machines that began under a name
    std::uint64_t parts_ = 0;
};

std::string names_of(const std::vector<WindowRecording>& windows) {
    constexpr std::size_t most = 20;
    std::string out;
    for (std::size_t i = 0; i < std::min(windows.size(), most); ++i)
        out += fmt::format("{}'{}' ({} x {})", i ? ", " : "", windows[i].name,
                           windows[i].recording.width, windows[i].recording.height);
    return windows.size() > most ? out + ", ..." : out;
}

}  // namespace

bool is_stream(std::string_view beginning) { return beginning.starts_with(stream_identifier); }

Stream decode_stream(std::istream& in, const Limits& limits) {
    return StreamReader(in, limits).read();
}

Stream read_recordings(const std::filesystem::path& file) {
    const bool stream = is_stream(first_bytes(file));
    const std::vector<std::uint8_t> bytes =
        stream ? std::vector<std::uint8_t>() : read_recording_bytes(file);
    try {
        if (!stream) {
            Stream one;
            one.windows.push_back({"", decode(bytes)});
            return one;
        }
        std::ifstream in(file, std::ios::binary);
        return decode_stream(in);
    } catch (const Error& error) {
        throw Error(file.string(), 0, error.what());
    }
}

Recording choose_window(Stream stream, const std::string& window) {
    auto& windows = stream.windows;
    if (windows.empty()) throw Error("the recording has no frame; expected a program that draws");
    if (window.empty() && windows.size() == 1) return std::move(windows[0].recording);
    const auto named = std::find_if(windows.begin(), windows.end(),
                                    [&](const auto& w) { return w.name == window; });
    if (!window.empty() && named != windows.end()) return std::move(named->recording);
    const bool is_number = !window.empty() && window.size() < 8 &&
                           window.find_first_not_of("0123456789") == window.npos;
    if (is_number && std::stoul(window) < windows.size())
        return std::move(windows[std::stoul(window)].recording);
    if (windows.size() == 1 && windows[0].name.empty())
        throw Error(
            fmt::format("--window '{}': the recording has one window, without a name", window));
    throw Error(
        fmt::format("{}expected --window with the name or the number of one of these: {}",
                    window.empty() ? "several windows; " : fmt::format("--window '{}': ", window),
                    names_of(windows)));
}

}  // namespace gw::inspect
