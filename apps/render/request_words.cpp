#include "apps/render/request_words.h"

#include "inspect/recording/content.h"
#include "render/options.h"
#include "scene/text/text_file.h"

namespace gw::apps {
namespace {

/// Machines give the same bits, with any number of threads. The size stands apart.
bool changes_pixels(const std::string& option) {
    return option != "threads" && option != "machine" && option != "size";
}

}  // namespace

std::string digest_of_files(const std::vector<std::filesystem::path>& files) {
    std::string all;
    for (const std::filesystem::path& file : files) {
        const std::string bytes = scene::read_bytes(file);
        all += to_string(inspect::digest_of_bytes(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
    }
    return to_string(
        inspect::digest_of_bytes({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()}));
}

std::vector<std::pair<std::string, std::string>> words_of(const render::Request& request) {
    std::vector<std::pair<std::string, std::string>> words;
    for (const render::Option& option : render::options()) {
        const std::string word = option.word(request);
        if (word.empty() || !changes_pixels(option.name)) continue;
        // A file's content is in the scene's digest; its folder differs from machine to machine.
        const bool is_file = option.name == "profile" && render::is_profile_file(word);
        words.push_back({option.name, is_file ? "of a file" : word});
    }
    return words;
}

}  // namespace gw::apps
