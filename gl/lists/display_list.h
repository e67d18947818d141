// Display lists. [GL11] 5.4. A list keeps calls with their values in blocks of memory, and plays
// them by the functions that immediate mode calls.
#pragma once

#include "generated/gl/functions.h"
#include "gl/api/kind.h"

#include <GL/gl.h>

#include <cstddef>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace gw::gl {

struct Context;

struct SealedRuns;

/// The operations on a kept call; one object for each function that carries out calls.
struct ListedOperations {
    void (*play)(Context&, const std::byte*);
    void (*destroy)(std::byte*);
    const void* id;  ///< &call_id<execute>
};
template <auto execute>
inline constexpr char call_id = 0;

/// The values that a list keeps of a call of `execute`.
template <class Signature>
struct KeptValues;
template <class... Values>
struct KeptValues<void (*)(Context&, Values...)> {
    using type = std::tuple<std::decay_t<Values>...>;
};

class DisplayList {
public:
    DisplayList();
    ~DisplayList();
    DisplayList(const DisplayList&) = delete;
    DisplayList& operator=(const DisplayList&) = delete;

    /// Appends a call of `execute`.
    template <Kind kind, auto execute, class... Values>
    void add(Function function, const Values&... values);
    /// Ends the list: complete runs of vertices become meshes.
    void seal();

    void play(Context& context) const;

private:
    struct Header {
        const ListedOperations* operations;
        std::uint32_t size;  ///< to the next header
        Function function;
    };
    struct Block {
        std::unique_ptr<std::byte[]> bytes;
        std::size_t used = 0, size = 0;
    };
    struct Position {
        std::size_t block = 0, at = 0;
        bool operator==(const Position&) const = default;
    };
    /// A range of calls, and the runs that they became.
    struct Step {
        Position begin, end;
        std::uint32_t first = 0;           ///< the number of the first call
        std::shared_ptr<SealedRuns> runs;  ///< null: the calls are played
    };
    friend class Sealer;

    /// The place of a new header; its values follow it.
    std::byte* append(std::size_t size);
    const Header& header(const Position& p) const;
    const std::byte* values(const Position& p) const;
    Position next(Position p) const;
    Position end() const { return {blocks_.size(), 0}; }
    void play_calls(Context& context, const Step& step) const;

    std::vector<Block> blocks_;
    std::vector<Step> steps_;
};

/// Values are laid out behind a header.
inline constexpr std::size_t list_alignment = 16;

/// Sets the error of a call that may not stand between Begin and End, if one is played there.
bool is_misplaced(Context& context);

template <Kind kind, auto execute, class Arguments>
inline constexpr ListedOperations listed_operations{
    [](Context& context, const std::byte* at) {
        if constexpr (!may_stand_inside(kind))
            if (is_misplaced(context)) return;
        std::apply([&](const auto&... v) { execute(context, v...); },
                   *reinterpret_cast<const Arguments*>(at));
    },
    [](std::byte* at) { std::destroy_at(reinterpret_cast<Arguments*>(at)); }, &call_id<execute>};

template <Kind kind, auto execute, class... Values>
void DisplayList::add(Function function, const Values&... values) {
    using Arguments = std::tuple<Values...>;
    static_assert(alignof(Arguments) <= list_alignment && sizeof(Header) <= list_alignment);
    constexpr std::size_t size =
        list_alignment + (sizeof(Arguments) + list_alignment - 1) / list_alignment * list_alignment;
    std::byte* const at = append(size);
    std::construct_at(reinterpret_cast<Arguments*>(at + list_alignment), values...);
    std::construct_at(
        reinterpret_cast<Header*>(at),
        Header{&listed_operations<kind, execute, Arguments>, std::uint32_t(size), function});
}

}  // namespace gw::gl
