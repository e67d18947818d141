// OSMesa's functions: contexts that draw into the caller's memory. Flush and Finish of the
// context's thread bring it up to date. No other call touches it. Colour index mode is not offered.
#include "gl/context/c_boundary.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/draw/finish.h"
#include "gl/drawable/settings.h"
#include "gl/entry/entry_points.h"
#include "gl/record/recorder.h"

#include "gw/base/arithmetic.h"
#include "gw/error.h"

#include <GL/osmesa.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace gw;
using namespace gw::gl;

/// A pixel in the caller's memory: the places of R, G, B, A (-1: none) in `size` components.
struct Layout {
    GLenum format;
    int size;
    std::array<int, 4> place;
};
constexpr Layout layouts[] = {
    {OSMESA_RGBA, 4, {0, 1, 2, 3}}, {OSMESA_BGRA, 4, {2, 1, 0, 3}}, {OSMESA_ARGB, 4, {1, 2, 3, 0}},
    {OSMESA_RGB, 3, {0, 1, 2, -1}}, {OSMESA_BGR, 3, {2, 1, 0, -1}}, {OSMESA_RGB_565, 1, {}},
};

const Layout* layout_of(GLenum format) {
    for (const Layout& layout : layouts)
        if (layout.format == format) return &layout;
    return nullptr;
}

bool is_type_of(GLenum format, GLenum type) {
    if (format == OSMESA_RGB_565) return type == GL_UNSIGNED_SHORT_5_6_5;
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_FLOAT;
}

std::size_t component_size(GLenum type) {
    if (type == GL_FLOAT) return 4;
    return type == GL_UNSIGNED_BYTE ? 1 : 2;
}

/// The caller's memory as a drawable.
class Memory : public Drawable {
public:
    Memory(const Profile& of, int width, int height, std::string name, const Layout& layout)
        : Drawable(of, width, height, std::move(name)), layout_(layout) {}

    void set_memory(void* buffer, GLenum type) {
        buffer_ = static_cast<unsigned char*>(buffer);
        type_ = type;
        is_used_ = is_outdated_ = true;
    }
    /// The memory may be gone from here on: present() leaves it alone until set_memory().
    void leave_memory() { is_used_ = false; }
    void* memory() const { return buffer_; }
    void set_row_length(int pixels) {
        row_length_ = pixels;
        is_outdated_ = true;
    }
    int row_length() const { return row_length_ > 0 ? row_length_ : width(); }
    void set_y_up(bool up) {
        y_up_ = up;
        is_outdated_ = true;
    }
    GLenum type() const { return type_; }

    /// Copies the picture to the memory, unless it is there already.
    void present() override;
    /// Depth values for OSMesaGetDepthBuffer, bottom row first.
    std::vector<std::uint32_t>& depths();

private:
    void copy_picture();
    void store(unsigned char* at, const Rgba& color) const;

    const Layout& layout_;
    unsigned char* buffer_ = nullptr;
    GLenum type_ = GL_UNSIGNED_BYTE;
    bool is_used_ = false;
    bool is_outdated_ = true;  ///< even if nothing was drawn
    int row_length_ = 0;
    bool y_up_ = true;
    std::vector<std::uint32_t> depths_;
    std::vector<std::uint32_t> packed_;  ///< the picture, as it is copied to memory
};

void Memory::store(unsigned char* at, const Rgba& color) const {
    const int bits = profile().color_bits;
    if (layout_.format == OSMESA_RGB_565) {
        const auto word = static_cast<std::uint16_t>(rescale(color[0], bits, 5) << 11 |
                                                     rescale(color[1], bits, 6) << 5 |
                                                     rescale(color[2], bits, 5));
        std::memcpy(at, &word, sizeof word);
        return;
    }
    const std::size_t size = component_size(type_);
    for (std::size_t i = 0; i < 4; ++i) {
        if (layout_.place[i] < 0) continue;
        unsigned char* const to = at + std::size_t(layout_.place[i]) * size;
        const auto byte = static_cast<std::uint8_t>(rescale(color[i], bits, 8));
        const auto word = static_cast<std::uint16_t>(rescale(color[i], bits, 16));
        const float number = float(color[i]) / float(max_of_bits(bits));
        if (type_ == GL_UNSIGNED_BYTE) std::memcpy(to, &byte, sizeof byte);
        if (type_ == GL_UNSIGNED_SHORT) std::memcpy(to, &word, sizeof word);
        if (type_ == GL_FLOAT) std::memcpy(to, &number, sizeof number);
    }
}

void Memory::present() {
    if (!is_used_) return;
    is_outdated_ |= take_front_changed();
    if (!is_outdated_) return;
    copy_picture();
    is_outdated_ = false;
}

void Memory::copy_picture() {
    const bool is_packed = layout_.format == OSMESA_RGBA && type_ == GL_UNSIGNED_BYTE &&
                           profile().color_bits == 8 && std::endian::native == std::endian::little;
    const Rect all{0, 0, width(), height()};
    Readback read;
    packed_.resize(is_packed ? all.area() : 0);
    if (is_packed)
        read_packed(gw::ReadBuffer::Front, all, Cause::Shown, packed_);
    else
        read = read_colors(gw::ReadBuffer::Front, all, Cause::Shown);
    const std::size_t pixel = std::size_t(layout_.size) * component_size(type_);
    for (int y = 0; y < height(); ++y) {
        const int row = y_up_ ? y : height() - 1 - y;
        unsigned char* at = buffer_ + std::size_t(row) * std::size_t(row_length()) * pixel;
        if (is_packed) {
            std::memcpy(at, &packed_[pixel_index(0, y, width())], 4 * std::size_t(width()));
            continue;
        }
        for (int x = 0; x < width(); ++x, at += pixel)
            store(at, read.color[pixel_index(x, y, width())]);
    }
}

std::vector<std::uint32_t>& Memory::depths() {
    const Readback read = Drawable::read(Plane::Depth, {0, 0, width(), height()}, Cause::Read);
    depths_.assign(read.values.begin(), read.values.end());
    return depths_;
}

}  // namespace

namespace {
std::atomic<int> osmesa_count = 0;
}

struct osmesa_context {
    osmesa_context(const Layout& of, std::shared_ptr<Shared> with)
        : name("osmesa " + std::to_string(++osmesa_count)),
          layout(of),
          context(settings().profile, std::move(with)) {}

    std::string name;  ///< of its memory, in recordings
    const Layout& layout;
    Context context;
    std::unique_ptr<Memory> memory;
    int row_length = 0;
    bool y_up = true;
};

namespace {

thread_local osmesa_context* current_osmesa = nullptr;

OSMesaContext make_context(GLenum format, OSMesaContext sharelist) {
    const Layout* const layout = layout_of(format);
    if (layout == nullptr) return nullptr;
    return at_c_boundary([&] {
        start_recording();
        return new osmesa_context(*layout, sharelist ? sharelist->context.shared : nullptr);
    });
}

/// The thread has no context any more. Draws what its former context has left, for later.
void leave_current() {
    if (current_osmesa != nullptr) current_osmesa->memory->leave_memory();
    make_current(nullptr, nullptr);
    current_osmesa = nullptr;
}

bool fits(int depth_bits, int stencil_bits, int accum_bits) {
    const auto is_in = [](int bits, int most) { return bits >= 0 && bits <= most; };
    return is_in(depth_bits, 32) && is_in(stencil_bits, 8) && is_in(accum_bits, 32);
}

/// The attributes of a list that ends with 0, by name; those that are not there have their defaults.
/// None if the list has other names.
std::optional<std::map<int, int>> attributes_of(const int* list) {
    std::map<int, int> out{{OSMESA_FORMAT, OSMESA_RGBA},
                           {OSMESA_DEPTH_BITS, 0},
                           {OSMESA_STENCIL_BITS, 0},
                           {OSMESA_ACCUM_BITS, 0},
                           {OSMESA_PROFILE, OSMESA_COMPAT_PROFILE},
                           {OSMESA_CONTEXT_MAJOR_VERSION, 1},
                           {OSMESA_CONTEXT_MINOR_VERSION, 0}};
    for (; list != nullptr && list[0] != 0; list += 2) {
        const auto at = out.find(list[0]);
        if (at == out.end()) return std::nullopt;
        at->second = list[1];
    }
    return out;
}

/// OSMesa's functions by name.
OSMESAproc own_function(std::string_view name) {
    static const std::map<std::string_view, OSMESAproc> all{
#define GW_FUNCTION(name) {#name, reinterpret_cast<OSMESAproc>(&name)}
        GW_FUNCTION(OSMesaCreateContext),  GW_FUNCTION(OSMesaCreateContextExt),
        GW_FUNCTION(OSMesaDestroyContext), GW_FUNCTION(OSMesaCreateContextAttribs),
        GW_FUNCTION(OSMesaMakeCurrent),    GW_FUNCTION(OSMesaGetCurrentContext),
        GW_FUNCTION(OSMesaPixelStore),     GW_FUNCTION(OSMesaGetIntegerv),
        GW_FUNCTION(OSMesaGetDepthBuffer), GW_FUNCTION(OSMesaGetColorBuffer),
        GW_FUNCTION(OSMesaGetProcAddress), GW_FUNCTION(OSMesaColorClamp),
        GW_FUNCTION(OSMesaPostprocess),
#undef GW_FUNCTION
    };
    const auto found = all.find(name);
    return found == all.end() ? nullptr : found->second;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist) {
    return make_context(format, sharelist);
}

OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits,
                                                GLint accum_bits, OSMesaContext sharelist) {
    if (!fits(depth_bits, stencil_bits, accum_bits)) return nullptr;
    return make_context(format, sharelist);
}

OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int* attributes,
                                                    OSMesaContext sharelist) {
    auto given = attributes_of(attributes);
    if (!given) return nullptr;
    auto& of = *given;
    const int major = of[OSMESA_CONTEXT_MAJOR_VERSION], minor = of[OSMESA_CONTEXT_MINOR_VERSION];
    if (major > 1 || minor > offered_minor() || of[OSMESA_PROFILE] != OSMESA_COMPAT_PROFILE) {
        report_refused_context(major, minor);
        return nullptr;
    }
    return OSMesaCreateContextExt(GLenum(of[OSMESA_FORMAT]), of[OSMESA_DEPTH_BITS],
                                  of[OSMESA_STENCIL_BITS], of[OSMESA_ACCUM_BITS], sharelist);
}

void GLAPIENTRY OSMesaDestroyContext(OSMesaContext context) {
    if (context == nullptr) return;
    if (context == current_osmesa) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    delete context;
}

GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext context, void* buffer, GLenum type,
                                       GLsizei width, GLsizei height) {
    if (context == nullptr) {
        leave_current();
        return GL_TRUE;
    }
    if (buffer == nullptr || !is_type_of(context->layout.format, type)) return GL_FALSE;
    return at_c_boundary([&]() -> GLboolean {
        auto& memory = context->memory;
        check_window(width, height);
        if (!memory)
            memory = std::make_unique<Memory>(settings().profile, width, height, context->name,
                                              context->layout);
        leave_current();
        if (memory->width() != width || memory->height() != height) memory->resize(width, height);
        make_current(&context->context, memory.get());
        memory->set_memory(buffer, type);
        memory->set_row_length(context->row_length);
        memory->set_y_up(context->y_up);
        current_osmesa = context;
        return GL_TRUE;
    });
}

OSMesaContext GLAPIENTRY OSMesaGetCurrentContext() { return current_osmesa; }

void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value) {
    osmesa_context* const context = current_osmesa;
    if (context == nullptr) return;
    if (pname == OSMESA_ROW_LENGTH && value >= 0)
        context->memory->set_row_length(context->row_length = value);
    else if (pname == OSMESA_Y_UP)
        context->memory->set_y_up(context->y_up = value != 0);
    else
        set_error(context->context,
                  pname == OSMESA_ROW_LENGTH ? GL_INVALID_VALUE : GL_INVALID_ENUM);
}

void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint* value) {
    osmesa_context* const context = current_osmesa;
    if (context == nullptr || value == nullptr) return;
    const Memory& memory = *context->memory;
    switch (pname) {
        case OSMESA_WIDTH: *value = memory.width(); return;
        case OSMESA_HEIGHT: *value = memory.height(); return;
        case OSMESA_FORMAT: *value = GLint(context->layout.format); return;
        case OSMESA_TYPE: *value = GLint(memory.type()); return;
        case OSMESA_ROW_LENGTH: *value = context->row_length; return;
        case OSMESA_Y_UP: *value = context->y_up ? 1 : 0; return;
        case OSMESA_MAX_WIDTH:
        case OSMESA_MAX_HEIGHT: *value = max_window_size; return;
    }
    set_error(context->context, GL_INVALID_ENUM);
}

GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext context, GLint* width, GLint* height,
                                          GLint* bytes_per_value, void** buffer) {
    if (context == nullptr || !context->memory) return GL_FALSE;
    return at_c_boundary([&]() -> GLboolean {
        if (context == current_osmesa) finish_drawing(context->context);
        *width = context->memory->width();
        *height = context->memory->height();
        *bytes_per_value = 4;
        *buffer = context->memory->depths().data();
        return GL_TRUE;
    });
}

GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext context, GLint* width, GLint* height,
                                          GLint* format, void** buffer) {
    if (context == nullptr || !context->memory) return GL_FALSE;
    *width = context->memory->width();
    *height = context->memory->height();
    *format = GLint(context->layout.format);
    *buffer = context->memory->memory();
    return GL_TRUE;
}

OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char* name) {
    if (name == nullptr) return nullptr;
    const OSMESAproc own = own_function(name);
    return own != nullptr ? own : find_entry_point(name);
}

/// Colours of the machine are 0 .. 1 always.
void GLAPIENTRY OSMesaColorClamp(GLboolean) {}

/// The machine has no filters after drawing.
void GLAPIENTRY OSMesaPostprocess(OSMesaContext, const char*, unsigned) {}

}  // extern "C"
#pragma GCC visibility pop
