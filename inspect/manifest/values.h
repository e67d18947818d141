// The values of all planes after every pass, as bytes beside a manifest
// (inspect/manifest/values.fbs): a pass stores the pixels that differ from the pass before. Does
// not read or write files.
#pragma once

#include "gw/planes.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gw::inspect {

class ValuesWriter {
public:
    ValuesWriter(int width, int height, int color_planes = 1);
    ~ValuesWriter();
    /// The planes after the next pass.
    void add(const Planes& planes);
    /// Once, after all passes. Throws Error for more than 2 GB.
    std::vector<std::uint8_t> finish();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The planes after pass `pass`, from untrusted bytes. Throws Error if they are
/// damaged, of another size, or hold no such pass.
Planes planes_after(std::span<const std::uint8_t> bytes, int width, int height, std::size_t pass,
                    int color_planes = 1);

}  // namespace gw::inspect
