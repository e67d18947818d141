// Processes of one launch, mpirun's or srun's, that solve radiosity together. They find each other by a
// file in the output folder and talk by TCP. Does not know what they say.
#pragma once

#include "radiosity/solver/rows.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gw::apps {

/// The place of a process among those of its launch.
struct Rank {
    std::size_t number = 0, count = 1;  ///< number from 0
    bool one_machine = true;            ///< all of them are on this machine
};

/// "2/4", or "mpi": what the launcher says in the environment. Throws UsageError with the expected form.
Rank rank_from(const std::string& word);

/// Process 0 waits in `folder` until all others have come; these look for it. `work`: what they are
/// about to do, which must be the same for all. Throws Error if one has other work, or does not come
/// within a minute. Returns null for one process.
std::shared_ptr<radiosity::RowExchange> meet(const Rank& rank, const std::filesystem::path& folder,
                                             const std::string& work);

}  // namespace gw::apps
