// The index of a folder: the pictures and plots that commands wrote there, with the command of each.
// It is stored in index.json and shown by index.html, plain HTML without network. Does not draw.
#pragma once

#include "apps/command/command.h"
#include "image/output/output_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// A picture or plot, and its caption.
struct Shown {
    std::string file;  ///< from the folder of the index
    std::string label;
    bool operator==(const Shown&) const = default;
};

struct IndexedCommand {
    std::string command;   ///< to be pasted in a shell
    std::string counts;    ///< its counts in a line, "" for none
    std::string counters;  ///< the file with the counts of each pass, "" for none
    bool operator==(const IndexedCommand&) const = default;
};

/// Pictures that belong together, and the commands that made them.
struct IndexEntry {
    std::string name;  ///< of its section
    std::string title, row, text;
    std::vector<Shown> pictures;
    std::vector<std::string> files;  ///< all others: numbers, logs, exact values
    std::string page;                ///< a page that shows more, "" for none
    std::vector<IndexedCommand> commands;
    bool operator==(const IndexEntry&) const = default;
};

/// Creates a folder at once; it stays if a later step fails.
void make_folder(const std::filesystem::path& folder);

using FolderIndex = std::vector<IndexEntry>;

inline constexpr const char* index_file = "index.json";

/// Empty if the folder has none. Throws Error "index.json: what" if it is damaged.
FolderIndex read_index(const std::filesystem::path& folder);
std::string to_json(const FolderIndex& index);

/// Adds an entry, or replaces the entry of the same commands, which keeps its other files. A file
/// belongs to the entry that wrote it last. An entry whose last file went to another is removed.
void add_entry(FolderIndex& index, IndexEntry entry);

/// An entry for files in a folder: pictures are shown, all other files are named.
IndexEntry entry_of(const std::vector<std::filesystem::path>& files,
                    const std::filesystem::path& folder);

/// Gives the entry the command with these words and a title: "gw maps rings.gwt".
void caption(IndexEntry& entry, const std::vector<std::string>& words);

/// Adds the files that `output` is about to write to the folder's index.json and index.html, as the
/// work of the session's command. Keeps an index.html that gw did not write, and writes neither if
/// index.json is not gw's: the pictures matter more than their index. Does nothing in an inner
/// session: the outer command describes its output itself.
void put_index(image::OutputSet& output, const std::filesystem::path& folder,
               const Session& session);

struct PageWords {
    std::string title, text;
};
/// The words of the page of any folder.
PageWords page_of_folder(const std::filesystem::path& folder);

/// A section for each entry, with its pictures, and the commands as captions.
std::string index_page(const FolderIndex& index, const PageWords& words);

/// True if index_page made the file: it may be replaced.
bool is_index_page(const std::filesystem::path& file);

}  // namespace gw::apps
