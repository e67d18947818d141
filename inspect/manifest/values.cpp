#include "inspect/manifest/values.h"

#include "gw/error.h"
#include "inspect/manifest/packing.h"
#include "values_generated.h"

#include <fmt/format.h>

namespace gw::inspect {
namespace {

constexpr std::uint32_t values_version = 3;

template <typename T>
using Vector = flatbuffers::Vector<T>;
using Runs = Vector<const gwt::Run*>;

/// The numbers of one pixel.
std::span<const std::uint32_t> numbers(const std::uint32_t& v) { return {&v, 1}; }
std::span<const std::uint8_t> numbers(const std::uint8_t& v) { return {&v, 1}; }
template <typename T>
std::span<const T> numbers(const std::array<T, 4>& v) {
    return v;
}
std::span<std::uint32_t> numbers(std::uint32_t& v) { return {&v, 1}; }
std::span<std::uint8_t> numbers(std::uint8_t& v) { return {&v, 1}; }
template <typename T>
std::span<T> numbers(std::array<T, 4>& v) {
    return v;
}

/// The pixels that differ.
template <typename T>
std::vector<std::uint8_t> changes(const std::vector<T>& before, const std::vector<T>& now) {
    PackedChanges c;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == before[i]) continue;
        const auto at = static_cast<std::uint32_t>(i);
        if (!c.runs.empty() && c.runs.back().first + c.runs.back().count == at)
            ++c.runs.back().count;
        else
            c.runs.push_back({at, 1});
        const auto pixel = numbers(now[i]);
        c.numbers.insert(c.numbers.end(), pixel.begin(), pixel.end());
    }
    return pack(c, numbers(now[0]).size());
}

/// Overwrites the pixels of a packed plane.
template <typename T>
void apply(const Vector<std::uint8_t>* bytes, std::vector<T>& plane) {
    if (!bytes) return;
    const std::size_t channels = numbers(plane[0]).size();
    const PackedChanges changes = unpack({bytes->data(), bytes->size()}, plane.size(), channels);
    std::size_t next = 0;
    for (const PixelRun& run : changes.runs)
        for (std::size_t i = run.first; i < std::size_t(run.first) + run.count; ++i)
            for (auto& number : numbers(plane[i]))
                number =
                    static_cast<std::remove_reference_t<decltype(number)>>(changes.numbers[next++]);
}

/// Of version 1: overwrites the runs' pixels.
template <typename T, typename Number>
void apply(const Runs* runs, const Vector<Number>* values, std::vector<T>& plane) {
    if (!runs) return;
    std::size_t next = 0;
    for (const gwt::Run* run : *runs) {
        const std::size_t first = run->first(), count = run->count();
        const std::size_t needed = count * numbers(plane[0]).size();
        if (first > plane.size() || count > plane.size() - first || !values ||
            needed > values->size() - next)
            throw Error("values outside the planes; expected those that gw wrote");
        for (std::size_t i = first; i < first + count; ++i)
            for (auto& number : numbers(plane[i]))
                number = values->Get(static_cast<unsigned>(next++));
    }
}

}  // namespace

struct ValuesWriter::Parts {
    Planes before;
    flatbuffers::FlatBufferBuilder out;
    std::vector<flatbuffers::Offset<gwt::PassValues>> passes;
};

ValuesWriter::ValuesWriter(int width, int height, int color_planes)
    : parts_(std::make_unique<Parts>()) {
    parts_->before = Planes(width, height, color_planes);
}
ValuesWriter::~ValuesWriter() = default;

void ValuesWriter::add(const Planes& planes) {
    const Planes& before = parts_->before;
    const auto color = changes(before.color, planes.color);
    const auto depth = changes(before.depth, planes.depth);
    const auto stencil = changes(before.stencil, planes.stencil);
    const auto accum = changes(before.accum, planes.accum);
    const auto back =
        before.back.empty() ? std::vector<std::uint8_t>() : changes(before.back, planes.back);
    auto& out = parts_->out;
    if (out.GetSize() + color.size() + depth.size() + stencil.size() + accum.size() + back.size() >
        (std::uint64_t{1} << 31) - (1 << 20))
        throw Error("values of more than 2 GB; expected less: a smaller window, or no values");
    const auto stored = [&out](const std::vector<std::uint8_t>& bytes) {
        return bytes.empty() ? flatbuffers::Offset<Vector<std::uint8_t>>()
                             : out.CreateVector(bytes);
    };
    const auto stored_color = stored(color), stored_depth = stored(depth),
               stored_stencil = stored(stencil), stored_accum = stored(accum),
               stored_back = stored(back);
    gwt::PassValuesBuilder pass(out);
    pass.add_packed_color(stored_color);
    pass.add_packed_depth(stored_depth);
    pass.add_packed_stencil(stored_stencil);
    pass.add_packed_accum(stored_accum);
    pass.add_packed_back(stored_back);
    parts_->passes.push_back(pass.Finish());
    parts_->before = planes;
}

std::vector<std::uint8_t> ValuesWriter::finish() {
    auto& out = parts_->out;
    const std::uint32_t version = parts_->before.back.empty() ? 2 : 3;
    out.Finish(gwt::CreateValuesDirect(out, version, parts_->before.width, parts_->before.height,
                                       &parts_->passes),
               gwt::ValuesIdentifier());
    return {out.GetBufferPointer(), out.GetBufferPointer() + out.GetSize()};
}

Planes planes_after(std::span<const std::uint8_t> bytes, int width, int height, std::size_t pass,
                    int color_planes) {
    flatbuffers::Verifier verifier(bytes.data(), bytes.size());
    if (bytes.size() < 8 || bytes.size() >= FLATBUFFERS_MAX_BUFFER_SIZE ||
        !gwt::ValuesBufferHasIdentifier(bytes.data()) || !gwt::VerifyValuesBuffer(verifier))
        throw Error("values that are cut short or damaged; expected a file as gw wrote it");
    const gwt::Values& values = *gwt::GetValues(bytes.data());
    if (values.version() < 1 || values.version() > values_version || values.width() != width ||
        values.height() != height)
        throw Error(fmt::format(
            "values of {} x {} pixels, version {}; expected {} x {}, version 1 to {}",
            values.width(), values.height(), values.version(), width, height, values_version));
    const std::size_t count = values.passes() ? values.passes()->size() : 0;
    if (pass >= count)
        throw Error(fmt::format("values of {} passes; expected those of pass {}", count, pass));
    Planes planes(width, height, color_planes);
    for (unsigned i = 0; i <= pass; ++i) {
        const gwt::PassValues& p = *values.passes()->Get(i);
        apply(p.color_runs(), p.color(), planes.color);
        apply(p.depth_runs(), p.depth(), planes.depth);
        apply(p.stencil_runs(), p.stencil(), planes.stencil);
        apply(p.accum_runs(), p.accum(), planes.accum);
        apply(p.packed_color(), planes.color);
        apply(p.packed_depth(), planes.depth);
        apply(p.packed_stencil(), planes.stencil);
        apply(p.packed_accum(), planes.accum);
        if (!planes.back.empty()) apply(p.packed_back(), planes.back);
    }
    return planes;
}

}  // namespace gw::inspect
