// Where the libraries for programs are: in the build tree or where gw was installed.
#pragma once

#include <filesystem>
#include <initializer_list>

namespace gw::apps {

/// The first of `folders`, beside the command's, that has the file. Throws Error if none has it.
std::filesystem::path folder_beside(std::initializer_list<const char*> folders, const char* file);

}  // namespace gw::apps
