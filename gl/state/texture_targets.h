// The targets of calls about images: of one to three dimensions, faces of cubes, proxies. [GL13] 3.8
#pragma once

#include "gl/state/texture_objects.h"

#include <optional>

namespace gw::gl {

/// An image's place: a bound object's level, or a proxy's.
struct ImagePlace {
    std::size_t index = 0;  ///< of the target
    std::size_t face = 0;   ///< of a cube
    bool is_proxy = false;
};

/// None: the profile has no such target. A cube is named by its faces.
inline std::optional<ImagePlace> place_of(const Profile& profile, GLenum target) {
    const auto place = [&]() -> std::optional<ImagePlace> {
        switch (target) {
            case GL_TEXTURE_1D: return ImagePlace{one_dimension};
            case GL_TEXTURE_2D: return ImagePlace{two_dimensions};
            case GL_TEXTURE_RECTANGLE: return ImagePlace{rectangular};
            case GL_TEXTURE_3D: return ImagePlace{three_dimensions};
            case GL_PROXY_TEXTURE_1D: return ImagePlace{one_dimension, 0, true};
            case GL_PROXY_TEXTURE_2D: return ImagePlace{two_dimensions, 0, true};
            case GL_PROXY_TEXTURE_RECTANGLE: return ImagePlace{rectangular, 0, true};
            case GL_PROXY_TEXTURE_3D: return ImagePlace{three_dimensions, 0, true};
            case GL_PROXY_TEXTURE_CUBE_MAP: return ImagePlace{cube, 0, true};
        }
        const std::size_t face = target - GL_TEXTURE_CUBE_MAP_POSITIVE_X;  // large for others
        return face < 6 ? std::optional(ImagePlace{cube, face}) : std::nullopt;
    }();
    return place && has_target(profile, place->index) ? place : std::nullopt;
}

/// The dimensions of a target's images.
inline int dimensions_of(const ImagePlace& place) {
    return place.index == one_dimension ? 1 : place.index == three_dimensions ? 3 : 2;
}

}  // namespace gw::gl
