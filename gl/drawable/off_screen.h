// The machine of a share group's framebuffer objects. Its surfaces hold the planes of renderbuffers and
// texture images. A framebuffer draws to one surface that holds all its planes; a plane whose
// framebuffers need it elsewhere is moved by a Blit. Nothing shows its window of one pixel.
#pragma once

#include "gl/drawable/drawable.h"
#include "gw/planes.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gw::gl {

class OffScreen;

/// The planes of an image that can be attached to a framebuffer. They are 0 at first.
struct SurfaceImage {
    /// `kind`: sides, depth_bits and samples of its surfaces.
    SurfaceImage(std::shared_ptr<OffScreen> on, const Surface& kind, bool is_opaque);
    ~SurfaceImage();
    SurfaceImage(const SurfaceImage&) = delete;
    SurfaceImage& operator=(const SurfaceImage&) = delete;

    std::uint32_t surface(Plane plane) const { return surfaces[std::size_t(plane)]; }

    std::shared_ptr<OffScreen> machine;
    int width, height;
    int depth_bits, samples;
    bool is_opaque;                           ///< alpha is 1 everywhere
    std::array<std::uint32_t, 3> surfaces{};  ///< of Color, Depth, Stencil; 0: on none yet
};
using SurfaceImageRef = std::shared_ptr<SurfaceImage>;

/// A plane of an image.
struct ImagePlane {
    SurfaceImage* image = nullptr;
    Plane plane = Plane::Color;
};

class OffScreen : public Drawable {
public:
    explicit OffScreen(const Profile& profile);
    bool is_off_screen() const override { return true; }

    /// Brings the planes, one of each kind at most, to one surface. Its sides are the largest ones.
    /// Throws std::bad_alloc if there is no surface left.
    std::uint32_t gather(std::span<const ImagePlane> planes);
    /// The surface that has the plane. If `alone`, it has the image's size, and no framebuffer draws to
    /// it at this moment.
    std::uint32_t surface_of(const ImagePlane& plane, bool alone);
    /// The commands that follow draw to this surface and read from it.
    void use(std::uint32_t surface);
    std::uint32_t in_use() const { return in_use_; }
    /// Values for a whole plane: colours, or depths and stencil values.
    void write(const ImagePlane& plane, std::vector<Rgba> colors,
               std::vector<std::uint32_t> values);
    /// The values of a surface, without its samples.
    void write_from(const ImagePlane& plane, std::uint32_t surface);
    /// A whole plane.
    Readback read_plane(const ImagePlane& plane, Cause cause);

    /// Whether a framebuffer might find no surface any more.
    bool is_full();

    /// The surfaces that were made, by number from 1; those with sides of 0 are gone.
    const std::vector<Surface>& surfaces() const { return surfaces_; }
    /// All values of a surface, for no frame: of a pixel with samples, their mean and the first one's
    /// depth and stencil value. Precondition: a state is set, and the frame has no commands. Throws
    /// std::bad_alloc if no surface is left for them.
    std::vector<Readback> read_surface(std::uint32_t number);

private:
    friend struct SurfaceImage;
    bool suits(std::uint32_t number, std::span<const ImagePlane> planes, int width,
               int height) const;
    /// Throws std::bad_alloc if there is none.
    std::uint32_t free_number() const;
    std::uint32_t make(std::span<const ImagePlane> planes, int width, int height);
    void move(const ImagePlane& plane, std::uint32_t to);
    void leave(const ImagePlane& plane);
    /// Commands that prepare planes have no other state than this.
    void use_plainly(std::uint32_t surface);
    void end_unused();

    /// By number from 1: what was made, and whose planes it holds.
    std::vector<Surface> surfaces_;
    std::vector<std::array<const SurfaceImage*, 3>> owners_;
    std::vector<std::uint32_t> unused_;  ///< surfaces without owners that the machine still has
    std::size_t made_ = 0;               ///< those that are there
    std::uint32_t in_use_ = 0;
};

}  // namespace gw::gl
