#include "inspect/manifest/packing.h"

#include "gw/error.h"

namespace gw::inspect {
namespace {

/// Unsigned LEB128: seven bits a byte, the lowest first, the eighth set if more follow.
void put(std::vector<std::uint8_t>& bytes, std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 0x80));
    bytes.push_back(static_cast<std::uint8_t>(number));
}

class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    std::uint64_t number() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            if (bytes_.empty()) fail();
            const std::uint8_t byte = bytes_[0];
            bytes_ = bytes_.subspan(1);
            value |= std::uint64_t(byte & 0x7f) << shift;
            if (byte < 0x80) return value;
        }
        fail();
    }
    std::uint64_t number_up_to(std::uint64_t most) {
        const std::uint64_t value = number();
        if (value > most) fail();
        return value;
    }
    void expect_end() const {
        if (!bytes_.empty()) fail();
    }

private:
    [[noreturn]] static void fail() {
        throw Error("values that are cut short or damaged; expected those that gw wrote");
    }
    std::span<const std::uint8_t> bytes_;
};

/// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
std::uint64_t zigzag(std::int64_t v) {
    return (static_cast<std::uint64_t>(v) << 1) ^ (v < 0 ? ~std::uint64_t{0} : 0);
}
std::uint64_t unzigzag(std::uint64_t v) { return (v >> 1) ^ (~(v & 1) + 1); }

void put_runs(std::vector<std::uint8_t>& bytes, const std::vector<PixelRun>& runs) {
    put(bytes, runs.size());
    std::uint32_t end = 0;
    for (const PixelRun& run : runs) {
        put(bytes, run.first - end);
        put(bytes, run.count);
        end = run.first + run.count;
    }
}

}  // namespace

std::vector<std::uint8_t> pack(const PackedChanges& changes, std::size_t channels) {
    std::vector<std::uint8_t> bytes;
    if (changes.runs.empty()) return bytes;
    put_runs(bytes, changes.runs);
    const auto& numbers = changes.numbers;
    const auto difference = [&](std::size_t i) {
        return numbers[i] - (i < channels ? 0 : numbers[i - channels]);
    };
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        put(bytes, zigzag(difference(i)));
        if (difference(i) != 0) continue;
        std::size_t more = 0;
        while (i + 1 < numbers.size() && difference(i + 1) == 0) {
            ++more;
            ++i;
        }
        put(bytes, more);
    }
    return bytes;
}

PackedChanges unpack(std::span<const std::uint8_t> bytes, std::size_t pixels,
                     std::size_t channels) {
    PackedChanges changes;
    if (bytes.empty()) return changes;
    Reader in(bytes);
    std::uint64_t end = 0, total = 0;
    for (std::uint64_t runs = in.number_up_to(pixels); runs > 0; --runs) {
        const std::uint64_t first = end + in.number_up_to(pixels - end);
        const std::uint64_t count = in.number_up_to(pixels - first);
        changes.runs.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
        end = first + count;
        total += count * channels;
    }
    auto& numbers = changes.numbers;
    numbers.reserve(total);
    const auto add = [&](std::uint64_t difference) {
        const std::uint64_t before =
            numbers.size() < channels
                ? 0
                : static_cast<std::uint64_t>(numbers[numbers.size() - channels]);
        numbers.push_back(static_cast<std::int64_t>(before + difference));
    };
    while (numbers.size() < total) {
        const std::uint64_t difference = unzigzag(in.number());
        add(difference);
        if (difference != 0) continue;
        for (std::uint64_t more = in.number_up_to(total - numbers.size()); more > 0; --more) add(0);
    }
    in.expect_end();
    return changes;
}

}  // namespace gw::inspect
