// "gw: drawing, 3 s" on a terminal while something takes longer than a second; nothing elsewhere.
// Does not know how much is left: a machine executes a list as a whole.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace gw::apps {

class Progress {
public:
    /// Silent where `quiet` or where stderr is no terminal.
    Progress(std::string what, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Shown from now on: "frame 3 of 36".
    void at(std::string what);

private:
    void show();

    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false;
    std::string what_;
    std::thread thread_;
};

}  // namespace gw::apps
