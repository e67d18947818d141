// The machine: command lists in, planes and counters out. The reference machine and the fast
// machine obey one contract, docs/manual.md. Does not read files and does not know scenes.
#pragma once

#include "gw/base/cache_aligned_vector.h"
#include "gw/command_list.h"
#include "gw/counters.h"
#include "gw/planes.h"
#include "gw/profile.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gw {

/// The largest window: 4096 x 4096 pixels (the guard band is laid out around it).
inline constexpr int max_window_size = 4096;

/// The result of a `Read`: one of the vectors is filled, bottom row first.
struct Readback {
    Plane plane = Plane::Color;
    Rect rect;
    std::vector<Rgba> color;
    CacheAlignedVector<std::uint32_t> values;  ///< depth, stencil or packed colour
    std::vector<std::array<std::int32_t, 4>> accum;
    bool operator==(const Readback&) const = default;
};

/// What memory has from the Reads of the whole window before, as the machine notes it. Whoever changes
/// the memory or its layout clears it.
struct KnownPixels {
    /// 16x16 pixels of the window: the blocks of 4x4 among them that have one colour, a bit each.
    struct Part {
        std::uint64_t color = 0;
        std::uint16_t blocks = 0;
    };
    std::vector<Part> parts;
};

/// How read_into() orders packed colours. The bits are those of the planes.
struct ReadLayout {
    bool top_first = false;   ///< the top row first
    bool blue_first = false;  ///< bytes B, G, R and 0 from the lowest, not R, G, B, A
    /// If not null, parts that the memory has already need not be written again.
    KnownPixels* known = nullptr;
    bool operator==(const ReadLayout&) const = default;
};

/// The caller's memory for the values of Reads, by the Read's key.
struct ReadTarget {
    std::span<std::uint32_t> values;
    ReadLayout layout;
};
using ReadTargets = std::map<std::uint32_t, ReadTarget>;

class Machine {
public:
    virtual ~Machine() = default;

    /// Executes a list. State, planes and texture slots persist from list to list.
    /// Throws Error, before anything is drawn, if `validate` does.
    virtual void execute(const CommandList& list) = 0;

    /// Of the window.
    virtual const Planes& planes() = 0;
    /// One entry per pass since construction (or the last reset).
    virtual const std::vector<PassReport>& passes() = 0;
    virtual void reset_passes() = 0;
    virtual const std::map<std::uint32_t, Readback>& readbacks() = 0;
    /// The next list's Read of this key writes depth, stencil or packed colours to `values` instead
    /// of readbacks(). `values` has rect.area() elements and stays valid until execute() returns.
    /// `layout` is for packed colours.
    virtual void read_into(std::uint32_t key, std::span<std::uint32_t> values,
                           ReadLayout layout = {}) = 0;
    virtual const Profile& profile() const = 0;
};

/// The facts about a machine that decide whether a list is valid.
struct ListContext {
    State state;
    std::map<std::uint32_t, Plane> slots;  ///< filled texture slots and the plane each came from
    ReadTargets targets{};
    std::string pass{};                           ///< the pass that the list continues
    std::optional<std::uint32_t> query{};         ///< the active one
    std::map<std::uint32_t, Surface> surfaces{};  ///< by number, without the window
    std::uint32_t surface = 0;                    ///< the one in use
};

/// What a query leaves to the commands after it.
inline void follow(const Query& query, ListContext& context) {
    context.query.reset();
    if (query.begin) context.query = query.key;
}

/// The name of the last pass, for ListContext; "" before the first.
inline std::string pass_name(const std::vector<PassReport>& passes) {
    return passes.empty() ? "" : passes.back().name;
}

/// Checks a list against a profile and window: extensions by name, values in range, sizes that fit.
/// Throws Error "command N (Draw) of pass 'name': what; what was expected". Commands count from 0.
void validate(const CommandList& list, const Profile& profile, int width, int height,
              ListContext context = {});

/// Throws Error for a window outside 1 .. max_window_size.
void check_window(int width, int height);

/// The manual in code: one fragment at a time. Throws Error if check_window does.
std::unique_ptr<Machine> make_reference(const Profile& profile, int width, int height);

/// The vector instruction set that the fast machine uses on this processor, by Highway's name
/// ("AVX3", "SCALAR").
std::string simd_target();

struct FastOptions {
    int threads = 0;    ///< 0: all
    int log2_tile = 6;  ///< tiles of 16, 32 or 64 pixels a side: 4 .. 6
};
/// Tiles, SIMD and threads; the same bits as the reference machine.
std::unique_ptr<Machine> make_fast(const Profile& profile, int width, int height,
                                   const FastOptions& options = {});

}  // namespace gw
