// gw new-algorithm: writes the file of an own hidden-surface algorithm. CMake finds it at the next
// build and registers it (hiddensurface/CMakeLists.txt). Does not build.
#include "apps/hidden/new_algorithm.h"
#include "apps/command/terminal.h"
#include "gw/error.h"
#include "hiddensurface/interface/line_algorithm.h"
#include "image/write.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string_view>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

/// docs/lecture.md shows it; every `mine` becomes the name.
constexpr std::string_view listing =
    R"listing(// Draws nearest first, and so shows what is farthest.
#include "hiddensurface/interface/algorithm.h"

#include <algorithm>
#include <numeric>

namespace gw::hiddensurface {

Algorithm mine() {  // the function's name is the file's
    return {.name = "mine", .title = "Near to far", .run = [](const Input& input, StepLog& log) {
                Output output{.list = begin_picture(input, "mine")};
                std::vector<std::size_t> order(input.polygons.size());
                std::iota(order.begin(), order.end(), std::size_t{0});
                std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                    output.counts.keys += 1;
                    return input.polygons[a].nearest < input.polygons[b].nearest;
                });
                for (const std::size_t i : order)
                    if (input.polygons[i].visible())
                        draw_piece(input, whole(i, input.polygons[i]), output, log);
                return output;
            }};
}

}  // namespace gw::hiddensurface
)listing";

constexpr std::string_view keywords[] = {
    "alignas",   "alignof",   "and",      "and_eq",   "asm",       "auto",      "bitand",
    "bitor",     "bool",      "break",    "case",     "catch",     "char",      "char8_t",
    "char16_t",  "char32_t",  "class",    "compl",    "concept",   "const",     "consteval",
    "constexpr", "constinit", "continue", "co_await", "co_return", "co_yield",  "decltype",
    "default",   "delete",    "do",       "double",   "else",      "enum",      "explicit",
    "export",    "extern",    "false",    "float",    "for",       "friend",    "goto",
    "if",        "inline",    "int",      "long",     "mutable",   "namespace", "new",
    "noexcept",  "not",       "not_eq",   "nullptr",  "operator",  "or",        "or_eq",
    "private",   "protected", "public",   "register", "requires",  "return",    "short",
    "signed",    "sizeof",    "static",   "struct",   "switch",    "template",  "this",
    "throw",     "true",      "try",      "typedef",  "typeid",    "typename",  "union",
    "unsigned",  "using",     "virtual",  "void",     "volatile",  "wchar_t",   "while",
    "xor",       "xor_eq"};

/// Of the headers that the listing includes, each between blanks.
constexpr std::string_view macros =
    " alloca assert assert_perror be16toh be32toh be64toh errno htobe16 htobe32 htobe64 htole16 htole32 "
    "htole64 issubnormal le16toh le32toh le64toh math_errhandling offsetof pthread_cleanup_pop "
    "pthread_cleanup_pop_restore_np pthread_cleanup_push pthread_cleanup_push_defer_np "
    "sched_priority stderr stdin stdout ";

/// The functions of the project's own algorithms; `algorithms` makes the table of all.
bool is_taken(const std::string& name) {
    std::vector<std::string> taken = hs::algorithm_names();
    for (const hs::LineAlgorithm& algorithm : hs::line_algorithms())
        taken.push_back(algorithm.name);
    for (std::string& known : taken) std::replace(known.begin(), known.end(), '-', '_');
    taken.insert(taken.end(), {"algorithms", "painter"});
    return std::find(taken.begin(), taken.end(), name) != taken.end();
}

/// The name is a file's and a function's.
void check_algorithm_name(const std::string& name) {
    constexpr std::size_t longest = 40;
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto is_other = [](char c) { return c == '_' || (c >= '0' && c <= '9'); };
    const bool fits =
        !name.empty() && name.size() <= longest && is_letter(name[0]) &&
        name.find("__") == name.npos &&
        std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_other(c); });
    if (!fits)
        throw UsageError("NAME is '" + scene::printable(name) +
                         "'; expected a function's name in small letters, digits and single _, "
                         "such as my_own, of at most 40 characters");
    if (std::find(std::begin(keywords), std::end(keywords), name) != std::end(keywords))
        throw UsageError("NAME is '" + name + "', a word of C++; expected another name");
    if (macros.find(" " + name + " ") != macros.npos)
        throw UsageError("NAME is '" + name + "', a macro of C's headers; expected another name");
    if (is_taken(name))
        throw UsageError("NAME is '" + name +
                         "', which the project has already; expected another name");
}

std::string listing_for(const std::string& name) {
    constexpr std::string_view word = "mine";
    std::string text;
    std::size_t at = 0;
    for (std::size_t found; (found = listing.find(word, at)) != listing.npos;
         at = found + word.size())
        text += std::string(listing.substr(at, found - at)) + name;
    return text + std::string(listing.substr(at));
}

struct NewAlgorithmOptions {
    std::string name;
    std::filesystem::path folder = "hiddensurface/algorithms";
};

int new_algorithm(const NewAlgorithmOptions& options) {
    check_algorithm_name(options.name);
    if (!std::filesystem::is_directory(options.folder))
        throw Error(options.folder.string() +
                    ": no such folder; expected the repository's root as the current folder, or "
                    "--output FOLDER");
    const std::filesystem::path file = options.folder / (options.name + ".cpp");
    if (scene::file_exists(file))
        throw Error(file.string() + ": exists already; expected a new NAME");
    image::write_file(file, listing_for(options.name));
    print(
        fmt::format("{}\nnext, in the repository's root:\n"
                    "    cmake --preset release && ninja -C build/release gw\n"
                    "    build/release/bin/gw hidden scenes/hidden/cycle.toml --algorithm {} "
                    "--steps {}\n",
                    file.string(), options.name, options.name));
    return Done;
}

}  // namespace

Command add_new_algorithm(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "new-algorithm", "Writes the C++ file of a hidden-surface algorithm of your own");
    const auto options = std::make_shared<NewAlgorithmOptions>();
    command->add_option("NAME", options->name, "Of the algorithm, its function and its file")
        ->required();
    command
        ->add_option("-o,--output", options->folder,
                     "Where the file goes (default hiddensurface/algorithms)")
        ->type_name("FOLDER");
    command->footer("Example:\n  build/release/bin/gw new-algorithm mine --output .");
    return {command, [options](Session&) { return new_algorithm(*options); }};
}

}  // namespace gw::apps
