// Random sequences of all functions, with ordinary and hostile arguments: no crash, no hang, nothing
// written beside the program's memory.
#include "tests/irisgl/support.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace gw::irisgl {

namespace {

/// The program's memory, between two walls.
class Memory {
public:
    Memory() : bytes_(wall + size + wall, 0xA5) {}
    char* begin() { return reinterpret_cast<char*>(bytes_.data()) + wall; }
    bool is_whole() const {
        const auto same = [](std::uint8_t b) { return b == 0xA5; };
        return std::all_of(bytes_.begin(), bytes_.begin() + wall, same) &&
               std::all_of(bytes_.end() - wall, bytes_.end(), same);
    }
    static constexpr std::ptrdiff_t size = 1 << 23;

private:
    static constexpr std::ptrdiff_t wall = 4096;
    std::vector<std::uint8_t> bytes_;
};

class Arguments {
public:
    explicit Arguments(unsigned seed) : random_(seed) {}
    unsigned upto(unsigned n) { return unsigned(random_() % n); }

    template <class T>
    T make() {
        if constexpr (std::is_same_v<T, const char*> || std::is_same_v<T, char*>)
            return T(text());
        else if constexpr (std::is_same_v<T, fmfaceproc>)
            return nullptr;
        else if constexpr (std::is_pointer_v<T>)
            return upto(12) == 0 ? nullptr : memory<T>();
        else if constexpr (std::is_floating_point_v<T>)
            return T(number());
        else
            return T(whole());
    }
    Memory& memory() { return memory_; }
    /// Numbers that the next calls read.
    void refill() {
        for (int i = 0; i < 512; ++i) {
            const auto value = float(number());
            std::memcpy(memory_.begin() + 4 * i, &value, 4);
        }
        for (int i = 512; i < 1024; ++i) {
            const std::uint32_t word = std::uint32_t(random_());
            std::memcpy(memory_.begin() + 4 * i, &word, 4);
        }
    }

private:
    template <class T>
    T memory() {
        return reinterpret_cast<T>(memory_.begin() + 64 * upto(40));
    }
    const char* text() {
        static const std::array<std::string, 8> texts{"",
                                                      "abc",
                                                      "%t|%m|%f %F",
                                                      "one %x3|two %n|three %l",
                                                      std::string(300, '%'),
                                                      std::string(500, '|'),
                                                      "\xff\xfe\x80",
                                                      "Title%t%F|%x"};
        return upto(12) == 0 ? nullptr : texts[upto(8)].c_str();
    }
    double number() {
        constexpr double hostile[] = {std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity(),
                                      1e30,
                                      -1e30,
                                      1e-30,
                                      4e9,
                                      0};
        if (upto(10) == 0) return hostile[upto(8)];
        return double(upto(4000)) / 100 - 12;
    }
    long whole() {
        constexpr long hostile[] = {-1,
                                    -32768,
                                    32767,
                                    -3,
                                    0x7fffffff,
                                    -0x7fffffffL - 1,
                                    std::numeric_limits<long>::max(),
                                    std::numeric_limits<long>::min()};
        if (upto(12) == 0) return hostile[upto(8)];
        // Words of most kinds: devices, properties, planes, small counts and places.
        constexpr long words[] = {16,  32,   64,   128,  256, 0x100, 0x200, 101,  102, 200,
                                  201, 1000, 1100, 1200, 24,  48,    8,     0x4c, 0x51};
        return upto(4) == 0 ? words[upto(unsigned(std::size(words)))] : long(upto(45)) - 2;
    }
    std::mt19937 random_;
    Memory memory_;
};

template <class R, class... A>
void call(R (*function)(A...), Arguments& z) {
    function(z.make<A>()...);
}
template <class R, class... A>
void call(R (*function)(A..., ...), Arguments& z) {
    function(z.make<A>()..., 0L, 0L, 0L, 0L, 0L, 0L);
}

struct Function {
    const char* name;
    void (*run)(Arguments&);
};
#define GW_IRISGL_FUNCTION(name, kind) {#name, [](Arguments& z) { call(&name, z); }},
const Function functions[] = {
#include "generated/irisgl/functions.inc"
};
#undef GW_IRISGL_FUNCTION

/// These fill the screen, or end the program when nothing comes: they have what they need.
void prepare(const std::string& name) {
    if (name == "qread" || name == "blkqread" || name == "dopup") enter(REDRAW, 1);
    if (program().windows.size() > 3) winclose(program().windows.begin()->first);
    if (name == "winopen" || name == "swinopen" || name == "getport") {
        program().hints = {};
        prefsize(32, 24);
    }
}

bool is_slow(const std::string& name) {
    return name == "ginit" || name == "gbegin" || name == "fullscrn" || name == "winposition";
}

void reset(Arguments& z) {
    endpick(nullptr);
    endfeedback(z.memory().begin());
    gexit();
    program().objects = {};
    program().events = {};
    program().menus = {};
    program().colors = {};
    program().hints = {};
    program().cursors.clear();
    program().fonts.clear();
    program().managed_fonts.clear();
    program().patterns.clear();
    program().textures.clear();
    program().cursor = 0;
    program().managed_font = 0;
    program().is_cursor_on = true;
    program().cursor_type = 0;
}

void run_sequence(unsigned seed, int length, bool has_window) {
    Arguments z(seed);
    std::string last;
    z.refill();
    if (has_window) {
        prefsize(48, 32);
        winopen("fuzz");
    }
    for (int i = 0; i < length; ++i) {
        const Function& f = functions[z.upto(unsigned(std::size(functions)))];
        if (is_slow(f.name)) continue;
        if (z.upto(16) == 0) z.refill();
        if (z.upto(8) == 0 && program().objects.open.is_open()) closeobj();
        prepare(f.name);
        f.run(z);
        ASSERT_TRUE(z.memory().is_whole()) << f.name << " after " << i << " calls of seed " << seed;
    }
    reset(z);
}

}  // namespace

TEST(IrisGlFuzz, RandomCallsNeitherCrashNorWriteBesideTheProgramsMemory) {
    unsetenv("DISPLAY");
    testing::internal::CaptureStderr();
    for (unsigned seed = 1; seed <= 8; ++seed) run_sequence(seed, 200, seed % 8 != 0);
    testing::internal::GetCapturedStderr();
}

// Each function with hostile numbers alone, so that none is left to chance.
TEST(IrisGlFuzz, EveryFunctionTakesHostileArguments) {
    unsetenv("DISPLAY");
    testing::internal::CaptureStderr();
    Arguments z(7);
    prefsize(48, 32);
    winopen("fuzz");
    for (const Function& f : functions) {
        if (is_slow(f.name) || std::string(f.name) == "gexit") continue;
        for (int i = 0; i < 4; ++i) {
            z.refill();
            prepare(f.name);
            f.run(z);
            if (program().objects.open.is_open()) closeobj();
        }
        ASSERT_TRUE(z.memory().is_whole()) << f.name;
    }
    reset(z);
    testing::internal::GetCapturedStderr();
}

}  // namespace gw::irisgl
