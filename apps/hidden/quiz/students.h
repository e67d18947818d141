// The students of a class, each with a quiz of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

struct Student {
    std::string name;    ///< may be empty
    std::string folder;  ///< "01_Mori": no two are the same, and none leads elsewhere
    int seed = 1;
};

/// From a number, "30", or a CSV file with a line "name" or "name,seed" for each student; a first
/// line "name" or "name,seed" is a heading. Without a seed, students get `seed`, `seed` + 1, ...
/// Throws UsageError for a wrong number, Error with the file's line otherwise.
std::vector<Student> students_from(const std::string& word, int seed);

}  // namespace gw::apps
