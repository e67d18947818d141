// Records every list that a command's machines execute. Does not write files.
#pragma once

#include "inspect/recording/recording.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gw {
class Machine;
}

namespace gw::apps {

class CommandRecorder {
public:
    CommandRecorder();
    ~CommandRecorder();
    CommandRecorder(const CommandRecorder&) = delete;
    CommandRecorder& operator=(const CommandRecorder&) = delete;

    /// The machine; every list that it executes is recorded. May be called from any thread; each
    /// machine is used by one thread.
    std::unique_ptr<Machine> add(std::unique_ptr<Machine> machine, int width, int height);
    /// The recordings' parameter sets, by the passes' names.
    void add_parameter_sets(const std::map<std::string, std::string>& sets);

    /// A recording of each machine that executed a list, in the order in which they were added.
    /// `scene` and `renderer` are names for the recordings. Empties the recorder.
    std::vector<inspect::Recording> take(const std::string& scene, const std::string& renderer);

private:
    struct Track;

    std::mutex mutex_;
    std::vector<std::shared_ptr<Track>> tracks_;
    std::vector<inspect::ParameterSet> sets_;
};

/// The machine, added to the recorder; if `recorder` is null, the machine alone.
std::unique_ptr<Machine> recorded(std::unique_ptr<Machine> machine, int width, int height,
                                  CommandRecorder* recorder);

}  // namespace gw::apps
