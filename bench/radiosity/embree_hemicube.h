// A hemicube gathered by Embree 3: one ray for each pixel, whose delta form factor goes to the texel
// that the ray meets, as in Fig. 3a. One thread. Does not measure.
#pragma once

#include "radiosity/hemicube/hemicube.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gw::bench {

class EmbreeHemicube {
public:
    EmbreeHemicube(const radiosity::PixmapModel& model, int size);
    ~EmbreeHemicube();
    EmbreeHemicube(const EmbreeHemicube&) = delete;
    EmbreeHemicube& operator=(const EmbreeHemicube&) = delete;

    void gather(const radiosity::Hemicube& hemicube);
    /// Of the last hemicube: by texel.
    const std::vector<double>& factors() const;
    /// Of the last hemicube: the facet of each pixel + 1, or 0; in the order of IdBuffers.
    const std::vector<std::uint32_t>& ids() const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace gw::bench
