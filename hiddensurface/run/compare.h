// An algorithm's picture on a machine, and how it differs from the Z-buffer's. Does not write
// files.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/run/difference.h"

namespace gw::hiddensurface {

struct Result {
    Counts counts;                       ///< of the algorithm, the machine and the comparison
    std::vector<std::uint32_t> ids;      ///< bottom row first
    std::vector<std::uint8_t> writes;    ///< times each pixel was drawn, at most 255
    std::vector<Difference> difference;  ///< as `ids`; empty: not compared
    std::vector<Piece> pieces;
    std::vector<Share> shares;
};

/// Runs the algorithm and executes its list on a machine of the view's size; the pixels are read
/// from it. A second run of the list with the stencil counting gives `writes`.
Result run_on(Machine& machine, const Algorithm& algorithm, const Input& input, StepLog& log);

/// Compares with the Z-buffer's identifiers and counts ties, edges, snapped and wrong pixels in
/// result.counts.
void compare(Result& result, const std::vector<std::uint32_t>& z_buffer, const Input& input);

/// The number of polygons over each pixel, whatever is drawn: what a depth-complexity map shows, at
/// most 255.
std::vector<std::uint8_t> depth_complexity(const Input& input);

}  // namespace gw::hiddensurface
