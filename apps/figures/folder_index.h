// What commands wrote into a folder: pictures and plots with the command that made each. Kept in
// the folder's index.json; index_page.h shows it. Does not draw.
#pragma once

#include "apps/command/session.h"
#include "image/output/output_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// A picture or plot, and what is said under it.
struct Shown {
    std::string file;  ///< from the folder of the index
    std::string label;
    bool operator==(const Shown&) const = default;
};

struct IndexedCommand {
    std::string command;   ///< to be pasted in a shell
    std::string counts;    ///< what it counted, "" for nothing
    std::string counters;  ///< the file with these counts pass by pass, "" for none
    bool operator==(const IndexedCommand&) const = default;
};

/// Pictures that belong together, and the commands that made them.
struct IndexEntry {
    std::string name;  ///< of its section
    std::string title, row, text;
    std::vector<Shown> pictures;
    std::vector<std::string> files;  ///< others: numbers, logs, exact values
    std::string page;                ///< a page of its own that shows more, "" for none
    std::vector<IndexedCommand> commands;
    bool operator==(const IndexEntry&) const = default;
};

/// Creates a folder at once; it stays if a later step fails.
void make_folder(const std::filesystem::path& folder);

using FolderIndex = std::vector<IndexEntry>;

inline constexpr const char* index_file = "index.json";

/// Empty where the folder has none. Throws Error "index.json: what" where it is damaged.
FolderIndex read_index(const std::filesystem::path& folder);
std::string to_json(const FolderIndex& index);

/// A file belongs to the entry that wrote it last: from the others it is taken, and an entry that
/// has none any more goes away. An entry of the same commands is replaced where it stands but keeps
/// its other files.
void add_entry(FolderIndex& index, IndexEntry entry);

/// Of files in a folder: what can be looked at is shown, the rest is named.
IndexEntry entry_of(const std::vector<std::filesystem::path>& files,
                    const std::filesystem::path& folder);

/// Of the command with these words, and named after it: "gw maps rings.gwt".
void caption(IndexEntry& entry, const std::vector<std::string>& words);

/// Adds to the folder's index.json and index.html what `output` is about to write there, as the
/// work of the session's command. An index.html of another kind stays, and the folder is left alone
/// where its index.json is of another kind: what was drawn is worth more than its index. Does
/// nothing in an inner session: the outer command describes its output itself.
void put_index(image::OutputSet& output, const std::filesystem::path& folder,
               const Session& session);

}  // namespace gw::apps
