// Seeded sequences of all functions with arguments in and out of range: no crash, only the errors of
// the specification, and a call that sets an error changes nothing else. [GL11] 2.5
#include "tests/gl/support/snapshot.h"
#include "tests/gl/support/window.h"

#include <limits>
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

/// Memory for every pointer: larger than any call here may read or write.
struct Memory {
    static constexpr std::size_t size = 1 << 18;
    std::vector<GLubyte> bytes = std::vector<GLubyte>(size);
    explicit Memory(Random& random) {
        for (GLubyte& byte : bytes) byte = GLubyte(random.below(4) == 0 ? random.below(256) : 0);
    }
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
            {0x4000, 0x4008}, {0x8000, 0x8070}};
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
    void* pointer() { return memory.bytes.data() + 8 * random.below(16); }

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
#define GW_CALL(name)                                   \
    {                                                   \
#name, [](Arguments & a) { call(gl##name, a); } \
    }
constexpr Callable callables[] = {
    // clang-format off
    GW_CALL(Begin), GW_CALL(End), GW_CALL(EdgeFlag), GW_CALL(EdgeFlagv), GW_CALL(Vertex2s),
    GW_CALL(Vertex2i), GW_CALL(Vertex2f), GW_CALL(Vertex2d), GW_CALL(Vertex3s), GW_CALL(Vertex3i),
    GW_CALL(Vertex3f), GW_CALL(Vertex3d), GW_CALL(Vertex4s), GW_CALL(Vertex4i), GW_CALL(Vertex4f),
    GW_CALL(Vertex4d), GW_CALL(Vertex2sv), GW_CALL(Vertex2iv), GW_CALL(Vertex2fv),
    GW_CALL(Vertex2dv), GW_CALL(Vertex3sv), GW_CALL(Vertex3iv), GW_CALL(Vertex3fv),
    GW_CALL(Vertex3dv), GW_CALL(Vertex4sv), GW_CALL(Vertex4iv), GW_CALL(Vertex4fv),
    GW_CALL(Vertex4dv), GW_CALL(TexCoord1s), GW_CALL(TexCoord1i), GW_CALL(TexCoord1f),
    GW_CALL(TexCoord1d), GW_CALL(TexCoord2s), GW_CALL(TexCoord2i), GW_CALL(TexCoord2f),
    GW_CALL(TexCoord2d), GW_CALL(TexCoord3s), GW_CALL(TexCoord3i), GW_CALL(TexCoord3f),
    GW_CALL(TexCoord3d), GW_CALL(TexCoord4s), GW_CALL(TexCoord4i), GW_CALL(TexCoord4f),
    GW_CALL(TexCoord4d), GW_CALL(TexCoord1sv), GW_CALL(TexCoord1iv), GW_CALL(TexCoord1fv),
    GW_CALL(TexCoord1dv), GW_CALL(TexCoord2sv), GW_CALL(TexCoord2iv), GW_CALL(TexCoord2fv),
    GW_CALL(TexCoord2dv), GW_CALL(TexCoord3sv), GW_CALL(TexCoord3iv), GW_CALL(TexCoord3fv),
    GW_CALL(TexCoord3dv), GW_CALL(TexCoord4sv), GW_CALL(TexCoord4iv), GW_CALL(TexCoord4fv),
    GW_CALL(TexCoord4dv), GW_CALL(Normal3b), GW_CALL(Normal3s), GW_CALL(Normal3i),
    GW_CALL(Normal3f), GW_CALL(Normal3d), GW_CALL(Normal3bv), GW_CALL(Normal3sv),
    GW_CALL(Normal3iv), GW_CALL(Normal3fv), GW_CALL(Normal3dv), GW_CALL(Color3b), GW_CALL(Color3s),
    GW_CALL(Color3i), GW_CALL(Color3f), GW_CALL(Color3d), GW_CALL(Color3ub), GW_CALL(Color3us),
    GW_CALL(Color3ui), GW_CALL(Color4b), GW_CALL(Color4s), GW_CALL(Color4i), GW_CALL(Color4f),
    GW_CALL(Color4d), GW_CALL(Color4ub), GW_CALL(Color4us), GW_CALL(Color4ui), GW_CALL(Color3bv),
    GW_CALL(Color3sv), GW_CALL(Color3iv), GW_CALL(Color3fv), GW_CALL(Color3dv), GW_CALL(Color3ubv),
    GW_CALL(Color3usv), GW_CALL(Color3uiv), GW_CALL(Color4bv), GW_CALL(Color4sv), GW_CALL(Color4iv),
    GW_CALL(Color4fv), GW_CALL(Color4dv), GW_CALL(Color4ubv), GW_CALL(Color4usv),
    GW_CALL(Color4uiv), GW_CALL(Indexs), GW_CALL(Indexsv), GW_CALL(Indexi), GW_CALL(Indexiv),
    GW_CALL(Indexf), GW_CALL(Indexfv), GW_CALL(Indexd), GW_CALL(Indexdv), GW_CALL(Indexub),
    GW_CALL(Indexubv), GW_CALL(VertexPointer), GW_CALL(NormalPointer), GW_CALL(ColorPointer),
    GW_CALL(IndexPointer), GW_CALL(TexCoordPointer), GW_CALL(EdgeFlagPointer),
    GW_CALL(EnableClientState), GW_CALL(DisableClientState), GW_CALL(InterleavedArrays),
    GW_CALL(ArrayElement), GW_CALL(DrawArrays), GW_CALL(DrawElements), GW_CALL(Rects),
    GW_CALL(Rectsv), GW_CALL(Recti), GW_CALL(Rectiv), GW_CALL(Rectf), GW_CALL(Rectfv),
    GW_CALL(Rectd), GW_CALL(Rectdv), GW_CALL(DepthRange), GW_CALL(Viewport), GW_CALL(MatrixMode),
    GW_CALL(LoadMatrixf), GW_CALL(LoadMatrixd), GW_CALL(MultMatrixf), GW_CALL(MultMatrixd),
    GW_CALL(LoadIdentity), GW_CALL(Rotatef), GW_CALL(Rotated), GW_CALL(Translatef),
    GW_CALL(Translated), GW_CALL(Scalef), GW_CALL(Scaled), GW_CALL(Frustum), GW_CALL(Ortho),
    GW_CALL(PushMatrix), GW_CALL(PopMatrix), GW_CALL(TexGeni), GW_CALL(TexGenf), GW_CALL(TexGend),
    GW_CALL(TexGeniv), GW_CALL(TexGenfv), GW_CALL(TexGendv), GW_CALL(ClipPlane),
    GW_CALL(RasterPos2s), GW_CALL(RasterPos2sv), GW_CALL(RasterPos2i), GW_CALL(RasterPos2iv),
    GW_CALL(RasterPos2f), GW_CALL(RasterPos2fv), GW_CALL(RasterPos2d), GW_CALL(RasterPos2dv),
    GW_CALL(RasterPos3s), GW_CALL(RasterPos3sv), GW_CALL(RasterPos3i), GW_CALL(RasterPos3iv),
    GW_CALL(RasterPos3f), GW_CALL(RasterPos3fv), GW_CALL(RasterPos3d), GW_CALL(RasterPos3dv),
    GW_CALL(RasterPos4s), GW_CALL(RasterPos4sv), GW_CALL(RasterPos4i), GW_CALL(RasterPos4iv),
    GW_CALL(RasterPos4f), GW_CALL(RasterPos4fv), GW_CALL(RasterPos4d), GW_CALL(RasterPos4dv),
    GW_CALL(FrontFace), GW_CALL(ShadeModel), GW_CALL(Lightf), GW_CALL(Lighti), GW_CALL(Lightfv),
    GW_CALL(Lightiv), GW_CALL(LightModelf), GW_CALL(LightModeli), GW_CALL(LightModelfv),
    GW_CALL(LightModeliv), GW_CALL(ColorMaterial), GW_CALL(Materialf), GW_CALL(Materiali),
    GW_CALL(Materialfv), GW_CALL(Materialiv), GW_CALL(PointSize), GW_CALL(LineWidth),
    GW_CALL(LineStipple), GW_CALL(CullFace), GW_CALL(PolygonStipple), GW_CALL(PolygonMode),
    GW_CALL(PolygonOffset), GW_CALL(PixelStoref), GW_CALL(PixelStorei), GW_CALL(PixelTransferf),
    GW_CALL(PixelTransferi), GW_CALL(PixelMapfv), GW_CALL(PixelMapuiv), GW_CALL(PixelMapusv),
    GW_CALL(PixelZoom), GW_CALL(DrawPixels), GW_CALL(Bitmap), GW_CALL(CopyPixels),
    GW_CALL(ReadPixels), GW_CALL(ReadBuffer), GW_CALL(TexImage1D), GW_CALL(TexImage2D),
    GW_CALL(TexSubImage1D), GW_CALL(TexSubImage2D), GW_CALL(CopyTexImage1D),
    GW_CALL(CopyTexImage2D), GW_CALL(CopyTexSubImage1D), GW_CALL(CopyTexSubImage2D),
    GW_CALL(TexParameterf), GW_CALL(TexParameteri), GW_CALL(TexParameterfv),
    GW_CALL(TexParameteriv), GW_CALL(TexEnvf), GW_CALL(TexEnvi), GW_CALL(TexEnvfv),
    GW_CALL(TexEnviv), GW_CALL(BindTexture), GW_CALL(GenTextures), GW_CALL(DeleteTextures),
    GW_CALL(IsTexture), GW_CALL(AreTexturesResident), GW_CALL(PrioritizeTextures), GW_CALL(Fogf),
    GW_CALL(Fogi), GW_CALL(Fogfv), GW_CALL(Fogiv), GW_CALL(Scissor), GW_CALL(AlphaFunc),
    GW_CALL(StencilFunc), GW_CALL(StencilOp), GW_CALL(DepthFunc), GW_CALL(BlendFunc),
    GW_CALL(LogicOp), GW_CALL(DrawBuffer), GW_CALL(IndexMask), GW_CALL(ColorMask),
    GW_CALL(DepthMask), GW_CALL(StencilMask), GW_CALL(Clear), GW_CALL(ClearColor),
    GW_CALL(ClearIndex), GW_CALL(ClearDepth), GW_CALL(ClearStencil), GW_CALL(ClearAccum),
    GW_CALL(Accum), GW_CALL(Map1f), GW_CALL(Map1d), GW_CALL(Map2f), GW_CALL(Map2d),
    GW_CALL(EvalCoord1f), GW_CALL(EvalCoord1d), GW_CALL(EvalCoord1fv), GW_CALL(EvalCoord1dv),
    GW_CALL(EvalCoord2f), GW_CALL(EvalCoord2d), GW_CALL(EvalCoord2fv), GW_CALL(EvalCoord2dv),
    GW_CALL(MapGrid1f), GW_CALL(MapGrid1d), GW_CALL(MapGrid2f), GW_CALL(MapGrid2d),
    GW_CALL(EvalPoint1), GW_CALL(EvalPoint2), GW_CALL(EvalMesh1), GW_CALL(EvalMesh2),
    GW_CALL(InitNames), GW_CALL(LoadName), GW_CALL(PushName), GW_CALL(PopName), GW_CALL(RenderMode),
    GW_CALL(SelectBuffer), GW_CALL(FeedbackBuffer), GW_CALL(PassThrough), GW_CALL(NewList),
    GW_CALL(EndList), GW_CALL(CallList), GW_CALL(CallLists), GW_CALL(GenLists), GW_CALL(IsList),
    GW_CALL(DeleteLists), GW_CALL(ListBase), GW_CALL(Flush), GW_CALL(Finish), GW_CALL(Hint),
    GW_CALL(Enable), GW_CALL(Disable), GW_CALL(IsEnabled), GW_CALL(GetBooleanv),
    GW_CALL(GetIntegerv), GW_CALL(GetFloatv), GW_CALL(GetDoublev), GW_CALL(GetError),
    GW_CALL(GetString), GW_CALL(GetClipPlane), GW_CALL(GetLightfv), GW_CALL(GetLightiv),
    GW_CALL(GetMaterialfv), GW_CALL(GetMaterialiv), GW_CALL(GetTexEnvfv), GW_CALL(GetTexEnviv),
    GW_CALL(GetTexGendv), GW_CALL(GetTexGenfv), GW_CALL(GetTexGeniv), GW_CALL(GetTexParameterfv),
    GW_CALL(GetTexParameteriv), GW_CALL(GetTexLevelParameterfv), GW_CALL(GetTexLevelParameteriv),
    GW_CALL(GetTexImage), GW_CALL(GetPixelMapfv), GW_CALL(GetPixelMapuiv), GW_CALL(GetPixelMapusv),
    GW_CALL(GetMapdv), GW_CALL(GetMapfv), GW_CALL(GetMapiv), GW_CALL(GetPolygonStipple),
    GW_CALL(GetPointerv), GW_CALL(PushAttrib), GW_CALL(PopAttrib), GW_CALL(PushClientAttrib),
    GW_CALL(PopClientAttrib),
    // clang-format on
};

/// Calls whose sizes are not small numbers here, so that they would outgrow the memory or the time:
/// their own tests give them wrong arguments.
bool is_left_out(std::string_view name) {
    return name.starts_with("EvalMesh") || name == "GenLists" || name == "CallLists";
}

/// Calls that may change something before the error comes: lists set the errors of their calls.
bool may_be_partial(std::string_view name) {
    return name == "GetError" || name == "CallList" || name.starts_with("Draw") ||
           name == "ArrayElement" || name == "End";
}

bool is_error(GLenum error) {
    return error == GL_NO_ERROR || (error >= GL_INVALID_ENUM && error <= GL_OUT_OF_MEMORY);
}

void leave_begin() {
    glEnd();
    while (glGetError() != GL_NO_ERROR) {
    }
}

/// Ends what a sequence may have opened.
void leave_all(Memory& memory) {
    leave_begin();
    glEndList();
    glRenderMode(GL_RENDER);
    glSelectBuffer(64, reinterpret_cast<GLuint*>(memory.bytes.data()));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    for (const GLenum name :
         {GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(name, 0);
    leave_begin();
}

void run_sequence(unsigned seed, bool has_drawable, int count) {
    Window window(16, 16);
    if (!has_drawable) make_current(&window.context, nullptr);
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
    for (unsigned seed = 0; seed < 8; ++seed) run_sequence(seed, true, 2000);
}

TEST(GlCallFuzz, ContextsWithoutADrawableTakeEveryCall) {
    for (unsigned seed = 1000; seed < 1008; ++seed) run_sequence(seed, false, 2000);
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
