// Long inputs for libFuzzer: now and then a mutation repeats a piece of the input until it is
// longer than 8 KB. Deep nesting, long lines and what costs time with the square of the length are
// not reached by changes of a few bytes.
#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    std::minstd_rand random(seed);
    constexpr std::size_t often = 16, longest_piece = 256, least = 8192;
    if (random() % often != 0 || size == 0 || most <= least)
        return LLVMFuzzerMutate(data, size, most);
    const std::size_t begin = random() % size;
    const std::size_t length = 1 + random() % std::min(longest_piece, size - begin);
    const std::vector<std::uint8_t> piece(data + begin, data + begin + length),
        rest(data + begin + length, data + size);
    const std::size_t wanted = least + random() % (most - least);
    std::size_t end = begin;
    while (end + length <= wanted)
        end = std::size_t(std::copy(piece.begin(), piece.end(), data + end) - data);
    const std::size_t tail = std::min(rest.size(), most - end);
    std::copy_n(rest.begin(), tail, data + end);
    return end + tail;
}
