// Seeded sequences of all functions with arguments in and out of range: no crash, only the errors of
// the specification, and a call that sets an error changes nothing else. [GL11] 2.5
#include "tests/gl/unit/support/snapshot.h"
#include "tests/gl/unit/support/window.h"

#include <sys/mman.h>

#include <limits>
#include <new>
#include <random>

namespace gw::gl {
namespace {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    unsigned below(unsigned n) { return unsigned(engine_() % n); }

private:
    std::mt19937 engine_;
};

/// Memory for every pointer: larger than any call here may read or write, with the rows that it
/// skips. Pages that no call touches cost nothing.
class Memory {
public:
    explicit Memory(Random& random) {
        void* const at = mmap(nullptr, size, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (at == MAP_FAILED) throw std::bad_alloc();
        bytes = static_cast<GLubyte*>(at);
        for (std::size_t i = 0; i < random_size; ++i)
            bytes[i] = GLubyte(random.below(4) == 0 ? random.below(256) : 0);
    }
    ~Memory() { munmap(bytes, size); }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    GLubyte* bytes;  ///< those after the first are 0

private:
    static constexpr std::size_t size = std::size_t(1) << 36, random_size = 1 << 18;
};

struct Arguments {
    Random& random;
    Memory& memory;

    /// Mostly names that calls know: the ranges that hold GL 1.1's enumerations.
    GLenum token() {
        constexpr std::pair<unsigned, unsigned> ranges[] = {
            {0, 10},          {0x100, 0x108},   {0x200, 0x208},   {0x300, 0x309},
            {0x400, 0x40D},   {0x500, 0x506},   {0x600, 0x605},   {0x700, 0x706},
            {0x800, 0x802},   {0x900, 0x902},   {0xB00, 0xBE3},   {0xC00, 0xDFF},
            {0x1000, 0x1005}, {0x1100, 0x1103}, {0x1200, 0x120A}, {0x1300, 0x1302},
            {0x1400, 0x140A}, {0x1500, 0x1510}, {0x1600, 0x1603}, {0x1700, 0x1703},
            {0x1800, 0x1803}, {0x1900, 0x190B}, {0x1A00, 0x1A01}, {0x1B00, 0x1B03},
            {0x1C00, 0x1C03}, {0x1D00, 0x1D02}, {0x1E00, 0x1E02}, {0x1F00, 0x1F04},
            {0x2000, 0x2004}, {0x2100, 0x2102}, {0x2200, 0x2202}, {0x2300, 0x2301},
            {0x2400, 0x2403}, {0x2500, 0x2503}, {0x2600, 0x2602}, {0x2700, 0x2704},
            {0x2800, 0x2804}, {0x2900, 0x2902}, {0x2A00, 0x2A2E}, {0x3000, 0x3006},
            {0x4000, 0x4008}, {0x8000, 0x8070}, {0x8074, 0x8094}, {0x80C8, 0x80CC},
            {0x8120, 0x8140}, {0x8191, 0x8193}, {0x8362, 0x8371}, {0x83F0, 0x83F4},
            {0x84C0, 0x8502}, {0x8570, 0x859B}, {0x8764, 0x8766}, {0x8872, 0x88EF},
            {0x8C40, 0x8C50}, {0x8CA0, 0x8D48}, {0x806F, 0x8074}, {0x809D, 0x80AC},
            {0x81A5, 0x81A8}, {0x8511, 0x851D}, {0x884A, 0x8850}};
        const auto& [first, last] = ranges[random.below(std::size(ranges))];
        return first + random.below(last - first);
    }
    double real() {
        constexpr double special[] = {0,    1,     -1,    0.5,  2,     180,  -0.25, 90,
                                      1e30, -1e30, 1e-30, 4096, 65536, -255, 1e300, 7};
        const unsigned choice = random.below(24);
        if (choice == 0) return std::numeric_limits<double>::infinity();
        if (choice == 1) return std::numeric_limits<double>::quiet_NaN();
        if (choice < 18) return special[choice - 2];
        return double(random.below(64)) / 4;
    }
    /// Small, since counts and sizes must fit the memory; sometimes an enumeration.
    int whole() {
        const unsigned choice = random.below(12);
        if (choice == 0) return -1 - int(random.below(3));
        if (choice == 1) return int(token());
        return int(random.below(choice < 8 ? 5 : 33));
    }
    void* pointer() { return memory.bytes + 8 * random.below(16); }

    template <class T>
    T value() {
        if constexpr (std::is_pointer_v<T>)
            return static_cast<T>(pointer());
        else if constexpr (std::is_floating_point_v<T>)
            return static_cast<T>(real());
        else if constexpr (std::is_same_v<T, GLenum>)
            return random.below(4) == 0 ? GLenum(random.below(9)) : token();
        else
            return static_cast<T>(whole());
    }
};

template <class Result, class... Values>
void call(Result (*function)(Values...), Arguments& arguments) {
    std::tuple<Values...> values{arguments.value<Values>()...};
    std::apply(function, values);
}

struct Callable {
    const char* name;
    void (*call)(Arguments&);
};
constexpr Callable callables[] = {
#define GW_GL_FUNCTION(name) {#name, [](Arguments& a) { call(gl##name, a); }},
#include "generated/gl/names.inc"
#undef GW_GL_FUNCTION
};

/// Calls whose sizes are not small numbers here, so that they would outgrow the memory or the time:
/// their own tests give them wrong arguments.
bool is_left_out(std::string_view name) {
    return name.starts_with("EvalMesh") || name == "GenLists" || name == "CallLists" ||
           name.starts_with("MultiDraw");
}

/// Calls that may change something before the error comes: lists set the errors of their calls.
bool may_be_partial(std::string_view name) {
    return name == "GetError" || name == "CallList" || name.starts_with("Draw") ||
           name.starts_with("ArrayElement") || name.starts_with("MultiDraw") || name == "End";
}

bool is_error(GLenum error) {
    return error == GL_NO_ERROR ||
           (error >= GL_INVALID_ENUM && error <= GL_INVALID_FRAMEBUFFER_OPERATION);
}

void leave_begin() {
    glEnd();
    while (glGetError() != GL_NO_ERROR) {
    }
}

/// Skipped images of many rows would lie beyond the memory.
void keep_slices_near() {
    for (const GLenum name :
         {GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT})
        glPixelStorei(name, name == GL_UNPACK_SKIP_IMAGES || name == GL_PACK_SKIP_IMAGES ? 1 : 0);
}

/// Ends what a sequence may have opened.
void leave_all(Memory& memory) {
    leave_begin();
    glEndList();
    for (const GLenum target :
         {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
        glBindBuffer(target, 0);
    glRenderMode(GL_RENDER);
    glSelectBuffer(64, reinterpret_cast<GLuint*>(memory.bytes));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    for (const GLenum name :
         {GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(name, 0);
    keep_slices_near();
    leave_begin();
}

void run_sequence(unsigned seed, Window& window, int count) {
    Random random(seed);
    Memory memory(random);
    Arguments arguments{random, memory};
    for (int i = 0; i < count; ++i) {
        const Callable& callable = callables[random.below(std::size(callables))];
        if (is_left_out(callable.name)) continue;
        SCOPED_TRACE(testing::Message()
                     << "seed " << seed << ", call " << i << ": " << callable.name);
        const bool compares = random.below(16) == 0 && !may_be_partial(callable.name);
        if (compares) leave_all(memory);
        const Snapshot before = compares ? snapshot() : Snapshot();
        callable.call(arguments);
        if (std::string_view(callable.name).starts_with("PixelStore")) keep_slices_near();
        const bool is_inside = window.context.assembler.inside;
        if (is_inside && compares) leave_begin();
        const GLenum error = is_inside ? GLenum(GL_NO_ERROR) : glGetError();
        ASSERT_TRUE(is_error(error));
        if (compares && error != GL_NO_ERROR) {
            ASSERT_EQ(changes(before, snapshot()), std::vector<std::string>{});
        }
        if (i % 64 == 0) leave_all(memory);
    }
    leave_all(memory);
}

}  // namespace

TEST(GlCallFuzz, WrongCallsAreErrorsAndChangeNothing) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        Window window(16, 16);
        run_sequence(seed, window, 2000);
    }
}

TEST(GlCallFuzz, ContextsWithoutADrawableTakeEveryCall) {
    for (unsigned seed = 1000; seed < 1008; ++seed) {
        Window window(16, 16);
        make_current(&window.context, nullptr);
        run_sequence(seed, window, 2000);
    }
}

TEST(GlCallFuzz, WindowsWithSamplesTakeEveryCall) {
    for (unsigned seed = 2000; seed < 2008; ++seed) {
        Window window(16, 16, opengl(), Buffers::Double, 4);
        run_sequence(seed, window, 2000);
    }
}

TEST(GlCallFuzz, WithoutAContextEveryCallIsIgnored) {
    make_current(nullptr, nullptr);
    Random random(1);
    Memory memory(random);
    Arguments arguments{random, memory};
    for (const Callable& callable : callables) callable.call(arguments);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace gw::gl
