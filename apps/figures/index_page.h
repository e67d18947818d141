// A folder's index as a page: plain HTML that needs no network. Does not know what commands write.
#pragma once

#include "apps/figures/folder_index.h"

namespace gw::apps {

struct PageWords {
    std::string title, text;
};
/// Of a folder that commands wrote into.
PageWords page_of_folder(const std::filesystem::path& folder);

/// A section for each entry, with its pictures, and the commands as captions.
std::string index_page(const FolderIndex& index, const PageWords& words);

/// The page was made by index_page: it may be replaced.
bool is_index_page(const std::filesystem::path& file);

}  // namespace gw::apps
