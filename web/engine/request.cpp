#include "web/engine/request.h"

#include "render/options.h"

namespace gw::lab {
namespace {

using Json = nlohmann::ordered_json;

/// A number as a file has it, a point as "1,2,3".
std::string word_of(const Json& value) {
    if (value.is_string()) return value;
    if (!value.is_array()) return value.dump();
    std::string word;
    for (const Json& element : value) word += (word.empty() ? "" : ",") + word_of(element);
    return word;
}

}  // namespace

render::Request request_of(const Json& options) {
    render::Request request{.threads = 1};
    const render::Request none;
    for (const render::Option& option : render::options()) {
        if (!options.contains(option.name)) continue;
        const std::string word = word_of(options[option.name]);
        if (!word.empty() || !option.word(none).empty()) option.set(request, word);
    }
    render::set(request, "size",
                word_of(options.at("width")) + "x" + word_of(options.at("height")));
    return request;
}

}  // namespace gw::lab
