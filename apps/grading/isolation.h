// How a student's program is kept from everything but its own files: by bubblewrap, in namespaces of
// its own, or by limits alone for a container that holds one submission. Does not run it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

enum class Isolation { Namespaces, Limits };

/// What a program gets.
struct Allowance {
    Isolation isolation = Isolation::Namespaces;
    int seconds = 10;                           ///< of the processor, for each process
    std::size_t memory = std::size_t{1} << 30;  ///< bytes, of each process too
    std::size_t disk = std::size_t{64} << 20;   ///< bytes of files that it writes
    int processes = 64;                         ///< threads count
    std::vector<std::filesystem::path> tools;   ///< folders that it may read, with bin/ in its path
};

/// A submission to be run.
struct Confined {
    std::filesystem::path submission;  ///< its files
    std::filesystem::path polygons;    ///< a file
    std::filesystem::path work;        ///< Limits: an empty folder for it
    /// A shell's, in a copy of the files; "$1" and "$2" are `file` and the polygons.
    std::string script;
    std::string file;
    int slot = 0;  ///< programs that run at one time have different ones
};

/// The words of a program that runs it. As root it becomes user 61000 + slot.
std::vector<std::string> confined_words(const Allowance& allowance, const Confined& confined);

/// Whether a student's program finds another of this name.
bool has_program(const Allowance& allowance, const std::string& name);

/// Limits: ends what a program of this slot has left. In namespaces nothing can be left.
void end_leftovers(const Allowance& allowance, int slot);

/// Throws Error if this computer cannot isolate a program so; it says what to do.
void check_isolation(const Allowance& allowance);

}  // namespace gw::apps
