#include "gl/lists/display_list.h"

#include "gl/context/context.h"
#include "gl/lists/sealed_runs.h"

#include <algorithm>

namespace gw::gl {

namespace {
constexpr std::size_t first_block = 1024, largest_block = 1 << 20;
}

bool is_misplaced(Context& context) {
    if (!context.assembler.inside) return false;
    set_error(context, GL_INVALID_OPERATION);
    return true;
}

DisplayList::DisplayList() = default;

DisplayList::~DisplayList() {
    for (Position p; p != end(); p = next(p))
        header(p).operations->destroy(const_cast<std::byte*>(values(p)));
}

std::byte* DisplayList::append(std::size_t size) {
    if (blocks_.empty() || blocks_.back().used + size > blocks_.back().size) {
        const std::size_t grown = blocks_.empty() ? first_block : 2 * blocks_.back().size;
        const std::size_t bytes = std::max(size, std::min(grown, largest_block));
        blocks_.push_back({std::make_unique<std::byte[]>(bytes), 0, bytes});
    }
    Block& block = blocks_.back();
    std::byte* const at = block.bytes.get() + block.used;
    block.used += size;
    return at;
}

const DisplayList::Header& DisplayList::header(const Position& p) const {
    return *reinterpret_cast<const Header*>(blocks_[p.block].bytes.get() + p.at);
}

const std::byte* DisplayList::values(const Position& p) const {
    return blocks_[p.block].bytes.get() + p.at + list_alignment;
}

DisplayList::Position DisplayList::next(Position p) const {
    p.at += header(p).size;
    return p.at < blocks_[p.block].used ? p : Position{p.block + 1, 0};
}

void DisplayList::play_calls(Context& context, const Step& step) const {
    std::uint32_t number = step.first;
    for (Position p = step.begin; p != step.end; p = next(p), ++number) {
        if (calls_are_kept && !context.calls.is_one_call) [[unlikely]]
            context.calls.now = {number, name_of(header(p).function), nullptr, context.calls.list};
        header(p).operations->play(context, values(p));
    }
}

void DisplayList::play(Context& context) const {
    for (const Step& step : steps_)
        if (!step.runs || !draw_runs(context, *step.runs)) play_calls(context, step);
}

}  // namespace gw::gl
