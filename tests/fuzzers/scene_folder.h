// A folder in memory for readers that take a path. Goes away with the process.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace gw::fuzzers {

class SceneFolder {
public:
    SceneFolder() {
        const bool in_memory = std::filesystem::exists("/dev/shm");
        std::string name = (in_memory ? "/dev/shm" : "/tmp") + std::string("/gw-fuzz-XXXXXX");
        if (!mkdtemp(name.data())) std::abort();
        path_ = name;
    }
    ~SceneFolder() { std::filesystem::remove_all(path_); }
    SceneFolder(const SceneFolder&) = delete;

    std::filesystem::path write(const std::string& name, std::string_view text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

}  // namespace gw::fuzzers
