// The words of the step logs: for each test and result a sentence in English and Japanese, once for
// the command and the pages (step_words.json). Does not translate values.
#pragma once

#include "hiddensurface/run/step_json.h"

#include <string_view>

namespace gw::hiddensurface {

/// step_words.json as it is.
std::string_view step_words();

std::string_view embedded_words(std::string_view name);  ///< written by CMake

/// The step's sentence, "en" or "ja", made from its values; without words: its test and result.
/// Throws Error if the step lacks a value.
std::string sentence_of(const Step& step, const PictureGrid& grid, const std::string& language);

}  // namespace gw::hiddensurface
