// Words that name values of a scene: a table each, for files and for the options of pictures.
#pragma once

#include "scene/scene.h"

#include <string>
#include <utility>

namespace gw::scene {

template <class Value>
using Word = std::pair<const char*, Value>;

inline constexpr Word<Shadow> shadow_words[] = {
    {"none", Shadow::None}, {"volume", Shadow::Volume}, {"map", Shadow::Map}};

/// The word of a value; the table has every value.
template <class Table, class Value>
std::string word_of(const Table& table, const Value& value) {
    for (const auto& row : table)
        if (row.second == value) return row.first;
    return "";
}

}  // namespace gw::scene
