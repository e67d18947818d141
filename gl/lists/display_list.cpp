#include "gl/lists/display_list.h"

#include <algorithm>

namespace gw::gl {

namespace {
constexpr std::size_t first_block = 1024, largest_block = 1 << 20;
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

DisplayList::~DisplayList() {
    for (Block& block : blocks_)
        for (std::size_t at = 0; at < block.used;) {
            const auto& header = *reinterpret_cast<const Header*>(block.bytes.get() + at);
            header.operations->destroy(block.bytes.get() + at + list_alignment);
            at += header.size;
        }
}

void DisplayList::play(Context& c) const {
    for (const Block& block : blocks_)
        for (std::size_t at = 0; at < block.used;) {
            const auto& header = *reinterpret_cast<const Header*>(block.bytes.get() + at);
            header.operations->play(c, block.bytes.get() + at + list_alignment);
            at += header.size;
        }
}

}  // namespace gw::gl
