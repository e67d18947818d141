#include "gl/x11/shown_image.h"

#include <X11/extensions/XShm.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <bit>
#include <cstring>
#include <optional>

namespace gw::gl::x11 {

namespace {

/// The table of a channel: its values as bits of `mask`.
std::vector<std::uint32_t> channel_table(std::uint32_t mask, int color_bits) {
    const std::uint64_t largest = (1u << color_bits) - 1;
    const std::uint64_t to = mask >> (mask != 0 ? std::countr_zero(mask) : 0);
    std::vector<std::uint32_t> table(std::size_t(largest) + 1, 0);
    if (mask == 0) return table;
    for (std::uint64_t value = 0; value <= largest; ++value)  // to nearest
        table[value] =
            std::uint32_t((value * to + largest / 2) / largest << std::countr_zero(mask));
    return table;
}

void store_pixel(char* at, std::uint32_t pixel, int bytes, bool lowest_first) {
    for (int i = 0; i < bytes; ++i)
        at[i] = char(pixel >> 8 * (lowest_first ? i : bytes - 1 - i) & 0xFF);
}

bool has_whole_words(const XImage& image) {
    const bool lowest_first = image.byte_order == LSBFirst;
    return image.bits_per_pixel == 32 &&
           lowest_first == (std::endian::native == std::endian::little);
}

/// Stores rows, the bottom row last. `pixel_at` gives the pixel of an index into the drawable.
template <class PixelAt>
void store_rows(XImage& image, PixelAt pixel_at) {
    const int bytes = image.bits_per_pixel / 8;
    const bool lowest_first = image.byte_order == LSBFirst, whole_words = has_whole_words(image);
    for (int y = 0; y < image.height; ++y) {
        std::size_t from = pixel_index(0, image.height - 1 - y, image.width);
        char* at = image.data + std::ptrdiff_t(y) * image.bytes_per_line;
        for (int x = 0; x < image.width; ++x, at += bytes) {
            const std::uint32_t pixel = pixel_at(from++);
            if (whole_words)
                std::memcpy(at, &pixel, sizeof pixel);
            else
                store_pixel(at, pixel, bytes, lowest_first);
        }
    }
}

/// Whether the image is rows of whole words, one after the other: its words.
std::optional<std::span<std::uint32_t>> words_of(XImage& image) {
    if (!has_whole_words(image) || image.bytes_per_line != 4 * image.width) return std::nullopt;
    return std::span(reinterpret_cast<std::uint32_t*>(image.data),
                     std::size_t(image.width) * std::size_t(image.height));
}

}  // namespace

PixelFormat::PixelFormat(const XVisualInfo& visual, int color_bits) {
    const std::uint32_t rgb = std::uint32_t(visual.red_mask | visual.green_mask | visual.blue_mask);
    const std::uint32_t rest = visual.depth == 32 ? ~rgb : 0;
    const std::array masks{std::uint32_t(visual.red_mask), std::uint32_t(visual.green_mask),
                           std::uint32_t(visual.blue_mask), rest};
    for (std::size_t i = 0; i < masks.size(); ++i)
        channels_[i] = channel_table(masks[i], color_bits);
    is_bgr_ = color_bits == 8 && masks == std::array{0xFF0000u, 0xFF00u, 0xFFu, 0u};
}

/// The image's memory: shared with the server, or the program's own.
struct ShownImage::Memory {
    Memory(Display* display, const XVisualInfo& visual, int width, int height) {
        if (!share(display, visual, width, height)) allocate(display, visual, width, height);
    }
    ~Memory() {
        if (image != nullptr) XDestroyImage(image);
        if (is_shared) shmdt(segment.shmaddr);
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    XImage* image = nullptr;
    bool is_shared = false;
    XShmSegmentInfo segment{};
    gw::KnownPixels known;

private:
    bool share(Display* display, const XVisualInfo& visual, int width, int height);
    void allocate(Display* display, const XVisualInfo& visual, int width, int height);
};

bool ShownImage::Memory::share(Display* display, const XVisualInfo& visual, int width, int height) {
    if (!XShmQueryExtension(display)) return false;
    XImage* const shared = XShmCreateImage(display, visual.visual, unsigned(visual.depth), ZPixmap,
                                           nullptr, &segment, unsigned(width), unsigned(height));
    if (shared == nullptr) return false;
    const std::size_t size = std::size_t(shared->bytes_per_line) * std::size_t(shared->height);
    segment.shmid = shmget(IPC_PRIVATE, size, IPC_CREAT | 0600);
    segment.shmaddr =
        segment.shmid >= 0 ? static_cast<char*>(shmat(segment.shmid, nullptr, 0)) : nullptr;
    is_shared = segment.shmaddr != nullptr && segment.shmaddr != reinterpret_cast<char*>(-1);
    if (is_shared) {
        // A server on another computer refuses to attach.
        QuietErrors quiet(display);
        XShmAttach(display, &segment);
        if (quiet.failed()) {
            shmdt(segment.shmaddr);
            is_shared = false;
        }
    }
    if (segment.shmid >= 0) shmctl(segment.shmid, IPC_RMID, nullptr);
    shared->data = is_shared ? segment.shmaddr : nullptr;
    if (is_shared)
        image = shared;
    else
        XDestroyImage(shared);
    return is_shared;
}

void ShownImage::Memory::allocate(Display* display, const XVisualInfo& visual, int width,
                                  int height) {
    image = XCreateImage(display, visual.visual, unsigned(visual.depth), ZPixmap, 0, nullptr,
                         unsigned(width), unsigned(height), 32, 0);
    if (image == nullptr) throw std::bad_alloc();
    image->data = static_cast<char*>(
        std::calloc(std::size_t(image->bytes_per_line), std::size_t(image->height)));
    if (image->data == nullptr) throw std::bad_alloc();
}

ShownImage::ShownImage(Display* display, const XVisualInfo& visual, XID target, int height)
    : display_(display), visual_(visual), target_(target), target_height_(height), put_(display) {
    QuietErrors quiet(display);
    gc_ = XCreateGC(display, target, 0, nullptr);
}

void ShownImage::lose_display() {
    if (lost_display_.exchange(true)) return;
    put_.lose_display();
    if (gc_ != nullptr) XFreeGC(display_, gc_);
}

ShownImage::~ShownImage() {
    if (lost_display_) return;
    QuietErrors quiet(display_);
    if (memory_ && memory_->is_shared) XShmDetach(display_, &memory_->segment);
    if (gc_ != nullptr) XFreeGC(display_, gc_);
}

bool ShownImage::has_size(int width, int height) const {
    return memory_ && memory_->image->width == width && memory_->image->height == height;
}

void ShownImage::fit(int width, int height) {
    put_.wait();
    if (has_size(width, height)) return;
    if (memory_ && memory_->is_shared) XShmDetach(display_, &memory_->segment);
    memory_ = nullptr;
    memory_ = std::make_unique<Memory>(display_, visual_, width, height);
}

const PixelFormat& ShownImage::format(int color_bits) {
    if (!format_) format_ = std::make_unique<PixelFormat>(visual_, color_bits);
    return *format_;
}

std::optional<ShownImage::Words> ShownImage::words(int color_bits) {
    const auto words = words_of(*memory_->image);
    if (!words || !format(color_bits).is_bgr()) return std::nullopt;
    return Words{*words, {.top_first = true, .blue_first = true, .known = &memory_->known}};
}

std::optional<ShownImage::Words> ShownImage::shared_words(int width, int height, int color_bits) {
    if (!has_size(width, height) || !memory_->is_shared) return std::nullopt;
    return words(color_bits);
}

void ShownImage::fill(gl::Drawable& drawable, gw::ReadBuffer buffer) {
    const int color_bits = drawable.profile().color_bits;
    const PixelFormat& format = this->format(color_bits);
    XImage& image = *memory_->image;
    const Rect all{0, 0, drawable.width(), drawable.height()};
    if (color_bits > 8) {
        const Readback read = drawable.read_colors(buffer, all, Cause::Shown);
        return store_rows(image, [&](std::size_t i) {
            const Rgba& c = read.color[i];
            return format.pixel(c[0], c[1], c[2], c[3]);
        });
    }
    if (const auto words = this->words(color_bits))
        return drawable.read_packed(buffer, all, Cause::Shown, words->pixels, words->layout);
    packed_.resize(all.area());
    drawable.read_packed(buffer, all, Cause::Shown, packed_);
    store_rows(image, [&](std::size_t i) {
        const std::uint32_t c = packed_[i];
        return format.pixel(c & 0xFF, c >> 8 & 0xFF, c >> 16 & 0xFF, c >> 24);
    });
}

void ShownImage::show(gl::Drawable& drawable, gw::ReadBuffer buffer) {
    fit(drawable.width(), drawable.height());
    fill(drawable, buffer);
    put();
}

void ShownImage::show_packed(std::span<const std::uint32_t> pixels, int width, int height) {
    fit(width, height);
    const PixelFormat& format = this->format(8);
    store_rows(*memory_->image, [&](std::size_t i) {
        const std::uint32_t c = pixels[i];
        return format.pixel(c & 0xFF, c >> 8 & 0xFF, c >> 16 & 0xFF, c >> 24);
    });
    put();
}

void ShownImage::put() {
    const LockedDisplay locked(display_);
    XImage& image = *memory_->image;
    const unsigned width = unsigned(image.width), height = unsigned(image.height);
    const int top = target_height_ - image.height;
    put_.send([&] {
        if (memory_->is_shared)
            XShmPutImage(display_, target_, gc_, &image, 0, 0, 0, top, width, height, False);
        else
            XPutImage(display_, target_, gc_, &image, 0, 0, 0, top, width, height);
    });
}

bool ShownImage::put(OwnConnection& own, int height) const {
    const XImage& image = *memory_->image;
    return own.put({.target = target_,
                    .gc = XGContextFromGC(gc_),
                    .segment = memory_->segment.shmseg,
                    .width = image.width,
                    .height = image.height,
                    .depth = image.depth,
                    .top = height - image.height});
}

}  // namespace gw::gl::x11
