// The words of options: a table each, for parsing, help and the text of errors.
#pragma once

#include "multipass/frame/options.h"
#include "raytrace/casting/casting.h"
#include "render/words/option_values.h"
#include "scene/words.h"

#include <iterator>
#include <string>
#include <vector>

namespace gw::render {

using scene::Word;

inline constexpr Word<multipass::Translucency> translucency_words[] = {
    {"sorted", multipass::Translucency::Sorted},
    {"unsorted", multipass::Translucency::Unsorted},
    {"layers", multipass::Translucency::Layers}};
/// Whether the mean of the samples is weighted.
inline constexpr Word<bool> averaging_words[] = {{"simple", false}, {"weighted", true}};
/// Whether reflections are traced.
inline constexpr Word<bool> reflection_words[] = {{"rays", true}, {"maps", false}};
/// Whether shadows in reflections are read from shadow maps.
inline constexpr Word<bool> reflected_shadow_words[] = {{"rays", false}, {"maps", true}};

inline constexpr Word<raytrace::CastMethod> cast_method_words[] = {
    {"brute-force", raytrace::CastMethod::BruteForce},
    {"volumes", raytrace::CastMethod::BoundingVolumes},
    {"hierarchy", raytrace::CastMethod::Hierarchy},
    {"grid", raytrace::CastMethod::Grid}};
inline constexpr Word<raytrace::InsideTest> inside_test_words[] = {
    {"crossings", raytrace::InsideTest::Crossings},
    {"products", raytrace::InsideTest::CrossProducts},
    {"angles", raytrace::InsideTest::Angles}};

template <class Table>
std::vector<std::string> words_of(const Table& table) {
    std::vector<std::string> words;
    for (const auto& row : table) words.emplace_back(row.first);
    return words;
}

/// Throws OptionError that lists the table's words if it has no such word.
template <class Table>
auto value_from(const std::string& option, const std::string& word, const Table& table) {
    for (const auto& row : table)
        if (word == row.first) return row.second;
    throw OptionError(option, word, "one of " + listed(words_of(table)));
}

}  // namespace gw::render
