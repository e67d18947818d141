#include "apps/hidden/quiz/students.h"

#include "apps/command/option_values.h"
#include "gw/error.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace gw::apps {
namespace {

constexpr int most_students = 999, most_seed = 2147483647;

std::string trimmed(const std::string& text, const char* of = " \t\r\"") {
    const auto first = text.find_first_not_of(of), last = text.find_last_not_of(of);
    return first == text.npos ? "" : text.substr(first, last - first + 1);
}

/// Quotes stay.
std::string without_space(const std::string& text) { return trimmed(text, " \t\r"); }

/// Letters, digits and all beyond ASCII stay.
std::string folder_of(std::size_t number, const std::string& name) {
    std::string folder = fmt::format("{:02}", number);
    if (!name.empty()) folder += "_";
    for (const char c : name.substr(0, 60)) {
        const bool stays = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c < 0;
        folder += stays ? c : '_';
    }
    return folder;
}

int seed_from(const std::string& file, int line, const std::string& text) {
    int seed = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc() || end != text.data() + text.size() || seed < 0)
        throw Error(file, line,
                    fmt::format("seed '{}'; expected a whole number, 0..{}", scene::printable(text),
                                most_seed));
    return seed;
}

Student student_of(std::size_t number, const std::string& name, int seed) {
    return {name, folder_of(number, name), seed};
}

int seed_after(int seed, std::size_t number) {
    return int((std::int64_t(seed) + std::int64_t(number)) % (std::int64_t(most_seed) + 1));
}

std::vector<Student> read_students(const std::string& file, int seed) {
    std::istringstream lines(scene::read_text(file));
    std::vector<Student> students;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string text = without_space(line);
        if (text.empty() || (number == 1 && (text == "name" || text == "name,seed"))) continue;
        const auto quoted = text.front() == '"' ? text.find('"', 1) : text.npos;
        const auto comma = quoted == text.npos ? text.rfind(',') : text.find(',', quoted);
        const std::string name = trimmed(text.substr(0, comma));
        if (name.empty()) throw Error(file, number, "no name; expected name or name,seed");
        const int own = comma == line.npos
                            ? seed_after(seed, students.size())
                            : seed_from(file, number, trimmed(text.substr(comma + 1)));
        students.push_back(student_of(students.size() + 1, name, own));
        if (int(students.size()) > most_students)
            throw Error(file, number,
                        fmt::format("more than {} students; expected fewer", most_students));
    }
    if (students.empty()) throw Error(file, 0, "names no student; expected a line for each");
    return students;
}

}  // namespace

std::vector<Student> students_from(const std::string& word, int seed) {
    const bool is_number = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
        return std::isdigit(c) != 0 || c == '-' || c == '+';
    });
    if (!is_number) return read_students(word, seed);
    std::vector<Student> students;
    const int count = whole_number_from("--students", word, 1, most_students);
    for (int i = 0; i < count; ++i)
        students.push_back(student_of(std::size_t(i + 1), "", seed_after(seed, std::size_t(i))));
    return students;
}

}  // namespace gw::apps
