#include "apps/programs/folder_beside.h"

#include "gw/error.h"

namespace gw::apps {

namespace fs = std::filesystem;

fs::path folder_beside(std::initializer_list<const char*> folders, const char* file) {
    const fs::path root = fs::canonical("/proc/self/exe").parent_path().parent_path();
    for (const char* folder : folders)
        if (fs::exists(root / folder / file)) return root / folder;
    throw Error((root / *folders.begin() / file).string() +
                ": cannot be read: no such file; expected gw's libraries beside the command");
}

}  // namespace gw::apps
