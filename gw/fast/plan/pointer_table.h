// A hash table of pointers to elements that equal() compares. Does not own them.
#pragma once

#include "gw/base/prefetch.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gw::fast {

/// A hash of values in order; 0 and -0 are equal.
class Hash {
public:
    Hash& add(std::uint64_t v) {
        value_ = (value_ ^ v) * 0x9E3779B97F4A7C15u;
        value_ ^= value_ >> 32;
        return *this;
    }
    Hash& add(double v) { return add(std::bit_cast<std::uint64_t>(v + 0.0)); }
    Hash& add(const void* p) { return add(std::uint64_t(reinterpret_cast<std::uintptr_t>(p))); }
    /// A sum of products, which the processor computes in parallel.
    Hash& add_all(const double* first, std::size_t count) {
        std::uint64_t sum = 0, factor = 0xD6E8FEB86659FD93u;
        for (std::size_t i = 0; i < count; ++i, factor += 0x9E3779B97F4A7C16u) {
            const auto bits = std::bit_cast<std::uint64_t>(first[i] + 0.0);
            sum += (bits ^ bits >> 32) * factor;
        }
        return add(sum ^ sum >> 32);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0x243F6A8885A308D3u;
};

/// Keeps a few elements of one hash: others are not found. So it is quick even if all have the same.
template <class T>
class PointerTable {
public:
    /// Forgets everything; its memory follows the number of elements.
    void clear() {
        if (slots_.size() > 64 && slots_.size() > 8 * count_)
            slots_ = std::vector<Slot>(std::bit_ceil(4 * count_ + 16));
        else if (count_ != 0)
            std::fill(slots_.begin(), slots_.end(), Slot{});
        count_ = 0;
    }
    template <class Equal>
    T* find(std::uint64_t hash, const Equal& equal) const {
        if (slots_.empty()) return nullptr;
        for (std::size_t i = hash & mask(); slots_[i].element; i = (i + 1) & mask())
            if (slots_[i].hash == hash && equal(*slots_[i].element)) return slots_[i].element;
        return nullptr;
    }
    /// Prefetches the place where find() begins.
    [[gnu::always_inline]] void prefetch_slot(std::uint64_t hash) const {
        if (!slots_.empty()) prefetch(&slots_[hash & mask()], sizeof(Slot));
    }
    void add(std::uint64_t hash, T* element) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        count_ += put({hash, element}) ? 1 : 0;
    }
    std::size_t size() const { return count_; }

private:
    struct Slot {
        std::uint64_t hash = 0;
        T* element = nullptr;
    };
    static constexpr int most_of_one_hash = 8;

    std::size_t mask() const { return slots_.size() - 1; }
    /// False if there are enough of its hash.
    bool put(const Slot& slot) {
        int alike = 0;
        std::size_t i = slot.hash & mask();
        for (; slots_[i].element; i = (i + 1) & mask())
            if (slots_[i].hash == slot.hash && ++alike == most_of_one_hash) return false;
        slots_[i] = slot;
        return true;
    }
    void grow() {
        std::vector<Slot> old(std::max<std::size_t>(2 * slots_.size(), 16));
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.element) put(slot);
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

}  // namespace gw::fast
